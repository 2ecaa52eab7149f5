import { modes } from './words.js';

// Mouse, fingers and keys.
export class Controls {
  // Where pointers are, by their ids.
  /** @type {Map<number, number[]>} */
  pointers = new Map();
  travelled = 0;

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    const { canvas } = app;
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
      this.travelled = 0;
    });
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerleave', () => app.icicle.light(null));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', (event) => this.up(event));
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      app.view.zoom(Math.exp(0.0015 * event.deltaY * (event.deltaMode === 1 ? 20 : 1)));
      app.moved();
    }, { passive: false });
    document.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => app.ask()).observe(canvas);
  }

  /** @param {PointerEvent} event */
  move(event) {
    const { app, pointers } = this, { view, canvas } = app, before = pointers.get(event.pointerId);
    if (!before) return this.hover(event);
    const now = [event.offsetX, event.offsetY], x = now[0] - before[0], y = now[1] - before[1];
    this.travelled += Math.abs(x) + Math.abs(y);
    if (pointers.size === 2) {
      const [, other] = [...pointers].find(([id]) => id !== event.pointerId) ?? [0, before], apart = (/** @type {number[]} */ p) => Math.hypot(p[0] - other[0], p[1] - other[1]);
      if (apart(now) > 0) view.zoom(apart(before) / apart(now));
      view.pan(x / 2, y / 2, canvas.clientHeight);
    } else if (event.shiftKey || event.buttons & 6) {
      view.pan(x, y, canvas.clientHeight);
    } else {
      view.orbit((x * Math.PI) / canvas.clientHeight, (y * Math.PI) / canvas.clientHeight);
    }
    pointers.set(event.pointerId, now);
    app.ask(true);
  }

  // In the traversal, the tests of the node below the mouse.
  /** @param {PointerEvent} event */
  hover(event) {
    const { app } = this;
    if (app.state.mode !== 'traversal' || !app.unpacked) return;
    const found = app.pick(event.offsetX, event.offsetY);
    app.icicle.light(found && 'slot' in found && found.column === app.state.column ? [found.body, found.slot] : null);
  }

  /** @param {PointerEvent} event */
  up(event) {
    const { app } = this;
    if (!this.pointers.delete(event.pointerId)) return;
    if (this.travelled >= 4 || event.type !== 'pointerup') return app.moved();
    const found = app.pick(event.offsetX, event.offsetY);
    if (!found) app.select(0, 0, -1);
    else if ('pair' in found) app.selectPair(found.column, found.pair);
    else if ('triangle' in found) app.selectTriangle(found.column, found.body, found.triangle);
    else app.select(found.column, found.body, found.slot);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const { app } = this, { state, view } = app;
    if (event.ctrlKey || event.metaKey || event.altKey || /** @type {HTMLDialogElement} */ (document.getElementById('help')).open) return;
    // From the node that is chosen to another one.
    const go = (/** @type {(tree: Tree, slot: number) => number} */ to) => {
      const { selected } = state;
      if (!selected) return;
      const { column, body } = selected, slot = to(app.treeOf(column, body), selected.slot);
      if (slot >= 0) app.select(column, body, slot);
    };
    const turn = (/** @type {number} */ x, /** @type {number} */ y) => {
      if (event.shiftKey) view.pan(-200 * x, -200 * y, app.canvas.clientHeight);
      else view.orbit(x, y);
      app.moved();
    };
    const zoom = (/** @type {number} */ factor) => {
      view.zoom(factor);
      app.moved();
    };
    const along = (/** @type {number} */ axis) => app.along(axis, event.shiftKey ? -1 : 1);
    /** @type {Record<string, (() => unknown) | undefined>} */
    const acts = {
      arrowleft: () => turn(-0.1, 0), arrowright: () => turn(0.1, 0), arrowup: () => turn(0, -0.1), arrowdown: () => turn(0, 0.1),
      '+': () => zoom(0.9), '=': () => zoom(0.9), '-': () => zoom(1 / 0.9),
      '[': () => app.set({ level: state.level - 1 }), ']': () => app.set({ level: state.level + 1 }),
      ',': () => app.step(-1), '.': () => app.step(1),
      ' ': () => app.manifest.frames.length > 1 && app.play(),
      x: () => along(0), y: () => along(1), z: () => along(2),
      f: () => app.fit(), a: () => app.approach(), o: () => app.set({ orthographic: !state.orthographic }),
      m: () => app.set({ mesh: !state.mesh }), e: () => app.set({ edges: !state.edges }), k: () => app.panel.toggleClip(), d: () => app.set({ differences: !state.differences }),
      t: () => app.set({ theme: state.theme === 'dark' ? 'light' : 'dark' }),
      p: () => go((tree, slot) => tree.parent[slot]),
      c: () => go((tree, slot) => (tree.children[slot] > 0 ? tree.firstChild[slot] : -1)),
      n: () => go((tree, slot) => (tree.parent[slot + 1] === tree.parent[slot] ? slot + 1 : -1)),
      i: () => state.selected && app.set({ isolated: !state.isolated }),
      v: () => state.mode === 'traversal' && app.set({ by: state.by === 'worth' ? 'ending' : 'worth' }),
      '/': () => (app.panel.nodePanel.search.focus(), app.panel.nodePanel.search.select()), s: () => app.save(), g: () => app.saveGlb(), h: () => app.help(), '?': () => app.help(),
      escape: () => app.set({ selected: null, pair: null, cell: null, test: -1 }),
    };
    modes.forEach(({ name }, i) => (acts[i + 1] = () => (name === 'levels' || app.hasQueries) && app.set({ mode: name })));
    const name = event.key.toLowerCase(), act = acts[name], onControl = event.target instanceof Element && ['INPUT', 'BUTTON', 'SUMMARY'].includes(event.target.tagName);
    // A control that has the focus has its own use for these.
    if (!act || (onControl && (name === ' ' || name.startsWith('arrow')))) return;
    event.preventDefault();
    act();
  }
}
