// Pairs whose children were tested next: paler than what was rejected at the balls.
const passedOn = (theme) => theme.mesh.map((c, i) => Math.round(0.35 * c + 0.65 * theme.background[i]));

// The traversal of a query as an icicle: each test of volumes is a box as wide as all tests that follow from it, below the test that led
// to it. Where the mouse is, the scene shows the two nodes.
class Icicle {
  constructor(app) {
    this.app = app;
    this.canvas = document.getElementById('icicle');
    this.context = this.canvas.getContext('2d');
    const at = (event) => this.pick(event.offsetX, event.offsetY);
    this.canvas.addEventListener('pointermove', (event) => {
      const test = at(event);
      if (test !== app.state.test) app.hover(test);
    });
    this.canvas.addEventListener('click', (event) => {
      const test = at(event);
      // Once more on the box that fills the width leads up.
      if (test >= 0) app.set({ test, root: test === this.root ? this.frame.parents[test] : test });
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
    const groups = frame.counts.length, below = new Uint32Array(count * groups);
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
    const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight, theme = app.manifest.themes[app.state.theme];
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
    const groups = this.query.told.groups, stack = [[this.root, 0, above.length]], scale = width / frame.sizes[this.root];
    while (stack.length > 0) {
      const [test, x, depth] = stack.pop(), w = frame.sizes[test] * scale;
      if (depth * row > height) continue;
      this.box(test, x, depth * row, w, row, groups);
      let left = x + scale;  // its own test stands for itself
      for (let child = frame.first[test]; child >= 0; child = frame.next[child]) {
        const size = frame.sizes[child] * scale;
        if (size >= 0.5) stack.push([child, left, depth + 1]);
        left += size;
      }
    }
    for (const { test, x, y, w, h } of this.boxes) {
      if (test !== app.state.test) continue;
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

  box(test, x, y, w, h) {
    const { context, app } = this, outcome = this.frame.outcomes[test], theme = app.manifest.themes[app.state.theme];
    // What is too narrow for its ends has the color of most of them.
    const ending = outcome >= 2 ? outcome - 2 : w < 4 ? this.frame.dominant[test] : -1;
    context.fillStyle = css(ending < 0 ? passedOn(theme) : this.query.told.groups[ending][app.state.theme]);
    context.fillRect(x, y, Math.max(w - (w > 3 ? 1 : 0), 0.5), h - (h > 4 ? 1 : 0));
    this.boxes.push({ test, x, y, w, h });
    if (w < 60 || h < 14) return;
    context.fillStyle = css(outcome < 2 ? theme.text : [0, 0, 0]);
    context.font = '11px Roboto, system-ui, sans-serif';
    context.fillText(counted(this.frame.sizes[test]), x + 4, y + h / 2 + 3.5, w - 8);
  }

  // The test at a place; -1: none.
  pick(x, y) {
    return (this.boxes ?? []).findLast((box) => x >= box.x && x < box.x + box.w && y >= box.y && y < box.y + box.h)?.test ?? -1;
  }

  // From box to box, and into them.
  key(event) {
    const { frame, app } = this, { test } = app.state;
    if (!frame) return;
    const at = test >= 0 ? test : this.root, siblings = [];
    if (frame.parents[at] >= 0) for (let i = frame.first[frame.parents[at]]; i >= 0; i = frame.next[i]) siblings.push(i);
    const beside = (step) => siblings[siblings.indexOf(at) + step] ?? at;
    const to = { ArrowUp: frame.parents[at], ArrowDown: frame.first[at], ArrowLeft: beside(-1), ArrowRight: beside(1) }[event.key];
    if (event.key === 'Enter') app.set({ root: at === this.root ? frame.parents[at] : at });
    else if (to === undefined) return;
    else if (to >= 0) app.set({ test: to });
    event.preventDefault();
    event.stopPropagation();
  }
}
