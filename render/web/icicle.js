import { clamp } from './linear.js';
import { counted, css } from './elements.js';

// Pairs whose children were tested next: paler than what was rejected at the balls.
export const passedOn = (theme, share = 0.35) => theme.mesh.map((c, i) => Math.round(share * c + (1 - share) * theme.background[i]));
// Text on a color.
const inkOn = ([r, g, b]) => (0.3 * r + 0.59 * g + 0.11 * b > 110 ? [0, 0, 0] : [255, 255, 255]);

// The traversal of a query as an icicle: each test of volumes is a box as wide as all tests that follow from it, below the test that led
// to it. Where the mouse is, the scene shows the two nodes.
export class Icicle {
  constructor(app) {
    this.app = app;
    this.canvas = document.getElementById('icicle');
    this.context = this.canvas.getContext('2d');
    const hover = (test) => test !== app.state.hover && app.set({ hover: test });
    // Boxes are too narrow for fingers: of those nearby the widest.
    const near = (event) => (event.pointerType === 'touch' ? 12 : 0);
    this.canvas.addEventListener('pointermove', (event) => hover(this.pick(event.offsetX, event.offsetY, near(event))));
    this.canvas.addEventListener('pointerleave', () => hover(-1));
    this.canvas.addEventListener('click', (event) => {
      const test = this.pick(event.offsetX, event.offsetY, near(event));
      // Once more on the box that fills the width leads up.
      if (test >= 0) app.set({ test, cell: null, root: test === this.root ? Math.max(this.frame.parents[test], 0) : test });
    });
    this.canvas.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  // What the tests of a frame led to, once for each.
  static follow(frame) {
    if (frame.sizes) return;
    const count = frame.outcomes.length, { parents } = frame;
    frame.sizes = new Uint32Array(count).fill(1);
    for (let i = count - 1; i >= 0; --i) if (parents[i] >= 0) frame.sizes[parents[i]] += frame.sizes[i];
    const groups = frame.ended.counts.length, below = new Uint32Array(count * groups);
    frame.dominant = new Int32Array(count).fill(-1);
    for (let i = count - 1; i >= 0; --i) {
      if (frame.outcomes[i] >= 2) ++below[i * groups + frame.outcomes[i] - 2];
      for (let g = 0, most = 0; g < groups; ++g) {
        const n = below[i * groups + g];
        if (n > most) [most, frame.dominant[i]] = [n, g];
        if (parents[i] >= 0) below[parents[i] * groups + g] += n;
      }
    }
    frame.first = new Int32Array(count).fill(-1);
    frame.next = new Int32Array(count).fill(-1);
    for (let i = count - 1; i >= 0; --i) {
      if (parents[i] < 0) continue;
      frame.next[i] = frame.first[parents[i]];
      frame.first[parents[i]] = i;
    }
  }

  show(query, frame, root) {
    this.query = query;
    this.frame = frame;
    Icicle.follow(frame);
    this.root = root >= 0 && root < frame.outcomes.length ? root : 0;
    this.draw();
  }

  draw() {
    const { canvas, context, frame, app } = this;
    if (!frame || canvas.hidden || canvas.clientWidth === 0) return;
    const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight, { theme } = app;
    Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = css(theme.background);
    context.fillRect(0, 0, width, height);
    this.boxes = [];
    if (frame.outcomes.length === 0) return;
    const chain = [];
    for (let up = frame.parents[this.root]; up >= 0; up = frame.parents[up]) chain.unshift(up);
    const above = chain.slice(-3), depths = above.length + this.depthBelow(this.root, width), row = clamp(Math.floor((height - 2) / Math.max(depths, 1)), 3, 22);
    above.forEach((test, i) => this.box(test, 0, i * row, width, row));
    const stack = [[this.root, 0, above.length]], scale = width / frame.sizes[this.root];
    while (stack.length > 0) {
      const [test, x, depth] = stack.pop(), w = frame.sizes[test] * scale;
      if (depth * row > height) continue;
      this.box(test, x, depth * row, w, row);
      let left = x + scale;  // its own test stands for itself
      for (let child = frame.first[test]; child >= 0; child = frame.next[child]) {
        const size = frame.sizes[child] * scale;
        if (size >= 0.5) stack.push([child, left, depth + 1]);
        left += size;
      }
    }
    for (const { test, x, y, w, h } of this.boxes) {
      if (test !== app.shownTest(frame)) continue;
      context.strokeStyle = css(theme.text);
      context.lineWidth = 2;
      context.strokeRect(x + 1, y + 1, Math.max(w - 2, 1), h - 2);
    }
  }

  // How many rows there are to be seen.
  depthBelow(root, width) {
    const { frame } = this, least = (0.5 * frame.sizes[root]) / width;
    let most = 0;
    const stack = [[root, 1]];
    while (stack.length > 0) {
      const [test, depth] = stack.pop();
      most = Math.max(most, depth);
      for (let child = frame.first[test]; child >= 0; child = frame.next[child]) if (frame.sizes[child] >= least) stack.push([child, depth + 1]);
    }
    return most;
  }

  // The color of a test: of how it ended, or of what it was worth.
  colorOf(test, narrow) {
    const { app, frame, query } = this, { by, theme } = app.state, worth = frame.worths[test], outcome = frame.outcomes[test];
    if (by === 'worth') return worth > 0 ? query.told.worths[worth - 1][theme] : passedOn(app.theme, query.rejects(outcome) ? 0.12 : 0.5);
    // What is too narrow for its ends has the color of most of them.
    const ending = outcome >= 2 ? outcome - 2 : narrow ? frame.dominant[test] : -1;
    return ending < 0 ? passedOn(app.theme) : query.told.groups[ending][theme];
  }

  // Lights up the tests of a node that the mouse is on in the scene; null: of none.
  light(lit) {
    if (String(lit) === String(this.lit ?? null)) return;
    this.lit = lit;
    this.draw();
  }

  // Whether a test is none of those that are looked for: of a node, of a cell of the matrix, or of what is isolated.
  isDim(test) {
    const { cell, column } = this.app.state, { lit, query, frame } = this, a = frame.a[test], b = frame.b[test], { within } = this.app.scenes[column];
    if (within && !within[test]) return true;
    if (lit) return (lit[0] === 0 ? a : b) !== lit[1];
    return Boolean(cell) && (query.trees[0].levelOf(a) !== cell[0] || query.trees[1].levelOf(b) !== cell[1]);
  }

  // Whether the other of two columns did not make the test.
  isOnlyHere(test) {
    const { app, frame } = this, other = app.scenes[1 - app.state.column];
    return app.compares && Boolean(other?.frame) && app.columns[1 - app.state.column].query.testOf(other.frame, frame.a[test], frame.b[test]) < 0;
  }

  box(test, x, y, w, h) {
    const { context, app, frame } = this;
    context.globalAlpha = this.isDim(test) ? 0.25 : 1;
    context.fillStyle = css(this.colorOf(test, w < 4));
    context.fillRect(x, y, Math.max(w - (w > 3 ? 1 : 0), 0.5), h - (h > 4 ? 1 : 0));
    context.globalAlpha = 1;
    this.boxes.push({ test, x, y, w, h });
    if (w > 3 && h > 4 && this.isOnlyHere(test)) {
      context.strokeStyle = css(app.theme.text);
      context.lineWidth = 1;
      context.strokeRect(x + 0.5, y + 0.5, w - 2, h - 2);
    }
    if (w < 60 || h < 14 || frame.sizes[test] === 1) return;
    context.fillStyle = css(frame.outcomes[test] < 2 && app.state.by === 'ending' ? app.theme.text : inkOn(this.colorOf(test, false)));
    context.font = '11px Roboto, system-ui, sans-serif';
    context.fillText(counted(frame.sizes[test] - 1), x + 4, y + h / 2 + 3.5, w - 8);
  }

  // The test at a place; -1: none.
  pick(x, y, near = 0) {
    const found = (this.boxes ?? []).filter((box) => x >= box.x - near && x < box.x + box.w + near && y >= box.y && y < box.y + box.h);
    const hit = near > 0 ? found.reduce((best, box) => (box.w > (best?.w ?? 0) ? box : best), null) : found.at(-1);
    return hit?.test ?? -1;
  }

  // From box to box, and into them.
  key(event) {
    const { frame, app } = this;
    if (!frame) return;
    const at = app.shownTest(frame), siblings = [];
    if (frame.parents[at] >= 0) for (let i = frame.first[frame.parents[at]]; i >= 0; i = frame.next[i]) siblings.push(i);
    const beside = (step) => siblings[siblings.indexOf(at) + step] ?? at;
    const to = { ArrowUp: frame.parents[at], ArrowDown: frame.first[at], ArrowLeft: beside(-1), ArrowRight: beside(1) }[event.key];
    if (event.key === 'Enter') app.set({ root: at === this.root ? Math.max(frame.parents[at], 0) : at });
    else if (to === undefined) return;
    else if (to >= 0) app.set({ test: to, hover: -1 });
    event.preventDefault();
    event.stopPropagation();
  }
}
