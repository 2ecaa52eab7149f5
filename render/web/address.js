import { cross, length, unit, clamp } from './linear.js';
import { modes } from './words.js';

// What is shown is in the address, so that a link opens the same view.
export class Address {
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
    const { app } = this, { state, view, manifest } = app, number = (x) => String(+x.toPrecision(7)), words = new URLSearchParams();
    if (state.mode !== 'levels') words.set('show', state.mode);
    if (state.hidden.length) words.set('hide', state.hidden.join('|'));
    if (state.without.length) words.set('without', state.without.join());
    if (state.focus !== 0.5) words.set('focus', state.focus);
    if (!state.differences) words.set('differences', 0);
    if (state.column > 0) words.set('column', state.column);
    if (state.mode === 'traversal') {
      if (state.test >= 0) words.set('test', state.test);
      if (state.root > 0) words.set('root', state.root);
      if (state.cell) words.set('cell', state.cell.join());
      if (state.by !== 'ending') words.set('by', state.by);
    }
    words.set('level', state.level);
    for (const [body, level] of Object.entries(state.levels)) words.set(`level${body}`, level);
    if (manifest.frames.length > 1) words.set('frame', manifest.frames[state.at]);
    const { selected } = state;
    if (selected) {
      if (selected.column > 0) words.set('of', selected.column);
      words.set('body', selected.body);
      words.set('node', app.treeOf(selected.column, selected.body).numberOf(selected.slot));
      if (selected.triangle !== null) words.set('triangle', selected.triangle);
    }
    if (state.pair) words.set('pair', state.pair.join());
    if (state.isolated) words.set('only', 1);
    words.set('opacity', number(state.opacity));
    for (const name of ['mesh', 'edges', 'orthographic']) if (state[name]) words.set(name, 1);
    words.set('theme', state.theme);
    if (state.clip) words.set('clip', [...state.clip.normal, state.clip.offset].join());
    words.set('target', view.target.join());
    words.set('backward', view.axes[2].map(number).join());
    words.set('right', view.axes[0].map(number).join());
    words.set('distance', number(view.distance));
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
    const number = (name) => (words.has(name) && words.get(name) !== '' && Number.isFinite(Number(words.get(name))) ? Number(words.get(name)) : null);
    const whole = (name, otherwise, most = Infinity) => clamp(Math.round(number(name) ?? otherwise), Math.min(0, otherwise), most);
    const list = (name, count) => {
      const parts = (words.get(name) ?? '').split(',').map(Number);
      return parts.length === count && parts.every(Number.isFinite) ? parts : null;
    };
    state.mode = app.hasQueries && modes.some(({ name }) => name === words.get('show')) ? words.get('show') : 'levels';
    state.hidden = words.has('hide') ? words.get('hide').split('|') : [];
    state.without = (words.get('without') ?? '').split(',').filter((word) => /^\d+$/.test(word)).map(Number);
    if (words.size > 0) Object.assign(state, { levels: {}, focus: 0.5 });
    state.differences = words.get('differences') !== '0';
    state.column = whole('column', 0, columns.length - 1);
    state.hover = -1;
    state.test = whole('test', -1);
    state.root = whole('root', 0);
    state.cell = list('cell', 2);
    state.by = words.get('by') === 'worth' ? 'worth' : 'ending';
    if (number('focus') !== null) state.focus = clamp(number('focus'), 0.01, 1);
    if (number('level') !== null) state.level = whole('level', 0, app.depth);
    columns[0].bodies.forEach((_, b) => {
      if (number(`level${b}`) !== null) state.levels[b] = whole(`level${b}`, 0, app.depth);
    });
    if (manifest.frames.includes(number('frame'))) state.at = manifest.frames.indexOf(number('frame'));
    // A link to two nodes: the test that was made of them.
    this.wanted = list('nodes', 2);
    const column = whole('of', 0, columns.length - 1), body = number('body') ?? 0;
    const slot = number('node') !== null && columns[column].bodies[body] ? app.treeOf(column, body).slotOfNumber(number('node')) : -1;
    const triangles = (one) => (one?.mesh == null ? 0 : manifest.meshes[one.mesh].triangles), isTriangle = (n, one) => Number.isInteger(n) && n >= 0 && n < triangles(one);
    const triangle = number('triangle');
    if (words.size > 0) state.selected = slot >= 0 ? { column, body, slot, triangle: isTriangle(triangle, columns[column].bodies[body]) ? triangle : null } : null;
    const pair = list('pair', 3), paired = pair && columns[pair[2]];
    state.pair = paired?.query && [0, 1].every((side) => isTriangle(pair[side], paired.bodies[side])) ? pair : null;
    state.isolated = words.has('only') && slot >= 0;
    if (number('opacity') !== null) state.opacity = clamp(number('opacity'), 0, 1);
    if (words.size > 0) for (const name of ['mesh', 'edges', 'orthographic']) if (words.has('opacity') || words.has(name)) state[name] = words.has(name);
    if (Object.hasOwn(manifest.themes, words.get('theme') ?? '')) state.theme = words.get('theme');
    const clip = list('clip', 4);
    if (words.size > 0) state.clip = clip && length(clip.slice(0, 3)) > 0 ? { normal: unit(clip.slice(0, 3)), offset: clip[3] / length(clip.slice(0, 3)) } : null;
    view.orthographic = state.orthographic;
    const [target, backward, right] = ['target', 'backward', 'right'].map((name) => list(name, 3));
    if (target) view.target = target;
    if (backward && right && length(cross(backward, right)) > 0.1 && length(backward) < 2 && length(right) < 2) {
      const back = unit(backward), up = unit(cross(back, right));
      view.axes = [cross(up, back), up, back];
    }
    if (number('distance') > 0) view.distance = number('distance');
  }
}
