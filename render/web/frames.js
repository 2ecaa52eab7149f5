import { element, contextOf, counted, percent, css, faint, row, button } from './elements.js';
import { passedOn } from './icicle.js';

// The volume tests of each frame that has its query in the page, with those that were wasted on top; of several columns one below the other.
export class FrameChart {
  // The frames that waste the most; from parts().
  /** @type {HTMLElement | null} */
  worst = null;

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.places = new Map(app.manifest.frames.map((frame, i) => [frame, i]));
    this.columns = app.columns.flatMap(({ query }, k) => (query && app.manifest.frames.length > 1 ? [{ query, k }] : []));
    this.canvas = element('canvas', { className: 'chart', title: 'Volume tests by frame, the wasted ones on top; click to go there' });
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', 'Volume tests by frame');
    this.canvas.addEventListener('click', (event) => app.set({ at: this.frameAt(event.offsetX) }));
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  // The canvas, and the frames that waste the most; nothing where there are no frames to choose from.
  parts() {
    if (this.columns.length === 0) return [];
    const most = Math.max(...this.columns.flatMap(({ query }) => query.stored.frames.map(({ n_v }) => n_v)));
    return [this.canvas, faint(`Volume tests by frame, the wasted ones colored; at most ${counted(most)}`), (this.worst = element('div'))];
  }

  update() {
    const { app } = this;
    this.draw();
    this.worst?.replaceChildren(...(['wasted', 'traversal', 'verdicts'].includes(app.state.mode) ? this.columns : []).filter(({ query }) => query.stored.frames.length > 1).flatMap(({ query, k }) => {
      const worst = [...query.stored.frames].sort((x, y) => y.wasted - x.wasted || x.frame - y.frame).slice(0, 3), of = app.columns.length > 1 ? `${app.columns[k].title}: ` : '';
      return [faint(`${of}frames with the most wasted tests`), row(...worst.map(({ frame, wasted, n_v }) =>
        button(`${frame}: ${counted(wasted)}`, `${percent(wasted, n_v)} of ${counted(n_v)}`, () => app.set({ at: this.placeOf(frame) }))))];
    }));
  }

  /** @param {number} frame */
  placeOf(frame) {
    return this.places.get(frame) ?? 0;
  }

  // The nearest with a query.
  /** @param {number} x */
  frameAt(x) {
    const at = (x / this.canvas.clientWidth) * this.app.manifest.frames.length - 0.5, have = this.columns.flatMap(({ query }) => [...query.frames.keys()].map((frame) => this.placeOf(frame)));
    return have.reduce((best, place) => (Math.abs(place - at) < Math.abs(best - at) ? place : best), have[0] ?? this.app.state.at);
  }

  draw() {
    const { app, canvas } = this, width = canvas.clientWidth, height = canvas.clientHeight, ratio = window.devicePixelRatio || 1, context = contextOf(canvas);
    if (width === 0 || this.columns.length === 0) return;
    Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const { frames } = app.manifest, row = height / this.columns.length, step = width / frames.length, most = Math.max(1, ...this.columns.flatMap(({ query }) => query.stored.frames.map(({ n_v }) => n_v)));
    this.columns.forEach(({ query }, i) => {
      const bottom = (i + 1) * row, unit = (row - 3) / most;
      for (const { frame, n_v, wasted } of query.stored.frames) {
        const x = this.placeOf(frame) * step;
        context.fillStyle = css(passedOn(app.theme, 0.6));
        context.fillRect(x, bottom - unit * (n_v - wasted), Math.max(step, 2), unit * (n_v - wasted));
        context.fillStyle = css(query.stored.worths[0][app.state.theme]);
        context.fillRect(x, bottom - unit * n_v, Math.max(step, 2), unit * wasted);
        context.fillRect(x, bottom - 1, Math.max(step, 2), 1);  // also of none
      }
    });
    context.fillStyle = css(app.theme.text);
    context.fillRect((app.state.at + 0.5) * step - 0.5, 0, 1, height);
  }
}
