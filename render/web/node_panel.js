import { add } from './linear.js';
import { element, counted, short, faint, row, table, button, swatch } from './elements.js';
import { shapeNames } from './tree.js';
import { passedOn } from './icicle.js';

// The part of the panel about the selection: a node, a triangle or a pair of triangles.
export class NodePanel {
  all = false;  // more of the tests of a node

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.body = element('div', { 'aria-live': 'polite' });
    this.title = app.longest.bodies.length > 1 ? 'Node, triangle or pair' : 'Node or triangle';
    this.search = element('input', { type: 'search', placeholder: app.hasQueries ? 'node, A:node, or two: 5,7' : 'node, or body:node', spellcheck: false });
    this.search.setAttribute('aria-label', 'Search a node by its number');
    this.search.addEventListener('keydown', (event) => {
      event.stopPropagation();
      if (event.key === 'Enter') app.find(this.search.value).then((found) => found && app.canvas.focus());
      if (event.key === 'Escape') app.canvas.focus();
    });
  }

  parts() {
    return [element('label', {}, element('span', { textContent: 'Search' }), this.search), this.body];
  }

  update() {
    const { selected, pair } = this.app.state;
    this.body.replaceChildren(...(pair ? this.pairParts(pair) : selected ? this.nodeParts(selected) : [faint('Click a volume, or search its number.')]));
  }
  /** @param {string} text */
  say(text) {
    this.body.replaceChildren(element('p', { textContent: text }));
  }

  /** @param {SelectedNode} selected */
  nodeParts({ column, body, slot, triangle }) {
    const { app } = this, tree = app.treeOf(column, body), most = 12;
    /** @type {number[]} */
    const chain = [];
    const link = (/** @type {number} */ to) => button(String(tree.numberOf(to)), `Choose this node, depth ${tree.levelOf(to)}`, () => app.select(column, body, to));
    for (let at = tree.parent[slot]; at >= 0; at = tree.parent[at]) chain.unshift(at);
    const above = chain.length > most ? [link(chain[0]), element('span', { className: 'faint', textContent: `${chain.length - most} more \u2026` }), ...chain.slice(1 - most).map(link)] : chain.map(link);
    const children = Array.from({ length: Math.min(tree.children[slot], 8) }, (_, i) => tree.firstChild[slot] + i);
    /** @type {string[][]} */
    const rows = [
      ['body', app.columns[column].bodies[body].name],
      ...(triangle === null ? [] : [['triangle', String(triangle)]]),
      [triangle === null ? 'node' : 'in the leaf', tree.wordsOf(slot)],
      ['depth', String(tree.levelOf(slot))],
    ];
    /** @type {HTMLElement[]} */
    const parts = [table(rows), row(button('Go to it', 'A', () => app.approach()), button('Only what is below it', 'I', () => app.set({ isolated: !app.state.isolated }), app.state.isolated))];
    if (triangle !== null) parts.push(...this.triangleParts(column, body, triangle));
    app.columns.forEach(({ title, bodies }, k) => {
      const at = app.selectedSlot(k), of = bodies[body]?.tree;
      if (at >= 0 && of.has(of.levelOf(at))) parts.push(faint(title), table(numbersText(of.volume(at), of.stored.center)));
    });
    app.columns.forEach((_, k) => parts.push(...this.testParts(body, k)));
    if (chain.length) parts.push(faint('Above, from the root'), row(...above));
    return [...parts, faint(tree.children[slot] ? `Children: ${counted(tree.children[slot])}` : 'A leaf'), row(...children.map(link))];
  }

  // What became of the tests of a node, and with whom.
  /** @type {(body: number, k: number) => HTMLElement[]} */
  testParts(body, k) {
    const { app } = this, { query, title, bodies } = app.columns[k], frame = app.scenes[k]?.frame, slot = app.selectedSlot(k);
    if (!query || !frame || slot < 0 || body > 1) return [];
    const entry = frame.ended.sides[body].get(slot), of = app.columns.length > 1 ? `Tests, ${title}` : 'Tests';
    if (!entry) return [faint(`${of}: none`)];
    const { theme } = app.state, passed = entry.tests - entry.counts.reduce((sum, n) => sum + n, 0), other = 1 - body, most = 12;
    /** @type {(Node | string)[][]} */
    const rows = query.stored.groups.flatMap((group, i) => (entry.counts[i] > 0 ? [[element('span', {}, swatch(group[theme]), group.label), counted(entry.counts[i])]] : []));
    if (passed > 0) rows.push(['passed on', counted(passed)]);
    const tests = query.testsWith(frame, body, slot);
    const met = tests.slice(0, this.all ? 200 : most).map((test) => {
      const at = (other === 0 ? frame.a : frame.b)[test], number = query.trees[other].numberOf(at), group = query.stored.groups[frame.outcomes[test] - 2];
      const made = button(String(number), `${query.endingOf(frame, test)}; ${counted(frame.followers.sizes[test] - 1)} tests follow`, () => app.showTest(k, test));
      made.prepend(swatch(group ? group[theme] : passedOn(app.theme)));
      return made;
    });
    const more = tests.length > met.length ? [button(this.all ? `${counted(tests.length - met.length)} more` : 'more', '', () => ((this.all = true), this.update()))] : [];
    return [faint(`${of}: ${counted(entry.tests)}`), table(rows), faint(`with nodes of ${bodies[other].name}`), row(...met, ...more)];
  }

  // What a triangle meets, and how often it was tested.
  /** @type {(own: number, body: number, triangle: number) => HTMLElement[]} */
  triangleParts(own, body, triangle) {
    const { app } = this;
    /** @type {HTMLElement[]} */
    const parts = [];
    app.columns.forEach(({ query, bodies, title }, k) => {
      const frame = app.scenes[k]?.frame, heat = app.scenes[k]?.heat;
      if (!query || !frame || query.stored.objects || body > 1 || (k !== own && !app.manifest.same_nodes)) return;
      /** @type {number[][]} */
      const meets = [];
      const other = bodies[1 - body].name, kind = app.columns.length > 1 ? `${title}: ` : '';
      for (let i = 0; i < frame.pairs.length; i += 2) if (frame.pairs[i + body] === triangle) meets.push([frame.pairs[i], frame.pairs[i + 1]]);
      if (k === own) parts.push(faint(meets.length ? query.stored.distance ? `The closest of ${other}` : `It meets ${counted(meets.length)} of ${other}` : query.stored.distance ? 'It is not the closest' : `It meets none of ${other}`), row(...meets.slice(0, 60).map((pair) => button(String(pair[1 - body]), 'Show this pair', () => app.selectPair(k, pair)))));
      if (heat) parts.push(table([[kind + (app.state.mode === 'wasted' ? 'wasted tests' : 'tests'), counted(heat.counts[body][triangle] ?? 0)]]));
    });
    return parts;
  }

  // A pair of triangles that meet, and where each column tested their leaves, or lost them.
  /** @param {number[]} pair */
  pairParts([a, b, k]) {
    const { app } = this, { bodies, query: own } = app.columns[k], slots = app.scenes.leaves;
    if (!app.scenes[k].frame || !slots || !own) return [faint('The page has no query of this frame.')];
    const rows = [a, b].map((triangle, side) => [`triangle of ${bodies[side].name}`, button(String(triangle), 'Choose this triangle', () => app.selectTriangle(k, side, triangle))]);
    /** @type {HTMLElement[]} */
    const parts = [table([...rows, ['in the leaves', slots.map((slot, side) => own.trees[side].numberOf(slot)).join()]])];
    app.columns.forEach(({ query, title }, at) => {
      const { frame } = app.scenes[at];
      if (!query || !frame || (at !== k && !app.manifest.same_nodes)) return;
      const many = app.columns.length > 1, found = at === k || frame.hasPair(a, b), test = query.testOf(frame, slots[0], slots[1]), lost = found ? -1 : query.lostAt(frame, ...slots);
      if (many) parts.push(faint(`${title}: ${found ? 'found' : 'missed'}`));
      if (lost >= 0) parts.push(row(button(`Lost at ${query.pairText(frame, lost)}: ${query.endingOf(frame, lost)}`, 'Show the test that ended its path', () => app.showTest(at, lost))));
      else if (test >= 0) parts.push(row(button('The test of these leaves', '', () => app.showTest(at, test))));
      else parts.push(faint('Their leaves were not tested against each other.'));
    });
    return parts;
  }
}

// The numbers of a volume as its type has them, in the body's frame.
/** @type {(volume: Volume, center: Vector) => string[][]} */
function numbersText({ shape, numbers, extras }, center) {
  const n = Array.from(numbers), point = (/** @type {number} */ i) => n.slice(i, i + 3).map(short).join(', ');
  const at = add(n.slice(0, 3), center).map(short).join(', ');
  switch (shapeNames[shape]) {
    case 'scb': return n[8] <= -n[3] && n[7] >= n[3] ? [['c', at], ['r', short(n[3])]] : [['c', at], ['r', short(n[3])], ['n', point(4)], ['e', short(n[7])], ['f', short(n[8])], ['e − f', short(n[7] - n[8])]];
    case 'scb2': return [['c', at], ['r', short(n[3])], ['n', point(4)], ['e', short(n[7])], ['f', short(n[12])], ['n″', point(8)], ['e″', short(n[11])], ['f″', short(n[13])]];
    case 'box': return [['center', at], ['half sides', [n[3], n[7], n[11]].map(short).join(', ')], ['axis 1', point(4)], ['axis 2', point(8)]];
    case 'polytope': return [['center', at], ['planes', counted(extras & 0x7fffffff)]];
    case 'rounded': return [['center', at], ['rounding', short(n[4])], ['points of the core', counted(extras)]];
    default: return [['volume', 'none']];
  }
}
