import { clamp } from './linear.js';
import { contextOf, counted, css } from './elements.js';

// Pairs whose children were tested next: paler than what was rejected at the balls.
/** @type {(theme: Theme, share?: number) => Color} */
export const passedOn = (theme, share = 0.35) => theme.mesh.map((c, i) => Math.round(share * c + (1 - share) * theme.background[i]));
// Text on a color.
/** @type {(color: Color) => Color} */
const inkOn = ([r, g, b]) => (0.3 * r + 0.59 * g + 0.11 * b > 110 ? [0, 0, 0] : [255, 255, 255]);

// The traversal of a query as an icicle: each test of volumes is a box as wide as all tests that follow from it, below the test that led
// to it. Where the mouse is, the scene shows the two nodes.
export class Icicle {
  /** @type {QueryFrame | null} */
  frame = null;
  root = 0;
  /** @type {{ test: number, x: number, y: number, w: number, h: number }[]} */
  boxes = [];
  // Side and slot of the node whose tests are lit up.
  /** @type {number[] | null} */
  lit = null;

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('icicle'));
    this.context = contextOf(this.canvas);
    const hover = (/** @type {number} */ test) => test !== app.state.hover && app.set({ hover: test });
    // Boxes are too narrow for fingers: of those nearby the widest.
    const near = (/** @type {MouseEvent & { pointerType?: string }} */ event) => (event.pointerType === 'touch' ? 12 : 0);
    this.canvas.addEventListener('pointermove', (event) => hover(this.pick(event.offsetX, event.offsetY, near(event))));
    this.canvas.addEventListener('pointerleave', () => hover(-1));
    this.canvas.addEventListener('click', (event) => {
      const test = this.pick(event.offsetX, event.offsetY, near(event));
      // Once more on the box that fills the width leads up.
      if (test >= 0 && this.frame) app.set({ test, cell: null, root: test === this.root ? Math.max(this.frame.parents[test], 0) : test });
    });
    this.canvas.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  /** @type {(frame: QueryFrame, root: number) => void} */
  show(frame, root) {
    this.frame = frame;
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
    const { sizes, first, next } = frame.followers;
    /** @type {number[]} */
    const chain = [];
    for (let up = frame.parents[this.root]; up >= 0; up = frame.parents[up]) chain.unshift(up);
    const above = chain.slice(-3), depths = above.length + this.depthBelow(frame, this.root, width), row = clamp(Math.floor((height - 2) / Math.max(depths, 1)), 3, 22);
    above.forEach((test, i) => this.box(frame, test, 0, i * row, width, row));
    const stack = [{ test: this.root, x: 0, depth: above.length }], scale = width / sizes[this.root];
    for (let here = stack.pop(); here; here = stack.pop()) {
      const { test, x, depth } = here, w = sizes[test] * scale;
      if (depth * row > height) continue;
      this.box(frame, test, x, depth * row, w, row);
      let left = x + scale;  // its own test stands for itself
      for (let child = first[test]; child >= 0; child = next[child]) {
        const size = sizes[child] * scale;
        if (size >= 0.5) stack.push({ test: child, x: left, depth: depth + 1 });
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
  /** @type {(frame: QueryFrame, root: number, width: number) => number} */
  depthBelow({ followers: { sizes, first, next } }, root, width) {
    const least = (0.5 * sizes[root]) / width, stack = [{ test: root, depth: 1 }];
    let most = 0;
    for (let here = stack.pop(); here; here = stack.pop()) {
      const { test, depth } = here;
      most = Math.max(most, depth);
      for (let child = first[test]; child >= 0; child = next[child]) if (sizes[child] >= least) stack.push({ test: child, depth: depth + 1 });
    }
    return most;
  }

  // The color of a test: of its ending, or of its verdict.
  /** @type {(frame: QueryFrame, test: number, narrow: boolean) => Color} */
  colorOf(frame, test, narrow) {
    const { app } = this, { query } = frame, { by, theme } = app.state, worth = frame.worths[test], outcome = frame.outcomes[test];
    if (by === 'worth') return worth > 0 ? query.stored.worths[worth - 1][theme] : passedOn(app.theme, query.rejects(outcome) ? 0.12 : 0.5);
    // What is too narrow for its ends has the color of most of them.
    const ending = outcome >= 2 ? outcome - 2 : narrow ? frame.followers.dominant[test] : -1;
    return ending < 0 ? passedOn(app.theme) : query.stored.groups[ending][theme];
  }

  // Lights up the tests of a node that the mouse is on in the scene; null: of none.
  /** @param {number[] | null} lit */
  light(lit) {
    if (String(lit) === String(this.lit)) return;
    this.lit = lit;
    this.draw();
  }

  // Whether a test is not among the selected tests: tests of a node, of a cell of the matrix, or of the isolated node.
  /** @type {(frame: QueryFrame, test: number) => boolean} */
  isDim(frame, test) {
    const { cell, column } = this.app.state, { lit } = this, { trees } = frame.query, a = frame.a[test], b = frame.b[test], { within } = this.app.scenes[column];
    if (within && !within[test]) return true;
    if (lit) return (lit[0] === 0 ? a : b) !== lit[1];
    return cell !== null && (trees[0].levelOf(a) !== cell[0] || trees[1].levelOf(b) !== cell[1]);
  }

  // Whether the other of two columns did not make the test.
  /** @type {(frame: QueryFrame, test: number) => boolean} */
  isOnlyHere(frame, test) {
    const { app } = this, other = app.compares ? app.scenes[1 - app.state.column].frame : null;
    return other !== null && other.query.testOf(other, frame.a[test], frame.b[test]) < 0;
  }

  /** @type {(frame: QueryFrame, test: number, x: number, y: number, w: number, h: number) => void} */
  box(frame, test, x, y, w, h) {
    const { context, app } = this, { sizes } = frame.followers;
    context.globalAlpha = this.isDim(frame, test) ? 0.25 : 1;
    context.fillStyle = css(this.colorOf(frame, test, w < 4));
    context.fillRect(x, y, Math.max(w - (w > 3 ? 1 : 0), 0.5), h - (h > 4 ? 1 : 0));
    context.globalAlpha = 1;
    this.boxes.push({ test, x, y, w, h });
    if (w > 3 && h > 4 && this.isOnlyHere(frame, test)) {
      context.strokeStyle = css(app.theme.text);
      context.lineWidth = 1;
      context.strokeRect(x + 0.5, y + 0.5, w - 2, h - 2);
    }
    if (w < 60 || h < 14 || sizes[test] === 1) return;
    context.fillStyle = css(frame.outcomes[test] < 2 && app.state.by === 'ending' ? app.theme.text : inkOn(this.colorOf(frame, test, false)));
    context.font = '11px Roboto, system-ui, sans-serif';
    context.fillText(counted(sizes[test] - 1), x + 4, y + h / 2 + 3.5, w - 8);
  }

  // The test at a place; -1: none.
  /** @param {number} x @param {number} y */
  pick(x, y, near = 0) {
    const found = this.boxes.filter((box) => x >= box.x - near && x < box.x + box.w + near && y >= box.y && y < box.y + box.h);
    const widest = Math.max(...found.map(({ w }) => w)), hit = near > 0 ? found.find(({ w }) => w === widest) : found.at(-1);
    return hit?.test ?? -1;
  }

  // From box to box, and into them.
  /** @param {KeyboardEvent} event */
  key(event) {
    const { frame, app } = this;
    if (!frame) return;
    const { first, next } = frame.followers, at = app.shownTest(frame);
    /** @type {number[]} */
    const siblings = [];
    if (frame.parents[at] >= 0) for (let i = first[frame.parents[at]]; i >= 0; i = next[i]) siblings.push(i);
    const beside = (/** @type {number} */ step) => siblings[siblings.indexOf(at) + step] ?? at;
    /** @type {Record<string, number | undefined>} */
    const arrows = { ArrowUp: frame.parents[at], ArrowDown: first[at], ArrowLeft: beside(-1), ArrowRight: beside(1) };
    const to = arrows[event.key];
    if (event.key === 'Enter') app.set({ root: at === this.root ? Math.max(frame.parents[at], 0) : at });
    else if (to === undefined) return;
    else if (to >= 0) app.set({ test: to, hover: -1 });
    event.preventDefault();
    event.stopPropagation();
  }
}
