import { contextOf, counted, css } from './elements.js';

// Where in the two hierarchies a query made its tests: a cell for each depth of A's node, to the right, and depth of B's node, down.
// Where the mouse is, the scene shows the nodes of these tests and the icicle the tests.
export class Matrix {
  /** @type {QueryFrame | null} */
  frame = null;
  /** @type {number[] | null} */
  pinned = null;
  size = 0;  // of a cell
  corner = [0, 0];

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('matrix'));
    this.context = contextOf(this.canvas);
    const show = (/** @type {number[] | null} */ cell) => String(cell) !== String(app.state.cell) && app.set({ cell });
    this.canvas.addEventListener('pointermove', (event) => show(this.pick(event.offsetX, event.offsetY) ?? this.pinned));
    this.canvas.addEventListener('pointerleave', () => show(this.pinned));
    this.canvas.addEventListener('click', (event) => this.pin(this.pick(event.offsetX, event.offsetY)));
    this.canvas.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  /** @param {number[] | null} cell */
  pin(cell) {
    this.pinned = cell && String(cell) !== String(this.pinned) ? cell : null;
    this.app.set({ cell: this.pinned });
  }

  /** @param {QueryFrame} frame */
  show(frame) {
    this.frame = frame;
    if (!this.app.state.cell) this.pinned = null;
    this.draw();
  }

  draw() {
    const { canvas, context, frame, app } = this;
    if (!frame || canvas.clientWidth === 0) return;
    const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight, { theme } = app, { all, wide, high, most } = frame.cells;
    Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = css(theme.background);
    context.fillRect(0, 0, width, height);
    const left = 24, top = 20;
    this.size = Math.min((width - left - 22) / Math.max(wide, 1), (height - top - 42) / Math.max(high, 1), 18);
    this.corner = [left, top];
    const test = app.shownTest(frame), { trees } = frame.query;
    for (const { x, y, tests } of all.values()) {
      context.fillStyle = css(app.scaleColor(Math.log(tests + 1) / Math.log(most + 1)));
      context.fillRect(left + x * this.size, top + y * this.size, Math.max(this.size - 1, 1), Math.max(this.size - 1, 1));
    }
    const frameOf = (/** @type {number} */ x, /** @type {number} */ y) => {
      context.strokeStyle = css(theme.text);
      context.lineWidth = 2;
      context.strokeRect(left + x * this.size, top + y * this.size, this.size, this.size);
    };
    const { cell } = app.state;
    if (cell) frameOf(cell[0], cell[1]);
    else if (test >= 0) frameOf(trees[0].levelOf(frame.a[test]), trees[1].levelOf(frame.b[test]));
    context.fillStyle = css(theme.faint);
    context.font = '11px Roboto, system-ui, sans-serif';
    this.drawNumbers(frame.cells, left, top);
    const [name_a, name_b] = app.columns[app.state.column].bodies.map(({ name }) => `${name}, depth →`);
    context.fillText(name_a, left, 13, width - left);
    context.save();
    context.translate(13, top);
    context.rotate(Math.PI / 2);
    context.fillText(name_b, 0, 0, height - top);
    context.restore();
  }

  // Depths along both sides, and what the colors mean, where there is room.
  /** @type {(cells: Cells, left: number, top: number) => void} */
  drawNumbers({ wide, high, most }, left, top) {
    const { context, size, app, canvas } = this, step = [1, 2, 5, 10, 20].find((n) => n * size >= 22) ?? 50;
    context.textAlign = 'center';
    for (let x = step; x < wide; x += step) context.fillText(String(x), left + (x + 0.5) * size, top + high * size + 11);
    context.textAlign = 'left';
    for (let y = step; y < high; y += step) context.fillText(String(y), left + wide * size + 3, top + (y + 0.5) * size + 4);
    const y = top + high * size + 18, room = Math.min(canvas.clientWidth - left - 8, 150);
    if (y + 20 > canvas.clientHeight || room < 60) return;
    for (let i = 0; i < room; ++i) {
      context.fillStyle = css(app.scaleColor(i / room));
      context.fillRect(left + i, y, 1, 6);
    }
    context.fillStyle = css(app.theme.faint);
    context.fillText('0', left, y + 17);
    context.textAlign = 'right';
    context.fillText(`${counted(most)} tests`, left + room, y + 17);
    context.textAlign = 'left';
  }

  // The cell at a place, where there are tests.
  /** @type {(x: number, y: number) => number[] | null} */
  pick(x, y) {
    const cell = [Math.floor((x - this.corner[0]) / this.size), Math.floor((y - this.corner[1]) / this.size)];
    return this.frame?.cells.all.has(cell.join()) ? cell : null;
  }

  // From cell to cell.
  /** @param {KeyboardEvent} event */
  key(event) {
    /** @type {Record<string, number[] | undefined>} */
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const step = arrows[event.key];
    if (!step || !this.frame) return;
    const [x, y] = this.app.state.cell ?? [-step[0], -step[1]], next = [x + step[0], y + step[1]];
    if (this.frame.cells.all.has(next.join())) this.app.set({ cell: (this.pinned = next) });
    event.preventDefault();
    event.stopPropagation();
  }
}
