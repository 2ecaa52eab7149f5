import { add, subtract, scaled, length, times, clamp } from './linear.js';
import { element, counted, short } from './elements.js';
import { Blocks } from './blocks.js';
import { Tree } from './tree.js';
import { ballAbout, View } from './camera.js';
import { Painter } from './painter.js';
import { Query } from './query.js';
import { Content } from './content.js';
import { Icicle } from './icicle.js';
import { Matrix } from './matrix.js';
import { solidOf } from './solids.js';
import { glbOf } from './glb.js';
import { Panel } from './panel.js';
import { snapshotOf } from './snapshot.js';
import { Address } from './address.js';
import { Controls } from './controls.js';
import { approach } from './approach.js';

// The page: its state, and the parts that follow the state.
export class App {
  // From start().
  /** @type {Painter} */
  painter;
  depth = 0;
  /** @type {Column[]} */
  columns = [];
  // Per column, see idsOf.
  /** @type {{ whole: number[], marked: number[] }[]} */
  triangleIds = [];
  /** @type {Content} */
  content;
  /** @type {Address} */
  address;
  /** @type {Panel} */
  panel;
  /** @type {Icicle} */
  icicle;
  /** @type {Matrix} */
  matrix;

  // From refresh().
  /** @type {Scenes} */
  scenes = Object.assign([], { leaves: null });
  turn = 0;
  unpacked = false;

  // From draw(), in pixels of the canvas.
  /** @type {Rectangle[]} */
  rectangles = [];
  /** @type {Pane[]} */
  panes = [];
  queued = false;
  moving = false;
  cost = 0;  // milliseconds
  /** @type {WebGLSync | null} */
  fence = null;
  /** @type {number | undefined} */
  rest;

  playing = false;
  /** @type {number | undefined} */
  next;

  constructor() {
    /** @type {Manifest} */
    this.manifest = JSON.parse(/** @type {HTMLScriptElement} */ (document.getElementById('manifest')).text);
    this.canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('canvas'));
    this.blocks = new Blocks();
    const { manifest } = this;
    /** @type {State} */
    this.state = {
      ...manifest.start, theme: /** @type {ThemeName} */ (document.documentElement.dataset.theme || (window.matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light')), mode: 'levels', hidden: [], without: [], focus: 0.5, differences: true, column: 0, levels: {}, orthographic: manifest.camera.orthographic, clip: manifest.camera.clip ?? null,
      selected: null, isolated: false, pair: null,  // a node or triangle; two triangles that meet, and the column that found them
      test: -1, hover: -1, root: 0, cell: null, by: 'ending',  // of the traversal
    };
    this.view = new View(manifest.camera, manifest.up);
  }

  async start() {
    const { manifest } = this;
    this.painter = new Painter(this.canvas, await Promise.all(manifest.grids.map((grid) => this.blocks.get(grid))));
    Object.assign(this.canvas, { app: this });  // for scripts
    const trees = manifest.trees.map((stored) => new Tree(this.painter.gl, this.blocks, stored));
    await Promise.all(trees.map((tree) => tree.open()));
    this.depth = Math.max(...trees.map((tree) => tree.depth));
    this.columns = await Promise.all(manifest.columns.map(async (stored) => {
      const bodies = await Promise.all(stored.bodies.map(async (body) => ({ ...body, tree: trees[body.tree], poses: await this.blocks.get(body.poses) })));
      return { ...stored, bodies, query: stored.query ? new Query(this.blocks, stored.query, bodies.map((body) => body.tree)) : null };
    }));
    this.triangleIds = this.columns.map(({ bodies }) => this.idsOf(bodies));
    document.documentElement.classList.add('draws');
    this.content = new Content(this);
    this.address = new Address(this);
    this.address.read();
    this.panel = new Panel(this);
    this.icicle = new Icicle(this);
    this.matrix = new Matrix(this);
    new Controls(this);
    const isPlain = location.hash.length < 2;
    await this.refresh();
    await this.follow();
    if (this.measures && isPlain) {
      // From the view that fits the bodies, a short line is hard to see.
      this.draw();
      this.approach();
    }
    this.address.writeNow();
    // The first drawing was asked for before, so it ends before this callback; a script can pick afterwards.
    await new Promise(requestAnimationFrame);
    document.documentElement.dataset.ready = 'true';
  }

  // The ids of triangles follow the ids of all nodes: first all triangles of a body's mesh, then the triangles that are drawn by themselves.
  /** @param {ColumnBody[]} bodies */
  idsOf(bodies) {
    const counts = bodies.map((body) => (body.mesh === null ? 0 : this.manifest.meshes[body.mesh].triangles));
    let next = Math.max(...bodies.map((body) => body.first_id + body.tree.stored.nodes));
    const firsts = () => counts.map((count) => (next += count) - count);
    return { whole: firsts(), marked: firsts() };
  }

  get hasQueries() {
    return this.columns.some(({ query }) => query);
  }
  // Whether the queries are of distances.
  get measures() {
    return this.columns.some(({ query }) => query?.stored.distance);
  }
  // The mode without a word in the address.
  get firstMode() {
    return this.measures ? 'pairs' : 'levels';
  }
  // The column with the most bodies.
  get longest() {
    return this.columns.reduce((most, column) => (column.bodies.length > most.bodies.length ? column : most));
  }
  // Whether what differs between two columns is to be seen.
  get compares() {
    return this.columns.length === 2 && this.manifest.same_nodes && this.state.differences;
  }
  get theme() {
    return this.manifest.themes[this.state.theme];
  }
  get isHeat() {
    return this.state.mode === 'tests' || this.state.mode === 'wasted';
  }
  // For rejections the endings of paths, for verdicts the verdicts of tests.
  /** @param {QueryFrame} frame */
  classesOf(frame) {
    return this.state.mode === 'verdicts' ? frame.judged : frame.ended;
  }
  /**
   * @param {Query} query
   * @returns {Label[]}
   */
  labelsOf(query) {
    return this.state.mode === 'verdicts' ? query.stored.worths : query.stored.groups;
  }

  /** @type {(column: number, body: number) => Tree} */
  treeOf(column, body) {
    return this.columns[column].bodies[body].tree;
  }
  /** @param {number} body */
  levelOf(body) {
    return this.state.levels[body] ?? this.state.level;
  }
  /** @type {(column: number, body: number) => Pose} */
  poseOf(column, body) {
    const p = this.columns[column].bodies[body].poses.subarray(12 * this.state.at, 12 * this.state.at + 12);
    return { rotation: [0, 1, 2].map((i) => [p[i], p[4 + i], p[8 + i]]), translation: [p[3], p[7], p[11]] };
  }
  // In the world.
  /**
   * @param {number} column
   * @returns {Ball[]}
   */
  ballsOf(column) {
    return this.columns[column].bodies.map(({ tree: { stored } }, b) => {
      const pose = this.poseOf(column, b);
      return { center: add(times(pose.rotation, stored.center), pose.translation), radius: stored.radius };
    });
  }

  // The slot of the selected node, in another column the slot of the same node; -1: there is none.
  /** @param {number} column */
  selectedSlot(column) {
    const { selected } = this.state;
    if (!selected) return -1;
    if (column === selected.column) return selected.slot;
    return this.manifest.same_nodes ? this.treeOf(column, selected.body).slotOf(this.treeOf(selected.column, selected.body).order[selected.slot]) : -1;
  }

  // The test that is looked at, or that which is enlarged; -1: there is none.
  /** @param {QueryFrame} frame */
  shownTest(frame) {
    const { hover, test, root } = this.state;
    return [hover, test, root, 0].find((n) => n >= 0 && n < frame.outcomes.length) ?? -1;
  }

  // Changes what is shown, and shows it.
  /** @param {Partial<State>} change */
  set(change) {
    if ('at' in change || 'mode' in change || 'column' in change) Object.assign(this.state, { test: -1, hover: -1, root: 0, cell: null });
    if ('at' in change) this.state.pair = null;
    if ('level' in change) this.state.levels = {};
    Object.assign(this.state, change);
    const { state } = this;
    state.level = clamp(state.level, 0, this.depth);
    state.at = clamp(state.at, 0, this.manifest.frames.length - 1);
    if (!state.selected) state.isolated = false;
    this.view.orthographic = state.orthographic;
    return this.refresh();
  }

  // The places of frames that one goes through: where queries are shown, of those that have one.
  get stops() {
    const { frames } = this.manifest, has = (/** @type {number} */ frame) => this.state.mode === 'levels' || this.columns.some(({ query }) => query?.frames.has(frame));
    const stops = [...frames.keys()].filter((at) => has(frames[at]));
    return stops.length > 0 ? stops : [...frames.keys()];
  }
  /** @param {number} sign */
  step(sign) {
    const { at } = this.state, to = sign > 0 ? this.stops.find((stop) => stop > at) : this.stops.findLast((stop) => stop < at);
    return to === undefined ? null : this.set({ at: to });
  }

  // Nothing but the camera has changed.
  moved() {
    this.panel.showCommands();
    this.address.write();
    this.ask(true);
  }

  // Unpacks what is needed, then draws; what was asked for in the meantime wins.
  async refresh() {
    const turn = ++this.turn;
    this.unpacked = false;
    try {
      const scenes = await this.content.prepare();
      if (turn !== this.turn) return;
      this.scenes = scenes;
      this.content.upload(scenes);
    } catch (error) {
      if (turn !== this.turn) return;
      this.panel.nodePanel.say(error instanceof Error ? error.message : String(error));
      return;
    }
    this.unpacked = true;
    const { state } = this, { dataset, classList } = document.documentElement;
    dataset.theme = state.theme;
    const { frame } = this.scenes[state.column], traversal = state.mode === 'traversal' ? frame : null;
    classList.toggle('traversal', traversal !== null);
    /** @type {HTMLElement} */ (document.getElementById('tests')).hidden = !traversal;
    if (traversal) {
      /** @type {HTMLElement} */ (document.getElementById('whose')).textContent = this.columns.length > 1 ? this.columns[state.column].title : '';
      this.icicle.show(traversal, state.root);
      this.matrix.show(traversal);
    }
    this.view.clip = state.clip;
    this.panel.update();
    this.address.write();
    this.ask();
  }

  // Draws soon, once what was drawn last is done. Where that takes long, what moves is drawn coarsely, and finely when it rests.
  ask(moving = false) {
    this.moving = moving && this.cost > 200;
    clearTimeout(this.rest);
    if (this.moving) this.rest = setTimeout(() => this.ask(), 400);
    if (this.queued || !this.unpacked) return;
    this.queued = true;
    const step = () => {
      if (this.fence) return requestAnimationFrame(step);
      this.queued = false;
      if (!this.unpacked) return;
      this.draw(this.moving);
      this.watch(performance.now(), this.moving ? 4 : 1);
    };
    requestAnimationFrame(step);
  }

  // How long the picture takes, in milliseconds, if it is drawn finely.
  /** @type {(began: number, times: number) => void} */
  watch(began, times) {
    const { gl } = this.painter;
    this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const look = () => {
      if (this.fence && !gl.isContextLost() && gl.getSyncParameter(this.fence, gl.SYNC_STATUS) !== gl.SIGNALED) return requestAnimationFrame(look);
      if (this.fence) gl.deleteSync(this.fence);
      this.fence = null;
      this.cost = times * (performance.now() - began);
    };
    requestAnimationFrame(look);
  }

  // The color of a count on a logarithmic scale with its end, as heat_figure.cpp has it.
  /** @type {(count: number, end: number) => Color} */
  heatColor(count, end) {
    return this.scaleColor(count > 0 ? clamp(Math.log(count / 0.25) / Math.log(end / 0.25), 0, 1) : 0);
  }
  /**
   * @param {number} share
   * @returns {Color}
   */
  scaleColor(share) {
    const { viridis } = this.manifest, at = share * (viridis.length - 1), below = Math.min(Math.floor(at), viridis.length - 2), t = at - below;
    return viridis[below].map((c, i) => Math.round(c + t * (viridis[below + 1][i] - c)));
  }

  draw(coarse = false) {
    const { canvas } = this, ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    this.drawAt(width, height, width * height <= 2.2e6 && !coarse ? 2 : 1);
    this.drawLabels(ratio);
  }

  /** @type {(width: number, height: number, perPixel: number) => void} */
  drawAt(width, height, perPixel) {
    const { columns, view } = this;
    this.painter.resize(width, height, perPixel);
    const { samples } = this.painter, many = columns.length, across = width >= height;
    const balls = columns.map((_, k) => this.ballsOf(k)), middle = balls.flat().reduce((most, ball) => Math.max(most, length(subtract(ball.center, view.target)) + ball.radius), 0);
    view.standBack = 2 * middle + view.distance;
    this.rectangles = columns.map((_, k) => {
      const part = (/** @type {number} */ n) => [Math.round((n * k) / many), Math.round((n * (k + 1)) / many)];
      const [x0, x1] = across ? part(width) : [0, width], [y0, y1] = across ? [0, height] : part(height);
      return [x0, y0, x1 - x0, y1 - y0];  // from the top left
    });
    view.holdIn(this.rectangles[0][2], this.rectangles[0][3]);
    this.panes = columns.map((_, k) => {
      const [x, y, w, h] = this.rectangles[k], rectangle = /** @type {Rectangle} */ ([x, height - y - h, w, h].map((n) => n * samples));
      const eye = view.eye(rectangle, samples, balls[k]);
      const list = (/** @type {PlacedGroup[]} */ groups) => {
        const words = new Uint32Array(groups.reduce((sum, group) => sum + group.words.length, 0));
        groups.reduce((at, group) => (words.set(group.words, at), at + group.words.length), 0);
        return { groups, words, count: words.length / 3 };
      };
      const placed = (/** @type {VolumeGroup} */ group) => {
        const pose = this.poseOf(k, group.body);
        return { ...group, pose, placement: view.placement(pose, group.tree.stored.center, eye.far) };
      };
      const content = this.content.pane(k, eye);
      return { ...content, rectangle, background: this.theme.background, view, eye, opaque: list(content.opaque.map(placed)), translucent: list(content.translucent.map(placed)), shining: list(content.shining.map(placed)) };
    });
    this.painter.draw(this.panes, this.theme.text);
  }

  /** @param {number} ratio */
  drawLabels(ratio) {
    /** @type {HTMLElement} */ (document.getElementById('labels')).replaceChildren(...(this.columns.length > 1 ? this.columns : []).map(({ title }, k) => {
      const label = element('span', { textContent: title });
      label.style.left = `${this.rectangles[k][0] / ratio + 6}px`;
      label.style.top = `${this.rectangles[k][1] / ratio + 4}px`;
      label.style.maxWidth = `${this.rectangles[k][2] / ratio - 12}px`;
      return label;
    }), ...this.dimensions.map(({ at, text }) => {
      const label = element('span', { textContent: text, className: 'dimension' });
      label.style.left = `${at[0] / ratio + 10}px`;
      label.style.top = `${at[1] / ratio - 10}px`;
      return label;
    }));
    // A round length of at most a fifth of the view, at the target.
    const height = this.rectangles[0][3] / ratio, world = this.view.pixel(height), most = (this.rectangles[0][2] / ratio) * 0.2 * world;
    const power = 10 ** Math.floor(Math.log10(most)), size = [5, 2, 1].map((n) => n * power).find((n) => n <= most) ?? power;
    const [text, line] = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#bar > *'));
    text.textContent = short(size);
    line.style.width = `${size / world}px`;
  }

  // The commands that draw the same without a browser.
  commands() {
    const { manifest, state, columns } = this, commands = manifest.commands[state.mode] ?? [];
    /** @type {string[]} */
    const words = [];
    if (state.mode === 'levels') words.push(`--levels ${state.level}`, `--opacity ${+state.opacity.toFixed(2)}`, ...(state.mesh ? ['--mesh'] : []), ...(state.edges ? ['--edges'] : []));
    const frame = state.mode === 'traversal' ? this.scenes[state.column]?.frame : null;
    if (frame && state.root > 0 && frame.a[state.root] >= 0 && frame.b[state.root] >= 0) words.push(`--root ${frame.query.pairText(frame, state.root)}`);
    if (state.mode === 'rejections' && state.focus !== 0.5) words.push(`--focus ${state.focus}`);
    if (state.mode === 'rejections' && state.hidden.length > 0) {
      const shown = columns.find(({ query }) => query)?.query?.stored.groups.filter(({ label }) => !state.hidden.includes(label)) ?? [];
      if (shown.length > 0) words.push(`--stages ${shown.map(({ stages }) => stages).join()}`);
    }
    const bodies = columns[0].bodies.filter((_, b) => !state.without.includes(b));
    if (state.mode === 'rejections' && state.without.length === 1 && bodies.length === 1) words.push(`--body '${bodies[0].name.replaceAll("'", "'\\''")}'`);
    // The traversal has no view of the scene, and what is inspected its own.
    if (state.mode !== 'traversal' && state.mode !== 'verdicts') {
      if (manifest.up[2] === 1) words.push(`--camera orbit:${this.view.orbitWords()}`);
      if (state.clip) words.push(`--clip ${[...state.clip.normal, state.clip.offset]}`);
      if (state.orthographic) words.push('--ortho');
    }
    if (state.theme === 'dark') words.push('--background dark');
    if (columns[0].several_frames) words.push(`--frames ${manifest.frames[state.at]}`);
    return commands.map((command) => [command, ...words, '-o out/'].join(' '));
  }

  // The command that explains a test of a column.
  /** @type {(column: number, test: number) => string} */
  explain(column, test) {
    const { explain, several_frames } = this.columns[column], { frame } = this.scenes[column], { manifest, state } = this;
    return !explain || !frame ? '' : `${explain}${several_frames ? ` --frames ${manifest.frames[state.at]}` : ''} --pair ${frame.query.pairText(frame, test)}`;
  }

  // The column at a point of the canvas.
  /** @type {(px: number, py: number) => number} */
  columnAt(px, py) {
    return Math.max(0, this.rectangles.findIndex(([left, top, width, height]) => px >= left && px < left + width && py >= top && py < top + height));
  }

  // What is at a point of the canvas, in pixels of the page: a node, a triangle or a pair of triangles.
  /** @type {(x: number, y: number) => Picked | null} */
  pick(x, y) {
    const ratio = this.canvas.width / this.canvas.clientWidth, px = Math.floor(x * ratio), py = Math.floor(y * ratio), column = this.columnAt(px, py);
    if (this.state.mode === 'pairs') {
      const pair = this.lineAt(column, px, py, 5 * ratio);
      if (pair) return { column, pair };
    }
    const id = this.painter.idAt(px, py), { bodies } = this.columns[column], { whole, marked } = this.triangleIds[column];
    const body = (/** @type {number[]} */ firsts) => firsts.findLastIndex((first) => id >= first);
    if (id === 0) return null;
    if (id >= marked[0]) {
      const b = body(marked), triangle = this.content.markedTriangle(column, b, id - marked[b]);
      return triangle === undefined ? null : { column, body: b, triangle };
    }
    if (id >= whole[0]) return { column, body: body(whole), triangle: id - whole[body(whole)] };
    const b = body(bodies.map((one) => one.first_id));
    return { column, body: b, slot: bodies[b].tree.slotOf(id - bodies[b].first_id) };
  }

  // Pixels of the canvas by points of a contact, which count from the middle of A's tree.
  /** @type {(column: number) => (p: Vector) => Vector} */
  projection(column) {
    const { eye } = this.panes[column], { half_view, orthographic } = eye.uniforms, [left, top, width, height] = this.rectangles[column];
    const placement = this.view.placement(this.poseOf(column, 0), this.treeOf(column, 0).stored.center, eye.far);
    return (p) => {
      const [x, y, z] = add(placement.origin, scaled(placement.scale, times(placement.columns, p))), depth = orthographic ? 1 : -z;
      return [left + (width * (1 + x / depth / half_view[0])) / 2, top + (height * (1 - y / depth / half_view[1])) / 2];
    };
  }

  // The number of the shortest line of each column, and where it is in the canvas.
  get dimensions() {
    if (this.state.mode !== 'pairs') return [];
    return this.scenes.flatMap(({ frame, contacts }, k) => {
      const distance = frame?.stored.distance, line = contacts?.[0]?.line;
      if (!distance || !line) return [];
      const at = this.projection(k)(scaled(0.5, add(line.slice(0, 3), line.slice(3)))), [left, top, width, height] = this.rectangles[k];
      const isSeen = at[0] >= left && at[0] < left + width && at[1] >= top && at[1] < top + height;
      return isSeen ? [{ at, text: short(distance) }] : [];
    });
  }

  // The pair of triangles whose line is nearest to a point, at most `most` pixels away.
  /** @type {(column: number, px: number, py: number, most: number) => number[] | null} */
  lineAt(column, px, py, most) {
    const onScreen = this.projection(column);
    /** @type {number[] | null} */
    let found = null;
    let least = most;
    for (const { pair, line } of this.scenes[column].contacts ?? []) {
      const p = onScreen(line.slice(0, 3)), q = onScreen(line.slice(3)), d = [q[0] - p[0], q[1] - p[1]], size = d[0] ** 2 + d[1] ** 2;
      const t = size > 0 ? clamp(((px - p[0]) * d[0] + (py - p[1]) * d[1]) / size, 0, 1) : 0, away = Math.hypot(p[0] + t * d[0] - px, p[1] + t * d[1] - py);
      if (away < least) [found, least] = [pair, away];
    }
    return found;
  }

  /**
   * @param {number} column
   * @param {number} body
   * @param {number} slot -1: none
   * @param {number | null} triangle
   */
  select(column, body, slot, triangle = null) {
    return this.set({ selected: slot >= 0 ? { column, body, slot, triangle } : null, pair: null });
  }

  // The slot of the leaf that has the triangle; -1: none.
  /** @type {(column: number, body: number, triangle: number) => Promise<number>} */
  async leafOf(column, body, triangle) {
    const tree = this.treeOf(column, body);
    await tree.openItems();
    const at = tree.items.indexOf(triangle);
    let slot = -1;
    if (at >= 0) for (slot = 0; tree.firstItem[slot + 1] <= at; ) ++slot;
    return slot;
  }
  /** @type {(column: number, body: number, triangle: number) => Promise<void>} */
  async selectTriangle(column, body, triangle) {
    return this.select(column, body, await this.leafOf(column, body, triangle), triangle);
  }
  /** @type {(column: number, pair: number[]) => Promise<void>} */
  selectPair(column, pair) {
    return this.set({ selected: null, pair: [...pair, column] });
  }

  // Shows a test of the traversal, among the tests of its frame.
  /** @param {number} column @param {number} test */
  async showTest(column, test, frame = this.manifest.frames[this.state.at]) {
    const found = await this.columns[column].query?.get(frame);
    if (!found || test < 0 || test >= found.outcomes.length) return false;
    await this.set({ mode: 'traversal', column, at: this.manifest.frames.indexOf(frame), test, root: Math.max(found.parents[test], 0), selected: null, pair: null });
    return true;
  }

  // Shows what a link asked for that only the query can tell: the test of two nodes.
  async follow() {
    const { wanted } = this.address;
    this.address.wanted = null;
    if (wanted) await this.find(wanted.join());
  }

  // A node by its number, "A:412"; two of them, "412,97", whose test is shown. A promise of whether there is one.
  /**
   * @param {string} words
   * @returns {Promise<boolean>}
   */
  async find(words) {
    const text = words.trim();
    const first = this.state.selected?.column ?? this.state.column, refuse = (/** @type {string} */ what) => {
      this.panel.nodePanel.say(what);
      return false;
    };
    // Of a body by its name, or by A and B.
    const nodeOf = (/** @type {ColumnBody[]} */ bodies, /** @type {string} */ words, /** @type {number} */ otherwise) => {
      const at = words.lastIndexOf(':'), name = words.slice(0, Math.max(at, 0)).trim(), number = words.slice(at + 1).trim();
      const named = bodies.findIndex((one) => one.name === name), body = at < 0 ? otherwise : named >= 0 ? named : ['a', 'b'].indexOf(name.toLowerCase());
      return { body, slot: /^\d+$/.test(number) ? bodies[body]?.tree.slotOfNumber(Number(number)) ?? -1 : -1 };
    };
    for (const column of [first, ...this.columns.keys()]) {
      const { bodies, query } = this.columns[column], { body, slot } = nodeOf(bodies, text, 0);
      if (slot >= 0) return this.select(column, body, slot).then(() => true);
      const parts = text.split(','), nodes = parts.map((part, side) => nodeOf(bodies, part, side));
      if (parts.length !== 2 || !query || nodes.some(({ body: of, slot: at }, side) => of !== side || at < 0)) continue;
      const frame = await query.get(this.manifest.frames[this.state.at]);
      if (!frame) return refuse('The page has no query of this frame.');
      const test = query.testOf(frame, nodes[0].slot, nodes[1].slot);
      if (test >= 0) return this.showTest(column, test);
      const lost = query.lostAt(frame, nodes[0].slot, nodes[1].slot);
      return refuse(`These two were not tested: ${text}.${lost < 0 ? '' : ` The test of ${query.pairText(frame, lost)}, above them, ended with ${query.endingOf(frame, lost)}.`}`);
    }
    return refuse(`There is no node ${text}: give a number, a body and a number such as B:412, or two numbers such as 412,97.`);
  }

  // `room`: what of the view around them is left free, as a factor.
  fit(balls = this.columns.flatMap((_, k) => this.ballsOf(k)), room = 1) {
    const { center, radius } = ballAbout(balls), [, , width, height] = this.rectangles[0];
    this.view.fit({ center, radius: room * Math.max(radius, 1e-9 * length(center)) || 1 }, width / height);
    this.moved();
  }
  approach() {
    approach(this);
  }
  /** @type {(axis: number, sign: number) => void} */
  along(axis, sign) {
    this.view.along([0, 1, 2].map((i) => (i === axis ? sign : 0)));
    this.moved();
  }
  play() {
    this.playing = !this.playing;
    clearTimeout(this.next);
    const step = () => {
      if (!this.playing) return;
      const { stops } = this;
      this.set({ at: stops.find((stop) => stop > this.state.at) ?? stops[0] }).then(() => (this.next = setTimeout(step, 40)));
    };
    step();
    this.panel.update();
  }

  save() {
    this.draw();
    snapshotOf(this).toBlob((blob) => (blob ? this.offer(blob, 'png') : this.panel.nodePanel.say('The browser cannot make a picture of this size.')));
  }

  // The volumes that are shown, of one column; or the node that is chosen.
  saveGlb() {
    const { state } = this, { selected } = state, k = selected?.column ?? state.column, { bodies } = this.columns[k], nodes = this.scenes[k].nodes ?? [], most = 20000;
    const slotsOf = (/** @type {number} */ b) => (state.mode === 'levels' ? this.content.coverOf(k, b) : nodes.filter(({ side }) => side === b && !state.without.includes(b)).map(({ slot }) => slot));
    const shown = selected && !state.isolated ? [{ b: selected.body, slot: selected.slot }] : bodies.flatMap((_, b) => slotsOf(b).map((slot) => ({ b, slot })));
    if (shown.length > most) return this.panel.nodePanel.say(`These are ${counted(shown.length)} volumes; a file has ${counted(most)} at most. Choose a level further up.`);
    // Round things by fewer corners where there are many of them.
    const corners = shown.length <= 300 ? 48 : shown.length <= 4000 ? 24 : 12;
    const { query } = this.columns[k], labels = query ? this.labelsOf(query) : [];
    const colors = new Map(nodes.map((node) => [`${node.side} ${node.slot}`, state.mode === 'traversal' ? bodies[node.side].color : labels[node.group][state.theme]]));
    const file = glbOf(shown.map(({ b, slot }) => {
      const { name, tree } = bodies[b], volume = tree.volume(slot), number = tree.numberOf(slot);
      return {
        name: `${name} ${number}`, ...solidOf(volume.shape, volume.numbers, tree.extrasOf(slot), corners), color: colors.get(`${b} ${slot}`) ?? volume.color,
        opacity: state.mode === 'levels' ? Math.max(state.opacity, 0.05) : 1, pose: this.poseOf(k, b), center: tree.stored.center, id: number, depth: tree.levelOf(slot),
      };
    }), this.manifest.scene);
    if (file) this.offer(new Blob([file], { type: 'model/gltf-binary' }), 'glb');
    else this.panel.nodePanel.say('No volumes are shown here.');
  }
  /** @type {(blob: Blob, ending: string) => void} */
  offer(blob, ending) {
    const link = element('a', { href: URL.createObjectURL(blob), download: `${this.manifest.scene}.${ending}` });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
  help() {
    const help = /** @type {HTMLDialogElement} */ (document.getElementById('help'));
    help.showModal();
    help.scrollTop = 0;
  }
}

new App().start().catch((error) => {
  // What cannot be drawn is said, beside the still picture.
  document.documentElement.className = 'fails';
  /** @type {HTMLElement} */ (document.querySelector('#instead p')).textContent = `This browser cannot draw the scene (${error.message}). This is the still picture.`;
});
