import { add, subtract, scaled, dot, cross, length, times, transposedTimes } from './linear.js';
import { shapeNames } from './tree.js';
import { outlined } from './painter.js';
import { worth } from './query.js';

// The objects to draw: volumes, triangles and lines of each column.
export class Content {
  // Of levels, by column and body, as long as nothing changes.
  /** @type {Map<string, VolumeGroup[]>} */
  groups = new Map();
  // Of one frame, to be released.
  /** @type {Upload[]} */
  made = [];
  // From loadMeshes(), per mesh.
  /** @type {{ positions: Float32Array, indices: Uint32Array }[]} */
  arrays = [];
  /** @type {Upload[]} */
  uploaded = [];
  /** @type {Promise<void> | null} */
  loading = null;

  /** @param {App} app */
  constructor(app) {
    this.app = app;
  }

  // Unpacks the needed blocks. Returns a promise of the objects of each column.
  /** @returns {Promise<Scenes>} */
  async prepare() {
    const { app } = this, { state } = app, number = app.manifest.frames[state.at], { pair } = state;
    // The leaves of a pair of triangles, for the panel.
    const leaves = pair && await Promise.all([0, 1].map((side) => app.leafOf(pair[2], side, pair[side])));
    return Object.assign(await this.scenesOf(number), { leaves });
  }

  /**
   * @param {number} number
   * @returns {Promise<Scene[]>}
   */
  async scenesOf(number) {
    const { app } = this, { columns, state } = app;
    if (state.mode === 'levels') {
      /** @type {Promise<void>[]} */
      const needed = columns.flatMap((column, k) => column.bodies.map((_, b) => column.bodies[b].tree.load(Math.max(app.levelOf(b), this.selectedLevel(k)))));
      if (state.mesh || state.edges) needed.push(this.loadMeshes());
      await Promise.all(needed);
      // What became of the node that is chosen.
      return Promise.all(columns.map(async ({ query }) => ({ frame: (state.selected || state.pair) && query ? await query.get(number) : null })));
    }
    await this.loadMeshes();
    const frames = await Promise.all(columns.map(({ query }) => query?.get(number) ?? null)), scenes = await Promise.all(columns.map((column, k) => this.sceneOf(k, frames)));
    // What stands side by side has one scale.
    const end = Math.max(...scenes.map(({ heat }) => heat?.end ?? 0));
    for (const { heat } of scenes) if (heat) heat.end = end;
    return scenes;
  }

  /** @type {(k: number, frames: (QueryFrame | null)[]) => Promise<Scene>} */
  async sceneOf(k, frames) {
    const { app } = this, { state } = app, { query, bodies } = app.columns[k], frame = frames[k];
    const load = (/** @type {number} */ side, /** @type {number} */ level) => bodies[side].tree.load(Math.max(level, this.selectedLevel(k)));
    await Promise.all(bodies.map((_, side) => load(side, 0)));
    if (!query || !frame) return { frame: null };
    // Later code reads the triangles of leaves without waiting.
    await Promise.all(bodies.map(({ tree }) => tree.openItems()));
    const side = state.isolated ? state.selected?.body ?? 2 : 2, own = side < 2 ? app.selectedSlot(k) : -1, within = own >= 0 ? query.below(frame, side, own) : null;
    if (state.mode === 'pairs') return { frame, ...this.meetingOf(k, frame, own) };
    if (state.mode === 'traversal') {
      const nodes = this.nodesOfTests(k, frames);
      await Promise.all([0, 1].map((side) => load(side, nodes.reduce((most, node) => (node.side === side ? Math.max(most, bodies[side].tree.levelOf(node.slot)) : most), 0))));
      return { frame, nodes, within, steps: await query.steps(frame) };
    }
    if (app.isHeat) return { frame, heat: query.heat(frame, state.mode === 'wasted', bodies.map((body) => (body.mesh === null ? 0 : this.arrays[body.mesh].indices.length / 3)), within) };
    const all = app.classesOf(frame), classes = within ? query.classes(frame, all.of, all.counts.length, within) : all, labels = app.labelsOf(query);
    const found = query.nodesOf(classes, labels.map(({ label }) => !state.hidden.includes(label)), state.focus);
    await Promise.all([0, 1].map((side) => load(side, found.all[side].reduce((most, { slot }) => Math.max(most, bodies[side].tree.levelOf(slot)), 0))));
    // Errors are never left out.
    const keeps = (/** @type {number} */ group) => state.mode === 'verdicts' && group + 1 === worth.wrong;
    return { frame, classes, pairs: this.meetingOf(k, frame, own).pairs, all: found.all[0].length + found.all[1].length, nodes: query.drawn(found, (node) => this.areaOf(k, node), keeps) };
  }

  // The pairs of triangles that meet, and of each side their triangles; of a slot that is isolated those below it.
  /** @type {(k: number, frame: QueryFrame, slot: number) => { pairs: Uint32Array, meeting: Set<number>[] }} */
  meetingOf(k, frame, slot) {
    const body = this.app.state.selected?.body ?? 0, tree = slot >= 0 ? this.app.treeOf(k, body) : null, below = new Set();
    if (tree) for (let at = slot; at < tree.order.length; ++at) if (tree.isBelow(at, slot)) for (const item of tree.itemsOf(at)) below.add(item);
    const pairs = tree ? frame.pairs.filter((_, i) => below.has(frame.pairs[i - (i % 2) + body])) : frame.pairs;
    return { pairs, meeting: [0, 1].map((side) => new Set(pairs.filter((_, i) => i % 2 === side))) };
  }

  /** @param {number} k */
  selectedLevel(k) {
    const { selected } = this.app.state, slot = this.app.selectedSlot(k);
    return selected && slot >= 0 ? this.app.treeOf(k, selected.body).levelOf(slot) : 0;
  }

  // The nodes of the test that is looked at, or of all tests of a cell of the matrix; by one column's query, the others show the same nodes.
  /** @type {(k: number, frames: (QueryFrame | null)[]) => ShownNode[]} */
  nodesOfTests(k, frames) {
    const { app } = this, { state } = app, own = k === state.column || !app.manifest.same_nodes ? k : state.column, frame = frames[own];
    if (!frame) return [];
    /** @type {(side: number, slot: number) => ShownNode} */
    const node = (side, slot) => ({ side, slot, group: -1, paths: 0 });
    const { cell } = state;
    if (cell) {
      const { trees } = frame.query, most = 2000;
      /** @type {Set<number>[]} */
      const seen = [new Set(), new Set()];
      frame.a.forEach((slot, i) => {
        if (slot < 0 || frame.b[i] < 0 || trees[0].levelOf(slot) !== cell[0] || trees[1].levelOf(frame.b[i]) !== cell[1]) return;
        seen[0].add(slot);
        seen[1].add(frame.b[i]);
      });
      return seen.flatMap((slots, side) => [...slots].slice(0, most).map((slot) => node(side, slot)));
    }
    const test = own === state.column ? app.shownTest(frame) : 0;
    return test < 0 || test >= frame.outcomes.length ? [] : [node(0, frame.a[test]), node(1, frame.b[test])].filter(({ slot }) => slot >= 0);
  }

  // Triangles and lines of the frame, and what differs.
  /** @param {Scene[]} scenes */
  upload(scenes) {
    const { app } = this, { state } = app, { painter } = app;
    for (const made of this.made) painter.release(made);
    this.made = [];
    this.groups.clear();
    if (state.mode === 'levels' || state.mode === 'traversal') return;
    const keep = (/** @type {Upload} */ made) => (this.made.push(made), made);
    scenes.forEach((scene, k) => {
      const { bodies } = app.columns[k], { heat, meeting = [], nodes = [], pairs } = scene;
      if (!scene.frame) return;
      const { query } = scene.frame, differing = this.differingTriangles(k);
      scene.parts = bodies.flatMap((body, side) => {
        if (body.mesh === null || state.without.includes(side)) return [];
        const mesh = this.arrays[body.mesh];
        /** @type {{ side: number, differs: boolean, triangles: number[], corners: number[], colors: number[] }[]} */
        const parts = [false, true].map((differs) => ({ side, differs, triangles: [], corners: [], colors: [] }));
        const chosen = state.selected?.body === side && this.app.selectedSlot(k) >= 0 ? state.selected.triangle : state.pair?.[side];
        const put = (/** @type {number} */ triangle, /** @type {Color} */ usual) => {
          const { triangles, corners, colors } = parts[differing?.[side].has(triangle) ? 1 : 0], color = triangle === chosen ? app.theme.text : usual;
          triangles.push(triangle);
          corners.push(...mesh.indices.subarray(3 * triangle, 3 * triangle + 3));
          colors.push(...color);
        };
        if (heat) heat.counts[side].forEach((count, triangle) => put(triangle, app.heatColor(count, heat.end)));
        else if (state.mode === 'pairs') for (const triangle of meeting[side]) put(triangle, body.color);
        else for (const { slot, group } of nodes.filter((node) => node.side === side && this.isTriangle(k, node))) for (const item of query.trees[side].itemsOf(slot)) put(item, app.labelsOf(query)[group][state.theme]);
        return parts.filter(({ triangles }) => triangles.length > 0).map((part) => ({ ...part, mesh: keep(painter.uploadMesh(mesh.positions, Uint32Array.from(part.corners), part.colors)) }));
      });
      const contacts = !pairs || state.mode === 'verdicts' ? [] : this.contactsOf(k, scene.frame, pairs), { pair: chosen } = state;
      const segments = (/** @type {Contact[]} */ contacts) => (contacts.length ? keep(painter.uploadSegments(Float32Array.from(contacts.flatMap(({ line }) => line)))) : null);
      scene.contacts = contacts;
      scene.lines = segments(contacts);
      scene.chosenLine = chosen ? segments(contacts.filter(({ pair }) => pair[0] === chosen[0] && pair[1] === chosen[1])) : null;
    });
  }

  // The pairs of triangles that only this of two columns found; none where nothing is compared.
  /**
   * @param {number} k
   * @returns {number[][]}
   */
  pairsOnlyHere(k) {
    const { app } = this, own = app.scenes[k]?.frame, other = app.scenes[1 - k]?.frame;
    if (!app.compares || !own || !other) return [];
    if (own.onlyPairs?.than === other) return own.onlyPairs.pairs;
    /** @type {number[][]} */
    const only = [];
    for (let i = 0; i < own.pairs.length; i += 2) if (!other.hasPair(own.pairs[i], own.pairs[i + 1])) only.push([own.pairs[i], own.pairs[i + 1]]);
    own.onlyPairs = { than: other, pairs: only };
    return only;
  }

  // Of each side the triangles of these pairs.
  /** @param {number} k */
  differingTriangles(k) {
    if (this.app.state.mode !== 'pairs') return null;
    const only = this.pairsOnlyHere(k);
    return [0, 1].map((side) => new Set(only.map((pair) => pair[side])));
  }

  // Of rejections and verdicts: the nodes that the other of two columns does not show, or, where it has the same volumes, shows otherwise.
  /**
   * @param {number} k
   * @returns {Set<ShownNode>}
   */
  differing(k) {
    const { app } = this, own = app.scenes[k], other = app.scenes[1 - k];
    if (!app.compares || !own.nodes || !other?.nodes || app.state.mode === 'traversal') return new Set();
    if (own.differing) return own.differing;
    const labels = app.columns.map(({ query }) => (query ? app.labelsOf(query) : []).map(({ label }) => label)), alike = String(labels[0]) === String(labels[1]);
    const known = new Map(other.nodes.map(({ side, slot, group }) => [`${side} ${slot}`, group]));
    own.differing = new Set(own.nodes.filter(({ side, slot, group }) => {
      const there = known.get(`${side} ${slot}`);
      return there === undefined || (alike && there !== group);
    }));
    return own.differing;
  }

  // Outlines of most nodes would say nothing.
  /** @param {number} k */
  outlines(k) {
    return 3 * this.differing(k).size <= (this.app.scenes[k].nodes ?? []).length ? this.differing(k) : new Set();
  }

  // The lines in which the pairs of triangles meet, or between their closest points, from the middle of A's tree.
  /** @type {(k: number, frame: QueryFrame, pairs: Uint32Array) => Contact[]} */
  contactsOf(k, { query, lines, pairs: found }, pairs) {
    const { app } = this, { bodies } = app.columns[k], middle = query.trees[0].stored.center, meshes = bodies.flatMap(({ mesh }) => mesh ?? []);
    /** @type {Contact[]} */
    const contacts = [];
    if (lines) {
      const shown = new Set(pairs);
      for (let i = 0; i < found.length; i += 2) {
        const [p, q] = [0, 3].map((at) => subtract([...lines.subarray(3 * i + at, 3 * i + at + 3)], middle));
        if (shown.has(found[i]) && shown.has(found[i + 1])) contacts.push({ pair: [found[i], found[i + 1]], line: [...p, ...q] });
      }
      return contacts;
    }
    if (query.stored.objects || meshes.length < bodies.length) return [];
    const [of_a, of_b] = bodies.map((_, b) => app.poseOf(k, b));
    const corners = (/** @type {number} */ side, /** @type {number} */ triangle) => {
      const { positions, indices } = this.arrays[meshes[side]], { center } = app.manifest.meshes[meshes[side]];
      return [0, 1, 2].map((i) => add(positions.subarray(3 * indices[3 * triangle + i], 3 * indices[3 * triangle + i] + 3), center));
    };
    // In A's frame.
    const across = (/** @type {Vector} */ p) => transposedTimes(of_a.rotation, subtract(add(times(of_b.rotation, p), of_b.translation), of_a.translation));
    for (let i = 0; i < pairs.length; i += 2) {
      const pair = [pairs[i], pairs[i + 1]], line = lineOf(corners(0, pair[0]), corners(1, pair[1]).map(across));
      if (line) contacts.push({ pair, line: [...subtract(line[0], middle), ...subtract(line[1], middle)] });
    }
    return contacts;
  }

  // Of the triangles that are drawn in place of a node; else 0.
  /** @type {(k: number, node: ShownNode) => number} */
  areaOf(k, node) {
    const { mesh, tree } = this.app.columns[k].bodies[node.side];
    if (mesh === null || !this.isTriangle(k, node)) return 0;
    const { positions, indices } = this.arrays[mesh];
    let area = 0;
    for (const triangle of tree.itemsOf(node.slot)) {
      const [p, q, r] = [0, 1, 2].map((i) => positions.subarray(3 * indices[3 * triangle + i], 3 * indices[3 * triangle + i] + 3));
      area += length(cross(subtract(q, p), subtract(r, p))) / 2;
    }
    return area;
  }

  // Whether a node of the rejections is drawn as the triangles of its leaf, which were tested.
  /** @type {(k: number, node: ShownNode) => boolean} */
  isTriangle(k, { side, slot, group }) {
    const { query, bodies } = this.app.columns[k];
    return this.app.state.mode === 'rejections' && query !== null && query.stored.groups[group].triangles && bodies[side].tree.children[slot] === 0 && bodies[side].mesh !== null;
  }

  loadMeshes() {
    const { app } = this;
    this.loading ??= Promise.all(app.manifest.meshes.map(async (mesh) => ({ positions: await app.blocks.get(mesh.positions), indices: await app.blocks.get(mesh.indices) })))
      .then((arrays) => {
        this.arrays = arrays;
        this.uploaded = arrays.map(({ positions, indices }) => app.painter.uploadMesh(positions, indices));
      });
    return this.loading;
  }

  // Instances of volumes in runs of one shape: place, color and id of each. `nodes`: slot, color, opacity of 255, bits of the id.
  /** @type {(k: number, b: number, nodes: PaintedNode[]) => VolumeGroup[]} */
  runs(k, b, nodes) {
    const body = this.app.columns[k].bodies[b], { tree } = body;
    /** @type {number[][]} */
    const byShape = shapeNames.map(() => []);
    for (const { slot, color, opacity, bits } of nodes)
      byShape[tree.volume(slot).shape].push(slot, (color[0] | (color[1] << 8) | (color[2] << 16) | (opacity << 24)) >>> 0, ((body.first_id + tree.order[slot]) | bits) >>> 0);
    return byShape.map((words, shape) => {
      const centers = new Float32Array(words.length);
      for (let i = 0; i < words.length; i += 3) centers.set(tree.volume(words[i]).numbers.subarray(0, 3), i);
      return { tree, body: b, shape, words: Uint32Array.from(words), centers, count: words.length / 3 };
    }).filter(({ shape, count }) => shape > 0 && count > 0);
  }

  // The slots of a body's level, or of the isolated node.
  /** @type {(k: number, b: number) => number[]} */
  coverOf(k, b) {
    const { app } = this, { selected, isolated } = app.state, { tree } = app.columns[k].bodies[b];
    if (app.state.without.includes(b)) return [];
    if (!isolated || !selected) return tree.cover(app.levelOf(b));
    const own = selected.body === b ? app.selectedSlot(k) : -1;
    return own < 0 ? [] : tree.cover(Math.max(app.levelOf(b), tree.levelOf(own)), own);
  }

  // The volumes of a body's level.
  /** @type {(k: number, b: number) => VolumeGroup[]} */
  level(k, b) {
    const { app } = this, key = `${k} ${b}`, { state } = app, { tree } = app.columns[k].bodies[b], known = this.groups.get(key);
    if (known) return known;
    const own = state.selected?.body === b && !state.without.includes(b) ? app.selectedSlot(k) : -1, usual = Math.round(255 * state.opacity);
    const other = app.compares ? app.treeOf(1 - k, b) : null;
    /** @type {PaintedNode[]} */
    const nodes = this.coverOf(k, b).filter((slot) => slot !== own || state.isolated)
      .map((slot) => ({ slot, color: tree.volume(slot).color, opacity: usual, bits: other && otherVolume(tree, other, slot) ? outlined.alone : 0 }));
    if (own >= 0 && !state.isolated) nodes.push({ slot: own, color: app.theme.text, opacity: Math.max(usual, 64), bits: 0 });
    const groups = this.runs(k, b, nodes);
    this.groups.set(key, groups);
    return groups;
  }

  // What a pane of the column shows.
  /** @type {(k: number, eye: Eye) => PaneContent} */
  pane(k, eye) {
    const shining = this.app.state.isolated ? [] : this.chosenVolume(k, 255);
    return { ...(this.app.state.mode === 'levels' ? this.levelPane(k, eye) : this.queryPane(k, eye)), shining };
  }

  /** @type {(k: number, eye: Eye) => Omit<PaneContent, 'shining'>} */
  levelPane(k, eye) {
    const { app } = this, { state, view } = app, { bodies } = app.columns[k], groups = bodies.flatMap((_, b) => this.level(k, b));
    const meshes = !state.mesh && !state.edges ? [] : bodies.flatMap((body, b) => (body.mesh === null || state.without.includes(b) ? [] : [{
      mesh: this.uploaded[body.mesh], color: app.theme.mesh, edges: state.edges, first_id: app.triangleIds[k].whole[b],
      placement: view.placement(app.poseOf(k, b), app.manifest.meshes[body.mesh].center, eye.far),
    }]));
    const opaque = state.opacity >= 1 ? groups : [], translucent = state.opacity > 0 && state.opacity < 1 ? groups : [];
    return { meshes, opaque, translucent, segments: [] };
  }

  /** @type {(k: number, eye: Eye) => Omit<PaneContent, 'shining'>} */
  queryPane(k, eye) {
    const { app } = this, { state, view } = app, { query, bodies } = app.columns[k], scene = app.scenes[k], pairs = state.mode === 'pairs';
    /** @type {DrawnMesh[]} */
    const meshes = [];
    /** @type {DrawnSegments[]} */
    const segments = [];
    const placed = (/** @type {number} */ b, /** @type {Vector} */ center) => view.placement(app.poseOf(k, b), center, eye.far);
    bodies.forEach((body, b) => {
      if (body.mesh === null || state.without.includes(b)) return;
      const placement = placed(b, app.manifest.meshes[body.mesh].center), first_ids = app.triangleIds[k];
      let drawn = 0;
      for (const part of scene.parts ?? []) {
        if (part.side !== b) continue;
        meshes.push({ mesh: part.mesh, color: body.color, placement, first_id: (first_ids.marked[b] + drawn) | (part.differs ? outlined.together : 0), edges: app.isHeat && state.edges, shading: app.isHeat ? 0.5 : 0.3, hatched: state.mode === 'rejections' && b === 1, shine_through: pairs ? 0.45 : 0 });
        drawn += part.triangles.length;
      }
      if (!scene.heat) meshes.push({ mesh: this.uploaded[body.mesh], color: body.dimmed[state.theme], edges: state.edges, placement, first_id: pairs ? first_ids.whole[b] : 0, backdrop: !pairs, fade: pairs ? 0 : 0.5 });
    });
    const meet = query?.stored.groups.find((group) => group.meet);
    const ofLines = placed(0, bodies[0].tree.stored.center);  // see contactsOf
    if (scene.lines) {
      const line = { segments: scene.lines, placement: ofLines };
      if (pairs) segments.push({ ...line, color: app.theme.text, width: 2, on_top: true, dashed: true }, { ...line, color: app.theme.text, width: 3, on_top: false, lift: 3 });
      else if (meet && !state.hidden.includes(meet.label)) segments.push({ ...line, color: meet[state.theme], width: 1.5, on_top: true });
    }
    if (scene.chosenLine) {
      const line = { segments: scene.chosenLine, placement: ofLines, on_top: true };
      segments.push({ ...line, color: app.theme.background, width: 9 }, { ...line, color: app.theme.text, width: 6 });
    }
    const volumes = (scene.nodes ?? []).length === 0 ? [] : [0, 1].filter((b) => !state.without.includes(b)).flatMap((b) => this.runs(k, b, this.nodesShown(k, b)));
    const translucent = state.mode === 'traversal' ? volumes : [];
    const { selected } = state, isDrawn = (scene.nodes ?? []).some((node) => node.side === selected?.body && node.slot === app.selectedSlot(k));
    return { meshes, segments, opaque: state.mode === 'traversal' ? [] : volumes, translucent: [...translucent, ...(isDrawn ? [] : this.chosenVolume(k, 64))] };
  }

  // The node that is chosen.
  /** @type {(k: number, opacity: number) => VolumeGroup[]} */
  chosenVolume(k, opacity) {
    const { app } = this, { selected, without } = app.state, slot = app.selectedSlot(k);
    if (!selected || slot < 0 || selected.triangle !== null || without.includes(selected.body)) return [];
    return this.runs(k, selected.body, [{ slot, color: app.theme.text, opacity, bits: 0 }]);
  }

  // The volumes of one side of a query. Volumes of B are hatched. Volumes of tests have the bodies' colors.
  /** @type {(k: number, b: number) => PaintedNode[]} */
  nodesShown(k, b) {
    const { app } = this, { state } = app, { query, bodies } = app.columns[k], hatched = b === 1 ? 0x80000000 : 0, labels = query ? app.labelsOf(query) : [], nodes = [];
    const own = state.selected?.body === b ? app.selectedSlot(k) : -1, outlines = this.outlines(k);
    for (const node of app.scenes[k].nodes ?? []) {
      if (node.side !== b) continue;
      if (state.mode === 'traversal') nodes.push({ slot: node.slot, color: bodies[b].color, opacity: state.cell ? 60 : 110, bits: hatched });
      else if (!this.isTriangle(k, node)) nodes.push({ slot: node.slot, color: node.slot === own ? app.theme.text : labels[node.group][state.theme], opacity: 255, bits: hatched | (outlines.has(node) ? outlined.alone : 0) });
    }
    return nodes;
  }

  // The number of a triangle of a body that is drawn by itself.
  /** @type {(k: number, b: number, place: number) => number | undefined} */
  markedTriangle(k, b, place) {
    for (const part of this.app.scenes[k].parts ?? []) {
      if (part.side !== b) continue;
      if (place < part.triangles.length) return part.triangles[place];
      place -= part.triangles.length;
    }
    return undefined;
  }
}

// Whether two trees of one structure have another volume at a slot: of one shape, with other numbers.
/** @type {(tree: Tree, other: Tree, slot: number) => boolean} */
function otherVolume(tree, other, slot) {
  if (!other.has(tree.levelOf(slot)) || slot >= other.order.length) return false;
  const a = tree.volume(slot), b = other.volume(slot);
  return a.shape === b.shape && a.numbers.some((x, i) => x !== b.numbers[i]);
}

// The line in which two triangles meet, by its ends; nothing where they lie in one plane.
/** @type {(a: Vector[], b: Vector[]) => Vector[] | null} */
function lineOf(a, b) {
  const normal = (/** @type {Vector[]} */ t) => cross(subtract(t[1], t[0]), subtract(t[2], t[0])), line = cross(normal(a), normal(b));
  // Where the edges of a triangle cross the plane of the other one.
  const crossings = (/** @type {Vector[]} */ t, /** @type {Vector[]} */ plane) => {
    const n = normal(plane), heights = t.map((p) => dot(n, subtract(p, plane[0])));
    /** @type {Vector[]} */
    const points = [];
    for (let i = 0; i < 3; ++i) {
      const k = (i + 1) % 3, [u, v] = [heights[i], heights[k]];
      if (u === 0) points.push(t[i]);
      else if (u * v < 0) points.push(add(t[i], scaled(u / (u - v), subtract(t[k], t[i]))));
    }
    return points.map((point) => ({ at: dot(line, point), point })).sort((x, y) => x.at - y.at);
  };
  const of_a = crossings(a, b), of_b = crossings(b, a);
  if (of_a.length === 0 || of_b.length === 0 || length(line) === 0) return null;
  const from = of_a[0].at > of_b[0].at ? of_a[0] : of_b[0], last_a = of_a[of_a.length - 1], last_b = of_b[of_b.length - 1], to = last_a.at < last_b.at ? last_a : last_b;
  return from.at <= to.at ? [from.point, to.point] : null;
}
