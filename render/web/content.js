import { add, subtract, scaled, dot, cross, length, times, transposedTimes } from './linear.js';
import { shapeNames } from './tree.js';
import { outlined } from './painter.js';
import { worth } from './query.js';

// What there is to draw of what is shown: volumes, triangles and lines of each column.
export class Content {
  constructor(app) {
    this.app = app;
    this.groups = new Map();  // of levels, as long as nothing changes
    this.made = [];           // of one frame, to be released
  }

  // Unpacks what is needed. A promise of what there is of each column.
  async prepare() {
    const { app } = this, { state } = app, number = app.manifest.frames[state.at], { pair } = state;
    // The leaves of a pair of triangles, for the panel.
    const leaves = pair && await Promise.all([0, 1].map((side) => app.leafOf(pair[2], side, pair[side])));
    return Object.assign(await this.scenesOf(number), { leaves });
  }

  async scenesOf(number) {
    const { app } = this, { columns, state } = app;
    if (state.mode === 'levels') {
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

  async sceneOf(k, frames) {
    const { app } = this, { state } = app, { query, bodies } = app.columns[k], frame = frames[k];
    const load = (side, level) => bodies[side].tree.load(Math.max(level, this.selectedLevel(k)));
    await Promise.all(bodies.map((_, side) => load(side, 0)));
    if (!frame) return { frame: null };
    // Whoever asks for numbers of leaves gets them at once.
    await Promise.all(bodies.map(({ tree }) => tree.openItems()));
    const own = state.isolated && state.selected.body < 2 ? app.selectedSlot(k) : -1, within = own >= 0 ? query.below(frame, state.selected.body, own) : null;
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
    const keeps = (group) => state.mode === 'verdicts' && group + 1 === worth.wrong;
    return { frame, classes, pairs: this.meetingOf(k, frame, own).pairs, all: found.all[0].length + found.all[1].length, nodes: query.drawn(found, (node) => this.areaOf(k, node), keeps) };
  }

  // The pairs of triangles that meet, and of each side their triangles; of a slot that is isolated those below it.
  meetingOf(k, frame, slot) {
    const { selected } = this.app.state, tree = slot >= 0 ? this.app.treeOf(k, selected.body) : null, below = new Set();
    if (tree) for (let at = slot; at < tree.order.length; ++at) if (tree.isBelow(at, slot)) for (const item of tree.itemsOf(at)) below.add(item);
    const pairs = tree ? frame.pairs.filter((_, i) => below.has(frame.pairs[i - (i % 2) + selected.body])) : frame.pairs;
    return { pairs, meeting: [0, 1].map((side) => new Set(pairs.filter((_, i) => i % 2 === side))) };
  }

  selectedLevel(k) {
    const { selected } = this.app.state, slot = selected ? this.app.selectedSlot(k) : -1;
    return slot >= 0 ? this.app.treeOf(k, selected.body).levelOf(slot) : 0;
  }

  // The nodes of the test that is looked at, or of all tests of a cell of the matrix; by one column's query, the others show the same nodes.
  nodesOfTests(k, frames) {
    const { app } = this, { state } = app, own = k === state.column || !app.manifest.same_nodes ? k : state.column, frame = frames[own];
    if (!frame) return [];
    if (state.cell) {
      const { trees } = app.columns[own].query, seen = [new Set(), new Set()], most = 2000;
      frame.a.forEach((slot, i) => {
        if (slot < 0 || frame.b[i] < 0 || trees[0].levelOf(slot) !== state.cell[0] || trees[1].levelOf(frame.b[i]) !== state.cell[1]) return;
        seen[0].add(slot);
        seen[1].add(frame.b[i]);
      });
      return seen.flatMap((slots, side) => [...slots].slice(0, most).map((slot) => ({ side, slot })));
    }
    const test = own === state.column ? app.shownTest(frame) : 0;
    return test < 0 || test >= frame.outcomes.length ? [] : [{ side: 0, slot: frame.a[test] }, { side: 1, slot: frame.b[test] }].filter(({ slot }) => slot >= 0);
  }

  // Triangles and lines of the frame, and what differs.
  upload(scenes) {
    const { app } = this, { state } = app, { painter } = app;
    for (const made of this.made) painter.release(made);
    this.made = [];
    this.groups.clear();
    if (state.mode === 'levels' || state.mode === 'traversal') return;
    const keep = (made) => (this.made.push(made), made);
    scenes.forEach((scene, k) => {
      const { query, bodies } = app.columns[k];
      if (!scene.frame) return;
      const differing = this.differingTriangles(k);
      scene.parts = bodies.flatMap((body, side) => {
        const mesh = this.arrays[body.mesh];
        if (!mesh || state.without.includes(side)) return [];
        const parts = [false, true].map((differs) => ({ side, differs, triangles: [], corners: [], colors: [] }));
        const chosen = state.selected?.body === side && this.app.selectedSlot(k) >= 0 ? state.selected.triangle : state.pair?.[side];
        const put = (triangle, usual) => {
          const { triangles, corners, colors } = parts[differing?.[side].has(triangle) ? 1 : 0], color = triangle === chosen ? app.theme.text : usual;
          triangles.push(triangle);
          corners.push(...mesh.indices.subarray(3 * triangle, 3 * triangle + 3));
          colors.push(...color);
        };
        if (scene.heat) scene.heat.counts[side].forEach((count, triangle) => put(triangle, app.heatColor(count, scene.heat.end)));
        else if (state.mode === 'pairs') for (const triangle of scene.meeting[side]) put(triangle, body.color);
        else for (const { slot, group } of scene.nodes.filter((node) => node.side === side && this.isTriangle(k, node))) for (const item of query.trees[side].itemsOf(slot)) put(item, app.labelsOf(query)[group][state.theme]);
        return parts.filter(({ triangles }) => triangles.length > 0).map((part) => ({ ...part, mesh: keep(painter.uploadMesh(mesh.positions, Uint32Array.from(part.corners), part.colors)) }));
      });
      scene.contacts = scene.heat || state.mode === 'verdicts' ? [] : this.contactsOf(k, scene.pairs);
      const segments = (contacts) => (contacts.length ? keep(painter.uploadSegments(Float32Array.from(contacts.flatMap(({ line }) => line)))) : null);
      scene.lines = segments(scene.contacts);
      scene.chosenLine = state.pair ? segments(scene.contacts.filter(({ pair }) => pair[0] === state.pair[0] && pair[1] === state.pair[1])) : null;
    });
  }

  // The pairs of triangles that only this of two columns found; none where nothing is compared.
  pairsOnlyHere(k) {
    const { app } = this, own = app.scenes[k]?.frame, other = app.scenes[1 - k]?.frame;
    if (!app.compares || !own || !other) return [];
    if (own.onlyPairs?.than === other) return own.onlyPairs;
    const only = [];
    for (let i = 0; i < own.pairs.length; i += 2) if (!other.hasPair(own.pairs[i], own.pairs[i + 1])) only.push([own.pairs[i], own.pairs[i + 1]]);
    return (own.onlyPairs = Object.assign(only, { than: other }));
  }

  // Of each side the triangles of these pairs.
  differingTriangles(k) {
    if (this.app.state.mode !== 'pairs') return null;
    const only = this.pairsOnlyHere(k);
    return [0, 1].map((side) => new Set(only.map((pair) => pair[side])));
  }

  // Of rejections and verdicts: the nodes that the other of two columns does not show, or, where it has the same volumes, shows otherwise.
  differing(k) {
    const { app } = this, own = app.scenes[k], other = app.scenes[1 - k];
    if (!app.compares || !own.nodes || !other?.nodes || app.state.mode === 'traversal') return new Set();
    if (own.differing) return own.differing;
    const labels = app.columns.map(({ query }) => app.labelsOf(query).map(({ label }) => label)), alike = String(labels[0]) === String(labels[1]);
    const known = new Map(other.nodes.map(({ side, slot, group }) => [`${side} ${slot}`, group]));
    own.differing = new Set(own.nodes.filter(({ side, slot, group }) => {
      const there = known.get(`${side} ${slot}`);
      return there === undefined || (alike && there !== group);
    }));
    return own.differing;
  }

  // Outlines of most nodes would say nothing.
  outlines(k) {
    return 3 * this.differing(k).size <= (this.app.scenes[k].nodes ?? []).length ? this.differing(k) : new Set();
  }

  // The lines in which the pairs of triangles meet, from the middle of A's tree.
  contactsOf(k, pairs) {
    const { app } = this, { query, bodies } = app.columns[k], middle = query.trees[0].told.center, contacts = [];
    if (query.told.objects || bodies.some((body) => body.mesh === null)) return [];
    const [of_a, of_b] = bodies.map((_, b) => app.poseOf(k, b));
    const corners = (side, triangle) => {
      const { positions, indices } = this.arrays[bodies[side].mesh], { center } = app.manifest.meshes[bodies[side].mesh];
      return [0, 1, 2].map((i) => add(positions.subarray(3 * indices[3 * triangle + i], 3 * indices[3 * triangle + i] + 3), center));
    };
    // In A's frame.
    const across = (p) => transposedTimes(of_a.rotation, subtract(add(times(of_b.rotation, p), of_b.translation), of_a.translation));
    for (let i = 0; i < pairs.length; i += 2) {
      const pair = [pairs[i], pairs[i + 1]], line = lineOf(corners(0, pair[0]), corners(1, pair[1]).map(across));
      if (line) contacts.push({ pair, line: [...subtract(line[0], middle), ...subtract(line[1], middle)] });
    }
    return contacts;
  }

  // Of the triangles that are drawn in place of a node; else 0.
  areaOf(k, node) {
    if (!this.isTriangle(k, node)) return 0;
    const { query, bodies } = this.app.columns[k], { positions, indices } = this.arrays[bodies[node.side].mesh];
    let area = 0;
    for (const triangle of query.trees[node.side].itemsOf(node.slot)) {
      const [p, q, r] = [0, 1, 2].map((i) => positions.subarray(3 * indices[3 * triangle + i], 3 * indices[3 * triangle + i] + 3));
      area += length(cross(subtract(q, p), subtract(r, p))) / 2;
    }
    return area;
  }

  // Whether a node of the rejections is drawn as the triangles of its leaf, which were tested.
  isTriangle(k, { side, slot, group }) {
    const { query, bodies } = this.app.columns[k];
    return this.app.state.mode === 'rejections' && query.told.groups[group].triangles && bodies[side].tree.children[slot] === 0 && bodies[side].mesh !== null;
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
  runs(k, b, nodes) {
    const body = this.app.columns[k].bodies[b], { tree } = body, byShape = shapeNames.map(() => []);
    for (const { slot, color: [red, green, blue], opacity, bits } of nodes)
      byShape[tree.volume(slot).shape].push(slot, (red | (green << 8) | (blue << 16) | (opacity << 24)) >>> 0, ((body.first_id + tree.order[slot]) | bits) >>> 0);
    return byShape.map((words, shape) => {
      const centers = new Float32Array(words.length);
      for (let i = 0; i < words.length; i += 3) centers.set(tree.volume(words[i]).numbers.subarray(0, 3), i);
      return { tree, body: b, shape, words: Uint32Array.from(words), centers, count: words.length / 3 };
    }).filter(({ shape, count }) => shape > 0 && count > 0);
  }

  // The slots of a body's level, or of what is isolated.
  coverOf(k, b) {
    const { app } = this, { selected, isolated } = app.state, { tree } = app.columns[k].bodies[b];
    if (app.state.without.includes(b)) return [];
    if (!isolated || !selected) return tree.cover(app.levelOf(b));
    const own = selected.body === b ? app.selectedSlot(k) : -1;
    return own < 0 ? [] : tree.cover(Math.max(app.levelOf(b), tree.levelOf(own)), own);
  }

  // The volumes of a body's level.
  level(k, b) {
    const { app } = this, key = `${k} ${b}`, { state } = app, { tree } = app.columns[k].bodies[b];
    if (this.groups.has(key)) return this.groups.get(key);
    const own = state.selected?.body === b && !state.without.includes(b) ? app.selectedSlot(k) : -1, usual = Math.round(255 * state.opacity);
    const other = app.compares ? app.treeOf(1 - k, b) : null;
    const nodes = this.coverOf(k, b).filter((slot) => slot !== own || state.isolated)
      .map((slot) => ({ slot, color: tree.volume(slot).color, opacity: usual, bits: other && otherVolume(tree, other, slot) ? outlined.alone : 0 }));
    if (own >= 0 && !state.isolated) nodes.push({ slot: own, color: app.theme.text, opacity: Math.max(usual, 64), bits: 0 });
    const groups = this.runs(k, b, nodes);
    this.groups.set(key, groups);
    return groups;
  }

  // What a pane of the column shows.
  pane(k, eye) {
    return this.app.state.mode === 'levels' ? this.levelPane(k, eye) : this.queryPane(k, eye);
  }

  levelPane(k, eye) {
    const { app } = this, { state, view } = app, { bodies } = app.columns[k], groups = bodies.flatMap((_, b) => this.level(k, b));
    const meshes = !state.mesh && !state.edges ? [] : bodies.flatMap((body, b) => (body.mesh === null || state.without.includes(b) ? [] : [{
      mesh: this.uploaded[body.mesh], color: app.theme.mesh, edges: state.edges, first_id: app.triangleIds[k].whole[b],
      placement: view.placement(app.poseOf(k, b), app.manifest.meshes[body.mesh].center, eye.far),
    }]));
    const opaque = state.opacity >= 1 ? groups : [], translucent = state.opacity > 0 && state.opacity < 1 ? groups : [];
    return { meshes, opaque, translucent, segments: [] };
  }

  queryPane(k, eye) {
    const { app } = this, { state, view } = app, { query, bodies } = app.columns[k], scene = app.scenes[k], pairs = state.mode === 'pairs';
    const meshes = [], segments = [], placed = (b, center) => view.placement(app.poseOf(k, b), center, eye.far);
    bodies.forEach((body, b) => {
      if (body.mesh === null || state.without.includes(b)) return;
      const placement = placed(b, app.manifest.meshes[body.mesh].center), first_ids = app.triangleIds[k];
      let drawn = 0;
      for (const part of scene.parts ?? []) {
        if (part.side !== b) continue;
        meshes.push({ mesh: part.mesh, color: body.color, placement, first_id: (first_ids.marked[b] + drawn) | (part.differs ? outlined.together : 0), edges: app.isHeat && state.edges, shading: app.isHeat ? 0.5 : 0.3, hatched: state.mode === 'rejections' && b === 1 });
        drawn += part.triangles.length;
      }
      if (!scene.heat) meshes.push({ mesh: this.uploaded[body.mesh], color: body.dimmed[state.theme], edges: state.edges, placement, first_id: pairs ? first_ids.whole[b] : 0, backdrop: !pairs, fade: pairs ? 0 : 0.5 });
    });
    const meet = query?.told.groups.find((group) => group.meet);
    if (scene.lines && (pairs || (meet && !state.hidden.includes(meet.label)))) {
      const line = { segments: scene.lines, placement: placed(0, query.trees[0].told.center) };
      if (pairs) segments.push({ ...line, color: app.theme.faint, width: 1.5, on_top: true }, { ...line, color: app.theme.text, width: 3, on_top: false });
      else segments.push({ ...line, color: meet[state.theme], width: 1.5, on_top: true });
    }
    if (scene.chosenLine) {
      const line = { segments: scene.chosenLine, placement: placed(0, query.trees[0].told.center), on_top: true };
      segments.push({ ...line, color: app.theme.background, width: 9 }, { ...line, color: app.theme.text, width: 6 });
    }
    const volumes = (scene.nodes ?? []).length === 0 ? [] : [0, 1].filter((b) => !state.without.includes(b)).flatMap((b) => this.runs(k, b, this.nodesShown(k, b)));
    const translucent = state.mode === 'traversal' ? volumes : [];
    return { meshes, segments, opaque: state.mode === 'traversal' ? [] : volumes, translucent: [...translucent, ...this.chosenVolume(k)] };
  }

  // The node that is chosen, where the query does not draw it.
  chosenVolume(k) {
    const { app } = this, { selected, without } = app.state, slot = selected ? app.selectedSlot(k) : -1;
    if (slot < 0 || selected.triangle !== null || without.includes(selected.body) || (app.scenes[k].nodes ?? []).some((node) => node.side === selected.body && node.slot === slot)) return [];
    return this.runs(k, selected.body, [{ slot, color: app.theme.text, opacity: 64, bits: 0 }]);
  }

  // The volumes of one side of a query, those of B hatched; of tests in the bodies' colors.
  nodesShown(k, b) {
    const { app } = this, { state } = app, { query, bodies } = app.columns[k], hatched = b === 1 ? 0x80000000 : 0, nodes = [];
    const own = state.selected?.body === b ? app.selectedSlot(k) : -1, outlines = this.outlines(k);
    for (const node of app.scenes[k].nodes) {
      if (node.side !== b) continue;
      if (state.mode === 'traversal') nodes.push({ slot: node.slot, color: bodies[b].color, opacity: state.cell ? 60 : 110, bits: hatched });
      else if (!this.isTriangle(k, node)) nodes.push({ slot: node.slot, color: node.slot === own ? app.theme.text : app.labelsOf(query)[node.group][state.theme], opacity: 255, bits: hatched | (outlines.has(node) ? outlined.alone : 0) });
    }
    return nodes;
  }

  // The number of a triangle of a body that is drawn by itself.
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
function otherVolume(tree, other, slot) {
  if (!other.has(tree.levelOf(slot)) || slot >= other.order.length) return false;
  const a = tree.volume(slot), b = other.volume(slot);
  return a.shape === b.shape && a.numbers.some((x, i) => x !== b.numbers[i]);
}

// The line in which two triangles meet, by its ends; nothing where they lie in one plane.
function lineOf(a, b) {
  const normal = (t) => cross(subtract(t[1], t[0]), subtract(t[2], t[0])), line = cross(normal(a), normal(b));
  // Where the edges of a triangle cross the plane of the other one.
  const crossings = (t, plane) => {
    const n = normal(plane), heights = t.map((p) => dot(n, subtract(p, plane[0]))), points = [];
    for (let i = 0; i < 3; ++i) {
      const k = (i + 1) % 3, [u, v] = [heights[i], heights[k]];
      if (u === 0) points.push(t[i]);
      else if (u * v < 0) points.push(add(t[i], scaled(u / (u - v), subtract(t[k], t[i]))));
    }
    return points.map((point) => ({ at: dot(line, point), point })).sort((x, y) => x.at - y.at);
  };
  const of_a = crossings(a, b), of_b = crossings(b, a);
  if (of_a.length === 0 || of_b.length === 0 || length(line) === 0) return null;
  const from = of_a[0].at > of_b[0].at ? of_a[0] : of_b[0], to = of_a.at(-1).at < of_b.at(-1).at ? of_a.at(-1) : of_b.at(-1);
  return from.at <= to.at ? [from.point, to.point] : null;
}
