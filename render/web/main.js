// The page: what is shown, and who hears what. What is shown is in the address, so that a link opens the same view.
class App {
  constructor() {
    this.manifest = JSON.parse(document.getElementById('manifest').textContent);
    this.canvas = document.getElementById('canvas');
    this.blocks = new Blocks();
    const { manifest } = this;
    this.state = { ...manifest.start, mode: 'levels', hidden: [], focus: 0.5, test: -1, root: 0, kind: 0, levels: {}, selected: null, isolated: false, orthographic: manifest.camera.orthographic };
    this.view = new View(manifest.camera, manifest.up);
    this.cache = new Map();
    this.queued = false;
    this.playing = false;
  }

  async start() {
    this.painter = new Painter(this.canvas, await Promise.all(this.manifest.grids.map((grid) => this.blocks.get(grid))));
    this.canvas.app = this;  // for scripts
    this.trees = this.manifest.trees.map((told) => new Tree(this.painter.gl, this.blocks, told));
    this.depth = Math.max(...this.trees.map((tree) => tree.depth));
    await Promise.all(this.trees.map((tree) => tree.open()));
    this.poses = await Promise.all(this.manifest.bodies.map((body) => this.blocks.get(body.poses)));
    this.queries = this.manifest.queries.map((told, k) => new Query(this.blocks, told, told.bodies.map((body) => this.treeOf(k, body))));
    this.made = [];
    // Ids of triangles are behind those of all nodes: of the whole mesh of a body, then of those of them that are drawn by themselves.
    const counts = this.manifest.bodies.map((body) => (body.mesh === null ? 0 : this.manifest.meshes[body.mesh].triangles));
    let next = Math.max(...this.manifest.bodies.map((body, b) => body.first_id + this.treeOf(0, b).told.nodes));
    this.triangleIds = ['whole', 'marked'].map(() => counts.map((count) => (next += count) - count));
    document.documentElement.classList.add('draws');
    this.readAddress();
    this.panel = new Panel(this);
    this.icicle = new Icicle(this);
    this.listen();
    await this.refresh();
    document.documentElement.dataset.ready = 'true';
  }

  treeOf(kind, body) {
    return this.trees[this.manifest.bodies[body].trees[kind]];
  }
  levelOf(body) {
    return this.state.levels[body] ?? this.state.level;
  }
  poseOf(body) {
    const p = this.poses[body].subarray(12 * this.state.at, 12 * this.state.at + 12);
    return { rotation: [0, 1, 2].map((i) => [p[i], p[4 + i], p[8 + i]]), translation: [p[3], p[7], p[11]] };
  }
  // In the world.
  ballOf(body) {
    const tree = this.treeOf(0, body).told, pose = this.poseOf(body);
    return { center: add(times(pose.rotation, tree.center), pose.translation), radius: tree.radius };
  }

  // Shows the nodes of a test of the traversal.
  hover(test) {
    this.state.test = test;
    return this.refresh();
  }

  // Changes what is shown, and shows it.
  set(change) {
    if ('at' in change || 'mode' in change) Object.assign(this.state, { test: -1, root: 0, ...change });
    if ('level' in change) this.state.levels = {};
    Object.assign(this.state, change);
    this.state.level = clamp(this.state.level, 0, this.depth);
    this.state.at = clamp(this.state.at, 0, this.manifest.frames.length - 1);
    if (!this.state.selected) this.state.isolated = false;
    this.view.orthographic = this.state.orthographic;
    this.cache.clear();
    return this.refresh();
  }

  // The nodes of the test that is looked at, or of that which is enlarged; of A and B.
  slotsOfTest(frame) {
    const { test, root } = this.state, i = [test, root, 0].find((n) => n >= 0 && n < frame.outcomes.length) ?? -1;
    return i < 0 ? [0, 0] : [frame.a[i], frame.b[i]];
  }

  get isHeat() {
    return this.state.mode === 'tests' || this.state.mode === 'wasted';
  }

  // The color of a count on a logarithmic scale with its end, as heat_figure.cpp has it.
  heatColor(count, end) {
    const { viridis } = this.manifest, at = count > 0 ? clamp(Math.log(count / 0.25) / Math.log(end / 0.25), 0, 1) * (viridis.length - 1) : 0;
    const below = Math.min(Math.floor(at), viridis.length - 2), t = at - below;
    return viridis[below].map((c, i) => Math.round(c + t * (viridis[below + 1][i] - c)));
  }

  // Unpacks what is needed, then draws; what was asked for in the meantime wins.
  async refresh() {
    const turn = (this.turn = (this.turn ?? 0) + 1);
    this.unpacked = false;
    try {
      const scenes = await this.prepare();
      if (turn !== this.turn) return;
      this.scenes = scenes;
      this.upload();
    } catch (error) {
      this.panel.node.replaceChildren(element('p', { textContent: error.message }));
      return;
    }
    this.unpacked = true;
    document.documentElement.dataset.theme = this.state.theme;
    const traversal = this.state.mode === 'traversal' && Boolean(this.scenes[0].frame);
    document.documentElement.classList.toggle('traversal', traversal);
    this.icicle.canvas.hidden = !traversal;
    if (traversal) this.icicle.show(this.queries[this.state.kind], this.scenes[this.state.kind].frame, this.state.root);
    this.panel.update();
    this.writeAddress();
    this.ask();
  }

  // What there is to draw, per kind of volumes.
  async prepare() {
    const { bodies, kinds, frames } = this.manifest, { state } = this;
    const selected = state.selected ? this.treeOf(0, state.selected.body).levelOf(state.selected.slot) : 0;
    if (state.mode === 'levels') {
      const needed = bodies.flatMap((body, b) => kinds.map((_, k) => this.treeOf(k, b).load(Math.max(this.levelOf(b), selected))));
      if (state.mesh || state.edges) needed.push(this.loadMeshes());
      await Promise.all(needed);
      return kinds.map(() => ({}));
    }
    await this.loadMeshes();
    return Promise.all(this.queries.map(async (query, k) => {
      const frame = await query.get(frames[state.at]), load = (side, level) => query.trees[side].load(Math.max(level, selected));
      await Promise.all([0, 1].map((side) => load(side, 0)));
      if (!frame || state.mode === 'pairs') return { frame };
      if (state.mode === 'traversal') {
        // One kind's test; the others show the same nodes.
        const slots = this.slotsOfTest(k === state.kind ? frame : await this.queries[state.kind].get(frames[state.at]));
        await Promise.all([0, 1].map((side) => load(side, query.trees[side].levelOf(slots[side]))));
        return { frame, nodes: [0, 1].map((side) => ({ side, slot: slots[side] })) };
      }
      if (this.isHeat) {
        await Promise.all(query.trees.map((tree) => tree.openItems()));
        const triangles = query.told.bodies.map((b) => (bodies[b].mesh === null ? 0 : this.arrays[bodies[b].mesh].indices.length / 3));
        return { frame, heat: query.heat(frame, state.mode === 'wasted', triangles) };
      }
      const ended = query.ended(frame, query.told.groups.map((group) => !state.hidden.includes(group.label)), state.focus);
      await Promise.all([0, 1].map((side) => load(side, ended.all[side].reduce((most, { slot }) => Math.max(most, query.trees[side].levelOf(slot)), 0))));
      await Promise.all(query.trees.map((tree) => tree.openItems()));
      return { frame, all: ended.all[0].length + ended.all[1].length, nodes: query.drawn(ended, (node) => this.areaOf(k, node)) };
    }));
  }

  // Triangles and lines of the frame.
  upload() {
    for (const made of this.made) this.painter.release(made);
    this.made = [];
    if (this.state.mode === 'levels' || this.state.mode === 'traversal') return;
    const keep = (made) => (this.made.push(made), made);
    this.scenes.forEach((scene, k) => {
      const query = this.queries[k], { groups, bodies } = query.told;
      if (!scene.frame) return;
      scene.markedTriangles = [];
      scene.marked = [0, 1].map((side) => {
        const mesh = this.arrays[this.manifest.bodies[bodies[side]].mesh];
        if (!mesh) return null;
        const triangles = [], colors = [], numbers = (scene.markedTriangles[side] = []);
        const chosen = this.state.selected?.body === bodies[side] ? this.state.selected.triangle : null;
        const put = (triangle, usual) => {
          const color = triangle === chosen ? this.manifest.themes[this.state.theme].text : usual;
          numbers.push(triangle);
          triangles.push(...mesh.indices.subarray(3 * triangle, 3 * triangle + 3));
          colors.push(...color);
        };
        if (scene.heat) scene.heat.counts[side].forEach((count, triangle) => put(triangle, this.heatColor(count, scene.heat.end)));
        else if (this.state.mode === 'pairs') for (const triangle of scene.frame.meeting[side]) put(triangle, this.manifest.bodies[bodies[side]].color);
        else for (const { slot, group } of scene.nodes.filter((node) => node.side === side && this.isTriangle(k, node))) for (const item of query.trees[side].itemsOf(slot)) put(item, groups[group][this.state.theme]);
        return triangles.length ? keep(this.painter.uploadMesh(mesh.positions, Uint32Array.from(triangles), colors)) : null;
      });
      const points = scene.heat ? [] : this.linesOf(query, scene.frame);
      scene.lines = points.length ? keep(this.painter.uploadSegments(Float32Array.from(points))) : null;
    });
  }

  // The lines in which the pairs of triangles meet, from the middle of A's tree.
  linesOf(query, frame) {
    const { bodies } = query.told, { manifest } = this, meshes = bodies.map((b) => manifest.bodies[b].mesh);
    if (query.told.objects || meshes.includes(null)) return [];
    const [of_a, of_b] = bodies.map((b) => this.poseOf(b)), middle = query.trees[0].told.center, points = [];
    const corners = (side, triangle) => {
      const { positions, indices } = this.arrays[meshes[side]], { center } = manifest.meshes[meshes[side]];
      return [0, 1, 2].map((k) => add(positions.subarray(3 * indices[3 * triangle + k], 3 * indices[3 * triangle + k] + 3), center));
    };
    // In A's frame.
    const across = (p) => transposedTimes(of_a.rotation, subtract(add(times(of_b.rotation, p), of_b.translation), of_a.translation));
    for (let i = 0; i < frame.pairs.length; i += 2) {
      const line = lineOf(corners(0, frame.pairs[i]), corners(1, frame.pairs[i + 1]).map(across));
      if (line) points.push(...subtract(line[0], middle), ...subtract(line[1], middle));
    }
    return points;
  }

  // Of the triangles that are drawn in place of a node; else 0.
  areaOf(kind, node) {
    if (!this.isTriangle(kind, node)) return 0;
    const query = this.queries[kind], { positions, indices } = this.arrays[this.manifest.bodies[query.told.bodies[node.side]].mesh];
    let area = 0;
    for (const triangle of query.trees[node.side].itemsOf(node.slot)) {
      const [p, q, r] = [0, 1, 2].map((k) => positions.subarray(3 * indices[3 * triangle + k], 3 * indices[3 * triangle + k] + 3));
      area += length(cross(subtract(q, p), subtract(r, p))) / 2;
    }
    return area;
  }

  // Whether a node of the rejections is drawn as the triangles of its leaf, which were tested.
  isTriangle(kind, { side, slot, group }) {
    const query = this.queries[kind], tree = query.trees[side];
    return query.told.groups[group].triangles && tree.children[slot] === 0 && this.manifest.bodies[query.told.bodies[side]].mesh !== null;
  }

  // The volumes of the rejections, those of B hatched.
  rejected(kind, side) {
    const query = this.queries[kind], tree = query.trees[side], body = query.told.bodies[side], { selected, theme } = this.state;
    const byShape = shapeNames.map(() => []), chosen = this.manifest.themes[theme].text;
    for (const node of this.scenes[kind].nodes) {
      if (node.side !== side || this.isTriangle(kind, node)) continue;
      const own = selected?.body === body && selected.slot === node.slot, [r, g, b] = own ? chosen : query.told.groups[node.group][theme];
      const id = this.manifest.bodies[body].first_id + tree.order[node.slot];
      byShape[tree.volume(node.slot).shape].push(node.slot, (r | (g << 8) | (b << 16) | (255 << 24)) >>> 0, (id | (side === 1 ? 0x80000000 : 0)) >>> 0);
    }
    return this.asGroups(tree, body, byShape);
  }

  // The two volumes of the test that is looked at, in the bodies' colors.
  tested(kind) {
    const query = this.queries[kind];
    return this.scenes[kind].nodes.flatMap(({ side, slot }) => {
      const tree = query.trees[side], body = query.told.bodies[side], { color, first_id } = this.manifest.bodies[body], byShape = shapeNames.map(() => []);
      byShape[tree.volume(slot).shape].push(slot, (color[0] | (color[1] << 8) | (color[2] << 16) | (110 << 24)) >>> 0, ((first_id + tree.order[slot]) | (side === 1 ? 0x80000000 : 0)) >>> 0);
      return this.asGroups(tree, body, byShape);
    });
  }

  asGroups(tree, body, byShape) {
    return byShape.map((words, shape) => {
      const centers = new Float32Array(words.length);
      for (let i = 0; i < words.length; i += 3) centers.set(tree.volume(words[i]).numbers.subarray(0, 3), i);
      return { tree, body, shape, words: Uint32Array.from(words), centers, count: words.length / 3 };
    }).filter(({ shape, count }) => shape > 0 && count > 0);
  }

  loadMeshes() {
    this.meshes ??= Promise.all(this.manifest.meshes.map(async (mesh) => ({ positions: await this.blocks.get(mesh.positions), indices: await this.blocks.get(mesh.indices) })))
      .then((arrays) => {
        this.arrays = arrays;
        this.uploaded = arrays.map(({ positions, indices }) => this.painter.uploadMesh(positions, indices));
      });
    return this.meshes;
  }

  ask() {
    if (this.queued || !this.unpacked) return;
    this.queued = true;
    requestAnimationFrame(() => {
      this.queued = false;
      if (this.unpacked) this.draw();
    });
  }

  // The volumes of a body of a kind, as runs of one shape: place, color and id of each.
  groupsOf(kind, body) {
    const key = `${kind} ${body}`;
    if (this.cache.has(key)) return this.cache.get(key);
    const tree = this.treeOf(kind, body), { selected, isolated, opacity } = this.state;
    const own = selected?.body === body ? selected.slot : -1;
    const root = isolated && selected ? (own >= 0 ? own : Infinity) : -1;
    const alpha = Math.round(255 * opacity), byShape = shapeNames.map(() => []);
    const slots = root === Infinity ? [] : tree.cover(Math.max(this.levelOf(body), isolated ? tree.levelOf(own) : 0), root);
    const chosen = this.manifest.themes[this.state.theme].text;
    const put = (slot, color, transparency) => {
      const { shape, color: usual } = tree.volume(slot), [r, g, b] = color ?? usual;
      if (shape > 0) byShape[shape].push(slot, (r | (g << 8) | (b << 16) | (transparency << 24)) >>> 0, this.manifest.bodies[body].first_id + tree.order[slot]);
    };
    for (const slot of slots) if (slot !== own || isolated) put(slot, null, alpha);
    if (own >= 0 && !isolated) put(own, chosen, Math.max(alpha, 64));
    const groups = this.asGroups(tree, body, byShape);
    this.cache.set(key, groups);
    return groups;
  }

  draw() {
    const { canvas, manifest, state, view } = this, ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    this.painter.resize(width, height, width * height <= 2.2e6 ? 2 : 1);
    const { samples } = this.painter, many = manifest.kinds.length, theme = manifest.themes[state.theme];
    const across = width >= height, balls = manifest.bodies.map((_, b) => this.ballOf(b));
    const middle = balls.reduce((sum, ball) => Math.max(sum, length(subtract(ball.center, view.target)) + ball.radius), 0);
    view.standBack = 2 * middle + view.distance;
    this.rectangles = manifest.kinds.map((_, k) => {
      const part = (n) => [Math.round((n * k) / many), Math.round((n * (k + 1)) / many)];
      const [x0, x1] = across ? part(width) : [0, width], [y0, y1] = across ? [0, height] : part(height);
      return [x0, y0, x1 - x0, y1 - y0];  // from the top left
    });
    view.holdIn(this.rectangles[0][2], this.rectangles[0][3]);
    const panes = manifest.kinds.map((_, k) => {
      const [x, y, w, h] = this.rectangles[k], rectangle = [x, height - y - h, w, h].map((n) => n * samples);
      const eye = view.eye(rectangle, samples, balls);
      const list = (groups) => {
        const words = new Uint32Array(groups.reduce((sum, group) => sum + group.words.length, 0));
        groups.reduce((at, group) => (words.set(group.words, at), at + group.words.length), 0);
        return { groups, words, count: words.length / 3 };
      };
      const placed = (group) => {
        const pose = this.poseOf(group.body);
        return { ...group, pose, placement: view.placement(pose, group.tree.told.center, eye.far) };
      };
      const content = state.mode === 'levels' ? this.levelContent(k, eye) : this.queryContent(k, eye);
      return {
        rectangle, background: theme.background, view, eye, meshes: content.meshes, segments: content.segments,
        opaque: list(content.opaque.map(placed)), translucent: list(content.translucent.map(placed)),
      };
    });
    this.painter.draw(panes);
    this.drawLabels(ratio);
  }

  levelContent(k, eye) {
    const { manifest, state, view } = this, groups = manifest.bodies.flatMap((_, b) => this.groupsOf(k, b));
    const meshes = state.mesh || state.edges
      ? manifest.bodies.flatMap((body, b) => (body.mesh === null ? [] : [{
        mesh: this.uploaded[body.mesh], color: manifest.themes[state.theme].mesh, edges: state.edges, first_id: this.triangleIds[0][b],
        placement: view.placement(this.poseOf(b), manifest.meshes[body.mesh].center, eye.far),
      }]))
      : [];
    const opaque = state.opacity >= 1 ? groups : [], translucent = state.opacity > 0 && state.opacity < 1 ? groups : [];
    return { meshes, opaque, translucent, segments: [] };
  }

  queryContent(k, eye) {
    const { manifest, state, view } = this, query = this.queries[k], scene = this.scenes[k], pairs = state.mode === 'pairs', theme = manifest.themes[state.theme];
    const meshes = [], segments = [];
    query.told.bodies.forEach((b, side) => {
      const body = manifest.bodies[b];
      if (body.mesh === null) return;
      const placement = view.placement(this.poseOf(b), manifest.meshes[body.mesh].center, eye.far);
      if (scene.marked?.[side]) meshes.push({ mesh: scene.marked[side], color: body.color, placement, first_id: this.triangleIds[1][b], edges: this.isHeat && state.edges, shading: this.isHeat ? 0.5 : 0.3, hatched: state.mode === 'rejections' && side === 1 });
      if (!scene.heat) meshes.push({ mesh: this.uploaded[body.mesh], color: body.dimmed[state.theme], edges: state.edges, placement, first_id: pairs ? this.triangleIds[0][b] : 0, backdrop: !pairs, fade: pairs ? 0 : 0.5 });
    });
    const meet = query.told.groups.findIndex((group) => group.label === 'triangles meet');
    if (scene.lines && !scene.heat && (pairs || (meet >= 0 && !state.hidden.includes('triangles meet')))) {
      const placement = view.placement(this.poseOf(query.told.bodies[0]), query.trees[0].told.center, eye.far), line = { segments: scene.lines, placement };
      if (pairs) segments.push({ ...line, color: theme.faint, width: 1.5, on_top: true }, { ...line, color: theme.text, width: 3, on_top: false });
      else segments.push({ ...line, color: query.told.groups[meet][state.theme], width: 1.5, on_top: true });
    }
    if (state.mode === 'traversal') return { meshes, segments, opaque: [], translucent: scene.nodes ? this.tested(k) : [] };
    return { meshes, segments, opaque: scene.nodes ? [0, 1].flatMap((side) => this.rejected(k, side)) : [], translucent: [] };
  }

  drawLabels(ratio) {
    const labels = document.getElementById('labels'), { kinds } = this.manifest;
    labels.replaceChildren(...(kinds.length > 1 ? kinds : []).map((kind, k) => {
      const label = element('span', { textContent: kind.title });
      label.style.left = `${this.rectangles[k][0] / ratio + 6}px`;
      label.style.top = `${this.rectangles[k][1] / ratio + 4}px`;
      return label;
    }));
    // A round length of at most a fifth of the view, at the target.
    const height = this.rectangles[0][3] / ratio, world = this.view.pixel(height), most = (this.rectangles[0][2] / ratio) * 0.2 * world;
    const power = 10 ** Math.floor(Math.log10(most)), size = [5, 2, 1].map((n) => n * power).find((n) => n <= most) ?? power;
    const bar = document.getElementById('bar');
    bar.firstElementChild.textContent = short(size);
    bar.lastElementChild.style.width = `${size / world}px`;
  }

  // Counts of the level that is shown.
  counts() {
    const { bodies } = this.manifest, rows = [];
    bodies.forEach((body, b) => {
      const tree = this.treeOf(0, b), level = Math.min(this.levelOf(b), tree.depth);
      rows.push([`${bodies.length > 1 ? `${body.name}, ` : ''}volumes at level ${level} of ${tree.depth}`, counted(tree.cover(level).length)]);
    });
    return rows;
  }

  command() {
    const { manifest, state } = this, command = manifest.commands[state.mode];
    if (!command) return 'scb compares two kinds of volumes at a time.';
    const words = [command];
    if (manifest.up[2] === 1) words.push(`--camera orbit:${this.view.orbit_angles}`);
    if (state.mode === 'levels') words.push(`--levels ${state.level}`, `--opacity ${+state.opacity.toFixed(2)}`, ...(state.mesh ? ['--mesh'] : []), ...(state.edges ? ['--edges'] : []));
    const frame = state.mode === 'traversal' ? this.scenes?.[state.kind]?.frame : null;
    if (frame && state.root > 0) words.push(`--root ${this.queries[state.kind].trees.map((tree, side) => tree.order[(side === 0 ? frame.a : frame.b)[state.root]])}`);
    if (state.mode === 'rejections' && state.focus !== 0.5) words.push(`--focus ${state.focus}`);
    if (manifest.frames.length > 1) words.push(`--frames ${manifest.frames[state.at]}`);
    return [...words, ...(state.orthographic ? ['--ortho'] : []), ...(state.theme === 'dark' ? ['--background dark'] : []), '-o out/'].join(' ');
  }

  // What is at a point of the canvas, in pixels of the page.
  pick(x, y) {
    const ratio = this.canvas.width / this.canvas.clientWidth, px = Math.floor(x * ratio), py = Math.floor(y * ratio);
    const id = this.painter.idAt(px, py), { bodies } = this.manifest, [whole, marked] = this.triangleIds;
    const body = (firsts) => firsts.findLastIndex((first) => id >= first);
    if (id === 0) return null;
    if (id >= marked[0]) {
      const b = body(marked), k = this.rectangles.findIndex(([left, top, width, height]) => px >= left && px < left + width && py >= top && py < top + height);
      const triangle = this.scenes[k].markedTriangles?.[this.queries[k].told.bodies.indexOf(b)]?.[id - marked[b]];
      return triangle === undefined ? null : { body: b, triangle };
    }
    if (id >= whole[0]) return { body: body(whole), triangle: id - whole[body(whole)] };
    const b = body(bodies.map((one) => one.first_id));
    return { body: b, slot: this.treeOf(0, b).slotOf(id - bodies[b].first_id) };
  }

  select(body, slot, triangle = null) {
    return this.set({ selected: slot >= 0 ? { body, slot, triangle } : null });
  }

  // The leaf that has the triangle.
  async selectTriangle(body, triangle) {
    const tree = this.treeOf(0, body);
    await tree.openItems();
    const at = tree.items.indexOf(triangle);
    let slot = -1;
    if (at >= 0) for (slot = 0; tree.firstItem[slot + 1] <= at; ) ++slot;
    return this.select(body, slot, triangle);
  }

  find(text) {
    const { bodies } = this.manifest, at = text.lastIndexOf(':');
    const name = at < 0 ? null : text.slice(0, at).trim(), node = Number(text.slice(at + 1).trim());
    const body = name === null ? 0 : bodies.findIndex((b) => b.name === name);
    const slot = body >= 0 && text.trim() !== '' && Number.isInteger(node) ? this.treeOf(0, body).slotOf(node) : -1;
    if (slot >= 0) return this.select(body, slot);
    this.panel.node.replaceChildren(element('p', { textContent: `There is no node ${text}.` }));
  }

  fit() {
    const balls = this.manifest.bodies.map((_, b) => this.ballOf(b));
    const center = scaled(1 / balls.length, balls.map((ball) => ball.center).reduce(add));
    const radius = Math.max(...balls.map((ball) => length(subtract(ball.center, center)) + ball.radius));
    const [, , width, height] = this.rectangles[0];
    this.view.fit({ center, radius }, width / height);
    this.refresh();
  }
  along(axis, sign) {
    this.view.along([0, 1, 2].map((i) => (i === axis ? sign : 0)));
    this.refresh();
  }
  play() {
    this.playing = !this.playing;
    const step = () => {
      if (!this.playing) return;
      this.set({ at: (this.state.at + 1) % this.manifest.frames.length }).then(() => setTimeout(step, 40));
    };
    step();
    this.panel.update();
  }
  save() {
    this.draw();
    this.canvas.toBlob((blob) => {
      const link = element('a', { href: URL.createObjectURL(blob), download: `${this.manifest.scene}.png` });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }
  help() {
    document.getElementById('help').showModal();
  }

  listen() {
    const { canvas } = this, pointers = new Map();
    let moved = 0;
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
      moved = 0;
    });
    canvas.addEventListener('pointermove', (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      const now = [event.offsetX, event.offsetY], x = now[0] - before[0], y = now[1] - before[1];
      moved += Math.abs(x) + Math.abs(y);
      if (pointers.size === 2) {
        const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
        const apart = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]);
        if (apart(now) > 0) this.view.zoom(apart(before) / apart(now));
        this.view.pan(x / 2, y / 2, canvas.clientHeight);
      } else if (event.shiftKey || event.buttons & 6) {
        this.view.pan(x, y, canvas.clientHeight);
      } else {
        this.view.orbit((x * Math.PI) / canvas.clientHeight, (y * Math.PI) / canvas.clientHeight);
      }
      pointers.set(event.pointerId, now);
      this.ask();
    });
    const up = (event) => {
      if (!pointers.delete(event.pointerId)) return;
      if (moved < 4 && event.type === 'pointerup') {
        const found = this.pick(event.offsetX, event.offsetY);
        if (found && 'triangle' in found) this.selectTriangle(found.body, found.triangle);
        else this.select(found?.body ?? 0, found?.slot ?? -1);
      } else {
        this.writeAddress();
      }
    };
    canvas.addEventListener('pointerup', up);
    canvas.addEventListener('pointercancel', up);
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.view.zoom(Math.exp(0.0015 * event.deltaY * (event.deltaMode === 1 ? 20 : 1)));
      this.ask();
      clearTimeout(this.afterWheel);
      this.afterWheel = setTimeout(() => this.writeAddress(), 200);
    }, { passive: false });
    document.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.ask()).observe(canvas);
    window.addEventListener('hashchange', () => {
      if (location.hash === this.address) return;
      this.readAddress();
      this.cache.clear();
      this.refresh();
    });
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || document.getElementById('help').open) return;
    const { state } = this, onControl = event.target instanceof HTMLInputElement || event.target instanceof HTMLButtonElement;
    const { selected } = state, tree = selected ? this.treeOf(0, selected.body) : null;
    const go = (slot) => slot >= 0 && this.select(selected.body, slot);
    const turn = (x, y) => {
      if (event.shiftKey) this.view.pan(-200 * x, -200 * y, this.canvas.clientHeight);
      else this.view.orbit(x, y);
      this.refresh();
    };
    const zoom = (factor) => {
      this.view.zoom(factor);
      this.refresh();
    };
    const acts = {
      arrowleft: () => turn(-0.1, 0), arrowright: () => turn(0.1, 0), arrowup: () => turn(0, -0.1), arrowdown: () => turn(0, 0.1),
      '+': () => zoom(0.9), '=': () => zoom(0.9), '-': () => zoom(1 / 0.9),
      '[': () => this.set({ level: state.level - 1 }), ']': () => this.set({ level: state.level + 1 }),
      ',': () => this.set({ at: state.at - 1 }), '.': () => this.set({ at: state.at + 1 }),
      ' ': () => this.manifest.frames.length > 1 && this.play(),
      x: () => this.along(0, event.shiftKey ? -1 : 1), y: () => this.along(1, event.shiftKey ? -1 : 1), z: () => this.along(2, event.shiftKey ? -1 : 1),
      f: () => this.fit(), o: () => this.set({ orthographic: !state.orthographic }),
      m: () => this.set({ mesh: !state.mesh }), e: () => this.set({ edges: !state.edges }),
      t: () => this.set({ theme: state.theme === 'dark' ? 'light' : 'dark' }),
      p: () => selected && go(tree.parent[selected.slot]),
      c: () => selected && tree.children[selected.slot] > 0 && go(tree.firstChild[selected.slot]),
      n: () => selected && tree.parent[selected.slot + 1] === tree.parent[selected.slot] && go(selected.slot + 1),
      i: () => selected && this.set({ isolated: !state.isolated }),
      1: () => this.set({ mode: 'levels' }), 2: () => this.queries.length && this.set({ mode: 'rejections' }), 3: () => this.queries.length && this.set({ mode: 'pairs' }),
      4: () => this.queries.length && this.set({ mode: 'tests' }), 5: () => this.queries.length && this.set({ mode: 'wasted' }),
      6: () => this.queries.length && this.set({ mode: 'traversal' }),
      '/': () => (this.panel.search.focus(), this.panel.search.select()), s: () => this.save(), escape: () => this.select(0, -1), h: () => this.help(), '?': () => this.help(),
    };
    const name = event.key.toLowerCase(), act = acts[name];
    // A control that has the focus has its own use for these.
    if (!act || (onControl && (name === ' ' || name.startsWith('arrow')))) return;
    event.preventDefault();
    act();
  }

  writeAddress() {
    const { state, view, manifest } = this, number = (x) => String(+x.toPrecision(7));
    const words = new URLSearchParams();
    if (state.mode !== 'levels') words.set('show', state.mode);
    if (state.hidden.length) words.set('hide', state.hidden.join('|'));
    if (state.focus !== 0.5) words.set('focus', state.focus);
    if (state.mode === 'traversal') {
      if (state.test >= 0) words.set('test', state.test);
      if (state.root > 0) words.set('root', state.root);
      if (state.kind > 0) words.set('kind', state.kind);
    }
    words.set('level', state.level);
    for (const [body, level] of Object.entries(state.levels)) words.set(`level${body}`, level);
    if (manifest.frames.length > 1) words.set('frame', manifest.frames[state.at]);
    if (state.selected) {
      words.set('body', state.selected.body);
      words.set('node', this.treeOf(0, state.selected.body).order[state.selected.slot]);
      if (state.selected.triangle !== null) words.set('triangle', state.selected.triangle);
    }
    if (state.isolated) words.set('only', 1);
    words.set('opacity', number(state.opacity));
    for (const name of ['mesh', 'edges', 'orthographic']) if (state[name]) words.set(name, 1);
    words.set('theme', state.theme);
    words.set('target', view.target.map(number).join());
    words.set('backward', view.axes[2].map(number).join());
    words.set('right', view.axes[0].map(number).join());
    words.set('distance', number(view.distance));
    this.address = `#${words}`;
    history.replaceState(null, '', this.address);
  }

  // What an address does not say stays as it is; what makes no sense is left out.
  readAddress() {
    const words = new URLSearchParams(location.hash.slice(1)), { state, view, manifest } = this;
    const number = (name) => (words.has(name) && Number.isFinite(Number(words.get(name))) ? Number(words.get(name)) : null);
    const vector = (name) => {
      const parts = (words.get(name) ?? '').split(',').map(Number);
      return parts.length === 3 && parts.every(Number.isFinite) ? parts : null;
    };
    state.mode = this.queries.length && ['rejections', 'pairs', 'tests', 'wasted', 'traversal'].includes(words.get('show')) ? words.get('show') : 'levels';
    state.hidden = words.has('hide') ? words.get('hide').split('|') : [];
    state.test = Math.round(number('test') ?? -1);
    state.root = Math.max(0, Math.round(number('root') ?? 0));
    state.kind = clamp(Math.round(number('kind') ?? 0), 0, manifest.kinds.length - 1);
    if (number('focus') !== null) state.focus = clamp(number('focus'), 0.01, 1);
    if (number('level') !== null) state.level = clamp(Math.round(number('level')), 0, this.depth);
    manifest.bodies.forEach((_, b) => {
      if (number(`level${b}`) !== null) state.levels[b] = clamp(Math.round(number(`level${b}`)), 0, this.depth);
    });
    if (manifest.frames.includes(number('frame'))) state.at = manifest.frames.indexOf(number('frame'));
    const body = number('body') ?? 0;
    const slot = number('node') !== null && manifest.bodies[body] ? this.treeOf(0, body).slotOf(number('node')) : -1;
    if (words.size > 0) state.selected = slot >= 0 ? { body, slot, triangle: number('triangle') } : null;
    state.isolated = words.has('only') && slot >= 0;
    if (number('opacity') !== null) state.opacity = clamp(number('opacity'), 0, 1);
    if (words.size > 0) for (const name of ['mesh', 'edges', 'orthographic']) if (words.has('opacity') || words.has(name)) state[name] = words.has(name);
    if (manifest.themes[words.get('theme')]) state.theme = words.get('theme');
    view.orthographic = state.orthographic;
    const [target, backward, right] = ['target', 'backward', 'right'].map(vector);
    if (target) view.target = target;
    if (backward && right && length(cross(backward, right)) > 0.1) {
      const back = unit(backward), up = unit(cross(back, right));
      view.axes = [cross(up, back), up, back];
    }
    if (number('distance') > 0) view.distance = number('distance');
  }
}

const app = new App();
app.start().catch((error) => {
  // What cannot be drawn is said, beside the still picture.
  document.documentElement.classList.remove('draws');
  document.querySelector('#instead p').textContent = `This browser cannot draw the scene (${error.message}). This is the still picture.`;
});
