import { cross, length, unit, clamp } from './linear.js';
import { modes } from './words.js';

const flags = /** @type {const} */ (['mesh', 'edges', 'orthographic']);

// What is shown is in the address, so that a link opens the same view.
export class Address {
  written = '';
  // From chosen().
  /** @type {string | undefined} */
  was;
  /** @type {number | undefined} */
  later;
  // Two nodes by their numbers, from a link.
  /** @type {number[] | null} */
  wanted = null;

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    window.addEventListener('hashchange', () => {
      if (location.hash === this.written) return;
      this.read();
      this.was = this.chosen();
      app.refresh().then(() => app.follow());
    });
  }

  // Soon: browsers refuse many changes of the address in a short time.
  write() {
    clearTimeout(this.later);
    this.later = setTimeout(() => this.writeNow(), 150);
  }

  writeNow() {
    clearTimeout(this.later);
    const { app } = this, { state, view, manifest } = app, number = (/** @type {number} */ x) => String(+x.toPrecision(7)), words = new URLSearchParams();
    const set = (/** @type {string} */ name, /** @type {string | number} */ value) => words.set(name, String(value));
    if (state.mode !== app.firstMode) set('show', state.mode);
    if (state.hidden.length) set('hide', state.hidden.join('|'));
    if (state.without.length) set('without', state.without.join());
    if (state.focus !== 0.5) set('focus', state.focus);
    if (!state.differences) set('differences', 0);
    if (state.column > 0) set('column', state.column);
    if (state.mode === 'traversal') {
      if (state.test >= 0) set('test', state.test);
      if (state.root > 0) set('root', state.root);
      if (state.cell) set('cell', state.cell.join());
      if (state.by !== 'ending') set('by', state.by);
    }
    set('level', state.level);
    for (const [body, level] of Object.entries(state.levels)) set(`level${body}`, level);
    if (manifest.frames.length > 1) set('frame', manifest.frames[state.at]);
    const { selected } = state;
    if (selected) {
      if (selected.column > 0) set('of', selected.column);
      set('body', selected.body);
      set('node', app.treeOf(selected.column, selected.body).numberOf(selected.slot));
      if (selected.triangle !== null) set('triangle', selected.triangle);
    }
    if (state.pair) set('pair', state.pair.join());
    if (state.isolated) set('only', 1);
    set('opacity', number(state.opacity));
    for (const name of flags) if (state[name]) set(name, 1);
    set('theme', state.theme);
    if (state.clip) set('clip', [...state.clip.normal, state.clip.offset].join());
    set('target', view.target.join());
    set('backward', view.axes[2].map(number).join());
    set('right', view.axes[0].map(number).join());
    set('distance', number(view.distance));
    this.written = `#${words}`;
    // Where one can go back to: another mode, or something else that was chosen.
    const chosen = this.chosen(), is_new = this.was !== undefined && this.was !== chosen;
    this.was = chosen;
    // In a frame of a notebook the page has no address of its own.
    if (location.protocol !== 'about:') history[is_new ? 'pushState' : 'replaceState'](null, '', this.written);
  }
  chosen() {
    const { mode, selected, pair, column, test } = this.app.state;
    return JSON.stringify([mode, selected, pair, mode === 'traversal' ? [column, test] : []]);
  }

  // What an address does not say stays as it is; what makes no sense is left out.
  read() {
    const words = new URLSearchParams(location.hash.slice(1)), { app } = this, { state, view, manifest, columns } = app;
    const number = (/** @type {string} */ name) => (words.has(name) && words.get(name) !== '' && Number.isFinite(Number(words.get(name))) ? Number(words.get(name)) : null);
    const whole = (/** @type {string} */ name, /** @type {number} */ otherwise, most = Infinity) => clamp(Math.round(number(name) ?? otherwise), Math.min(0, otherwise), most);
    const list = (/** @type {string} */ name, /** @type {number} */ count) => {
      const parts = (words.get(name) ?? '').split(',').map(Number);
      return parts.length === count && parts.every(Number.isFinite) ? parts : null;
    };
    state.mode = (app.hasQueries && modes.find(({ name }) => name === words.get('show'))?.name) || app.firstMode;
    state.hidden = words.get('hide')?.split('|') ?? [];
    state.without = (words.get('without') ?? '').split(',').filter((word) => /^\d+$/.test(word)).map(Number);
    if (words.size > 0) Object.assign(state, { levels: {}, focus: 0.5 });
    state.differences = words.get('differences') !== '0';
    state.column = whole('column', 0, columns.length - 1);
    state.hover = -1;
    state.test = whole('test', -1);
    state.root = whole('root', 0);
    state.cell = list('cell', 2);
    state.by = words.get('by') === 'worth' ? 'worth' : 'ending';
    const focus = number('focus'), opacity = number('opacity'), frame = number('frame'), node = number('node'), distance = number('distance');
    if (focus !== null) state.focus = clamp(focus, 0.01, 1);
    if (number('level') !== null) state.level = whole('level', 0, app.depth);
    columns[0].bodies.forEach((_, b) => {
      if (number(`level${b}`) !== null) state.levels[b] = whole(`level${b}`, 0, app.depth);
    });
    if (frame !== null && manifest.frames.includes(frame)) state.at = manifest.frames.indexOf(frame);
    // A link to two nodes: the test that was made of them.
    this.wanted = list('nodes', 2);
    const column = whole('of', 0, columns.length - 1), body = number('body') ?? 0;
    const slot = node !== null && columns[column].bodies[body] ? app.treeOf(column, body).slotOfNumber(node) : -1;
    const triangles = (/** @type {ColumnBody | undefined} */ one) => (one?.mesh == null ? 0 : manifest.meshes[one.mesh].triangles);
    const isTriangle = (/** @type {number | null} */ n, /** @type {ColumnBody | undefined} */ one) => n !== null && Number.isInteger(n) && n >= 0 && n < triangles(one);
    const triangle = number('triangle');
    if (words.size > 0) state.selected = slot >= 0 ? { column, body, slot, triangle: isTriangle(triangle, columns[column].bodies[body]) ? triangle : null } : null;
    const pair = list('pair', 3), paired = pair && columns[pair[2]];
    state.pair = pair && paired?.query && [0, 1].every((side) => isTriangle(pair[side], paired.bodies[side])) ? pair : null;
    state.isolated = words.has('only') && slot >= 0;
    if (opacity !== null) state.opacity = clamp(opacity, 0, 1);
    if (words.size > 0) for (const name of flags) if (words.has('opacity') || words.has(name)) state[name] = words.has(name);
    const theme = words.get('theme');
    if (theme === 'light' || theme === 'dark') state.theme = theme;
    const clip = list('clip', 4);
    if (words.size > 0) state.clip = clip && length(clip.slice(0, 3)) > 0 ? { normal: unit(clip.slice(0, 3)), offset: clip[3] / length(clip.slice(0, 3)) } : null;
    view.orthographic = state.orthographic;
    const [target, backward, right] = ['target', 'backward', 'right'].map((name) => list(name, 3));
    if (target) view.target = target;
    if (backward && right && length(cross(backward, right)) > 0.1 && length(backward) < 2 && length(right) < 2) {
      const back = unit(backward), up = unit(cross(back, right));
      view.axes = [cross(up, back), up, back];
    }
    if (distance !== null && distance > 0) view.distance = distance;
  }
}
