// What is beside the scene. Text from files is set as text, never as markup.
const element = (name, properties = {}, ...children) => {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties))
    if (key.startsWith('aria-') || key === 'for' || key === 'role') made.setAttribute(key, value);
    else made[key] = value;
  made.append(...children);
  return made;
};
const counted = (n) => n.toLocaleString('en-US');
const short = (x) => (Math.abs(x) >= 1e6 || (x !== 0 && Math.abs(x) < 1e-4) ? x.toExponential(4) : String(+x.toPrecision(6)));
const css = (color) => `rgb(${color.slice(0, 3).join(',')})`;

const keys = [
  ['1 to 6', 'levels, rejections, pairs, tests, wasted tests, traversal'],
  ['arrows', 'turn; with Shift, move'],
  ['+ −', 'nearer, farther'],
  ['[ ]', 'one level up, down'],
  [', .', 'one frame back, on'],
  ['Space', 'play the frames'],
  ['X Y Z', 'look along an axis; with Shift, from the other side'],
  ['F', 'fit'],
  ['O', 'orthographic or perspective'],
  ['M', 'the meshes'],
  ['E', 'edges of the meshes'],
  ['T', 'light or dark'],
  ['P', 'the parent of the node'],
  ['C', 'its first child'],
  ['N', 'its next sibling'],
  ['I', 'only what is below the node'],
  ['/', 'search a node'],
  ['S', 'save a PNG'],
  ['in the icicle', 'arrows from test to test, Enter enlarges one, or leads back'],
  ['Esc', 'no node'],
  ['H', 'this help'],
];

class Panel {
  constructor(app) {
    this.app = app;
    this.root = document.getElementById('panel');
    const { manifest } = app, { state } = app;
    this.level = this.slider('Level', 0, app.depth, () => state.level, (value) => app.set({ level: value }));
    this.bodyLevels = manifest.bodies.length > 1
      ? manifest.bodies.map((body, i) => this.slider(body.name, 0, app.depth, () => state.levels[i] ?? state.level, (value) => app.set({ levels: { ...state.levels, [i]: value } })))
      : [];
    this.opacity = this.slider('Opacity', 0, 100, () => Math.round(100 * state.opacity), (value) => app.set({ opacity: value / 100 }), '%');
    this.frame = manifest.frames.length > 1
      ? this.slider('Frame', 0, manifest.frames.length - 1, () => state.at, (value) => app.set({ at: value }), '', () => String(manifest.frames[state.at]))
      : null;
    this.buttons = [];
    const button = (text, title, act, pressed) => {
      const made = element('button', { type: 'button', textContent: text, title });
      made.addEventListener('click', act);
      if (pressed) this.buttons.push(() => made.setAttribute('aria-pressed', pressed() ? 'true' : 'false'));
      return made;
    };
    const toggle = (text, key) => button(text, '', () => app.set({ [key]: !state[key] }), () => state[key]);
    this.search = element('input', { type: 'search', placeholder: manifest.bodies.length > 1 ? 'node, or body:node' : 'node', spellcheck: false });
    this.search.setAttribute('aria-label', 'Search a node by its number');
    this.search.addEventListener('keydown', (event) => {
      event.stopPropagation();
      if (event.key === 'Enter') app.find(this.search.value);
      if (event.key === 'Escape') app.canvas.focus();
    });
    this.numbers = element('div');
    this.node = element('div', { 'aria-live': 'polite' });
    this.command = element('code');
    this.legend = element('div');
    this.query = element('div');
    const modes = app.queries.length ? [element('div', { className: 'row', role: 'group', 'aria-label': 'What is shown' },
      ...[['Levels', 'levels'], ['Rejections', 'rejections'], ['Pairs', 'pairs'], ['Tests', 'tests'], ['Wasted', 'wasted'], ['Traversal', 'traversal']].map(([text, mode], i) => button(text, `Key ${i + 1}`, () => app.set({ mode }), () => state.mode === mode)))] : [];
    this.ofLevels = [];
    const ofLevels = (...elements) => (this.ofLevels.push(...elements), elements);
    this.root.append(
      ...[
        ...modes, this.query, ...ofLevels(element('h2', { textContent: 'Levels' }), this.level), ...(this.bodyLevels.length ? ofLevels(element('details', {}, element('summary', { textContent: 'Each body by itself' }), ...this.bodyLevels)) : []),
        ...ofLevels(this.numbers),
        ...(this.frame ? [element('h2', { textContent: 'Frames' }), this.frame, element('div', { className: 'row' }, button('Play', 'Space', () => app.play(), () => app.playing))] : []),
        element('h2', { textContent: 'Look' }), ...ofLevels(this.opacity),
        element('div', { className: 'row' }, toggle('Meshes', 'mesh'), toggle('Edges', 'edges'), toggle('Orthographic', 'orthographic'),
          button('Dark', '', () => app.set({ theme: state.theme === 'dark' ? 'light' : 'dark' }), () => state.theme === 'dark')),
        element('div', { className: 'row' }, button('Fit', 'F', () => app.fit()), ...['x', 'y', 'z'].map((axis, i) => button(axis.toUpperCase(), `Look along ${axis}`, () => app.along(i, 1))),
          button('PNG', 'Save what is seen', () => app.save()), button('Keys', 'H', () => app.help())),
        ...ofLevels(element('h2', { textContent: 'Color' }), this.legend),
        element('h2', { textContent: 'Node' }), element('label', {}, element('span', { textContent: 'Search' }), this.search), this.node,
        element('h2', { textContent: 'A picture from this side, by scb' }), this.command,
      ],
    );
    const help = document.getElementById('help');
    help.append(element('h2', { textContent: 'Keys' }), element('table', {}, ...keys.map(([key, what]) => element('tr', {}, element('td', {}, element('kbd', { textContent: key })), element('td', { textContent: what })))),
      element('p', { className: 'faint', textContent: 'Drag to turn, with Shift or the right button to move, wheel or pinch to zoom. Click a volume to ask about it.' }),
      element('form', { method: 'dialog' }, element('button', { textContent: 'Close' })));
    this.drawLegend();
  }

  slider(text, least, most, read, write, unitText = '', words = null) {
    const input = element('input', { type: 'range', min: least, max: most, step: 1 }), output = element('output');
    input.setAttribute('aria-label', text);
    const made = element('label', {}, element('span', { textContent: text }), input, output);
    input.addEventListener('input', () => write(Number(input.value)));
    made.update = () => {
      input.value = read();
      output.textContent = words ? words() : read() + unitText;
      input.setAttribute('aria-valuetext', output.textContent);
    };
    return made;
  }

  drawLegend() {
    const { manifest } = this.app, { legend } = manifest;
    if (legend) this.legend.append(...this.scale(legend.title, legend.ticks));
    else this.legend.append(...manifest.bodies.map((body) => element('div', {}, this.key(body.color), body.name)));
  }

  // Colors from 0 to 1, and what they mean.
  scale(title, labels) {
    const bar = element('div', { className: 'scale' }), ticks = element('div', { className: 'ticks' });
    bar.style.background = `linear-gradient(to right, ${this.app.manifest.viridis.map(css).join(',')})`;
    for (const [at, text] of labels) {
      const tick = element('span', { textContent: text });
      tick.style.left = `${100 * at}%`;
      ticks.append(tick);
    }
    return [element('div', { className: 'faint', textContent: title }), bar, ticks];
  }

  key(color) {
    const made = element('span', { className: 'key' });
    made.style.background = css(color);
    return made;
  }

  table(rows) {
    return element('table', {}, ...rows.map(([name, value]) => element('tr', {}, element('td', { textContent: name }), element('td', {}, value))));
  }

  update() {
    for (const slider of [this.level, ...this.bodyLevels, this.opacity, ...(this.frame ? [this.frame] : [])]) slider.update();
    for (const update of this.buttons) update();
    for (const part of this.ofLevels) part.hidden = this.app.state.mode !== 'levels';
    this.query.replaceChildren(...(this.app.state.mode === 'levels' ? [] : this.queryParts()));
    this.numbers.replaceChildren(this.table(this.app.counts()));
    this.command.textContent = this.app.command();
    const { selected } = this.app.state;
    if (selected) this.showNode(selected);
    if (selected && selected !== this.shown) this.node.scrollIntoView({ block: 'nearest' });
    this.shown = selected;
    if (selected) return;
    this.node.replaceChildren(element('p', { className: 'faint', textContent: 'Click a volume, or search its number.' }));
  }

  // Numbers and endings of the query of each kind.
  queryParts() {
    const { app } = this, { manifest, state } = app, parts = [];
    app.queries.forEach((query, k) => {
      const { frame, nodes } = app.scenes[k];
      if (manifest.kinds.length > 1) parts.push(element('h2', { textContent: manifest.kinds[k].title }));
      if (!frame) {
        const have = query.told.frames.map((f) => f.frame);
        parts.push(element('p', { className: 'faint', textContent: `The page has no query of this frame, but of ${have.slice(0, 8).join(', ')}${have.length > 8 ? ', ...' : ''}; \u201c--queries\u201d of scb view adds others.` }));
        const go = element('button', { type: 'button', textContent: `Frame ${have[0]}` });
        go.addEventListener('click', () => app.set({ at: manifest.frames.indexOf(have[0]) }));
        if (have.length) parts.push(go);
        return;
      }
      const { told } = frame, passed = frame.outcomes.length - frame.counts.reduce((sum, n) => sum + n, 0);
      parts.push(this.table([['pairs', counted(told.pairs)], ['N_v', counted(told.n_v)], ['N_p', counted(told.n_p)], ['passed on', counted(passed)]]));
      const { heat } = app.scenes[k];
      if (heat) {
        if (state.mode === 'wasted') parts.push(this.table([['wasted N_v', `${counted(heat.total)}, ${((100 * heat.total) / told.n_v).toFixed(1)} %`]]));
        query.told.bodies.forEach((b, side) => parts.push(this.table([[`${manifest.bodies[b].name}, most tests of a triangle`, counted(heat.counts[side].reduce((most, n) => Math.max(most, n), 0))]])));
        const at = (n) => Math.log(n / 0.25) / Math.log(heat.end / 0.25), labels = [[0, '0']];
        for (let n = 1; at(n) < 0.85; n *= 10) labels.push([at(n), counted(n)]);
        parts.push(...this.scale(state.mode === 'wasted' ? 'wasted tests of a triangle' : 'volume tests of a triangle', [...labels, [1, counted(heat.end)]]));
        return;
      }
      if (state.mode === 'traversal') {
        if (k === state.kind) return parts.push(...this.testOf(query, frame));
        const other = element('button', { type: 'button', textContent: `Its traversal` });
        other.addEventListener('click', () => app.set({ kind: k, test: -1, root: 0 }));
        parts.push(other);
        return;
      }
      if (state.mode === 'pairs') {
        parts.push(...query.told.bodies.map((b, side) => element('div', {}, this.key(manifest.bodies[b].color), `${manifest.bodies[b].name}: ${counted(frame.meeting[side].size)} triangles meet others`)));
        return;
      }
      parts.push(element('div', { className: 'faint', textContent: `Paths that ended; ${counted(nodes.length)} of ${counted(app.scenes[k].all)} nodes drawn, B hatched` }));
      query.told.groups.forEach((group, i) => {
        if (frame.counts[i] === 0) return;
        const box = element('input', { type: 'checkbox', checked: !state.hidden.includes(group.label) }), output = element('output', { textContent: counted(frame.counts[i]) });
        box.addEventListener('change', () => app.set({ hidden: box.checked ? state.hidden.filter((label) => label !== group.label) : [...state.hidden, group.label] }));
        parts.push(element('label', { className: 'ending' }, box, element('span', {}, this.key(group[state.theme]), group.label), output));
      });
    });
    if (state.mode === 'rejections' && app.scenes[0].frame) {
      app.queries.forEach((query, k) => query.told.bodies.forEach((b, side) => {
        const of = app.manifest.kinds.length > 1 ? `${app.manifest.kinds[k].title}, ` : '';
        const buttons = query.mostRejected(app.scenes[k].frame, side, 5).map(([slot, n]) => {
          const made = element('button', { type: 'button', textContent: `${query.trees[side].order[slot]}: ${counted(n)}` });
          made.addEventListener('click', () => app.select(b, slot));
          return made;
        });
        if (buttons.length) parts.push(element('div', { className: 'faint', textContent: `${of}nodes of ${app.manifest.bodies[b].name} with the most rejections` }), element('div', { className: 'row' }, ...buttons));
      }));
      const all = element('button', { type: 'button', textContent: 'Large volumes too' });
      all.setAttribute('aria-pressed', state.focus === 1 ? 'true' : 'false');
      all.addEventListener('click', () => app.set({ focus: state.focus === 1 ? 0.5 : 1 }));
      parts.push(element('div', { className: 'row' }, all));
    }
    return parts;
  }

  // The test of the traversal that is looked at.
  testOf(query, frame) {
    const { app } = this, { manifest, state } = app, slots = app.slotsOfTest(frame), i = [state.test, state.root, 0].find((n) => n >= 0 && n < frame.outcomes.length) ?? -1;
    if (i < 0) return [element('p', { className: 'faint', textContent: 'There are no tests.' })];
    Icicle.follow(frame);
    const outcome = frame.outcomes[i], group = query.told.groups[outcome - 2];
    const rows = [
      ['test', counted(i)],
      ...[0, 1].map((side) => [`node of ${manifest.bodies[query.told.bodies[side]].name}`, `${query.trees[side].order[slots[side]]}, depth ${query.trees[side].levelOf(slots[side])}`]),
      ['how it ended', group ? group.label : `they overlap: ${manifest.bodies[query.told.bodies[outcome]].name} was divided`],
      ['tests that follow', counted(frame.sizes[i] - 1)],
    ];
    const go = (side) => {
      const made = element('button', { type: 'button', textContent: `Node of ${manifest.bodies[query.told.bodies[side]].name}` });
      made.addEventListener('click', () => app.select(query.told.bodies[side], slots[side]));
      return made;
    };
    return [element('div', { className: 'faint', textContent: 'A test, above those that follow from it' }), this.table(rows), element('div', { className: 'row' }, go(0), go(1)),
      element('div', {}, this.key(passedOn(manifest.themes[state.theme])), 'passed on'),
      ...query.told.groups.flatMap((g, k) => (frame.counts[k] ? [element('div', {}, this.key(g[state.theme]), `${g.label}: ${counted(frame.counts[k])}`)] : []))];
  }

  // What became of the tests of a node.
  testParts(body, slot) {
    const { app } = this, parts = [];
    app.queries.forEach((query, k) => {
      const side = query.told.bodies.indexOf(body), frame = app.scenes[k]?.frame;
      if (side < 0 || !frame) return;
      const found = query.testsOf(frame, side, slot);
      const title = app.manifest.kinds.length > 1 ? `Tests, ${app.manifest.kinds[k].title}` : 'Tests';
      parts.push(element('div', { className: 'faint', textContent: `${title}: ${found.tests ? counted(found.tests) : 'none'}` }));
      if (!found.tests) return;
      parts.push(element('table', {}, ...found.rows.map(([group, n]) => element('tr', {}, element('td', {}, this.key(group[app.state.theme]), group.label), element('td', { textContent: counted(n) }))),
        ...(found.passed ? [element('tr', {}, element('td', { textContent: 'passed on' }), element('td', { textContent: counted(found.passed) }))] : [])));
    });
    return parts;
  }

  // What a triangle meets, and how often it was tested.
  triangleParts(body, triangle) {
    const { app } = this, parts = [];
    app.queries.forEach((query, k) => {
      const side = query.told.bodies.indexOf(body), { frame, heat } = app.scenes[k] ?? {};
      if (side < 0 || !frame || query.told.objects) return;
      const meets = [];
      for (let i = 0; i < frame.pairs.length; i += 2) if (frame.pairs[i + side] === triangle) meets.push(frame.pairs[i + 1 - side]);
      const other = app.manifest.bodies[query.told.bodies[1 - side]].name;
      if (k === 0) parts.push(this.table([['meets', meets.length ? `${meets.length} of ${other}: ${meets.slice(0, 12).join(', ')}${meets.length > 12 ? ', ...' : ''}` : `none of ${other}`]]));
      const kind = app.manifest.kinds.length > 1 ? `${app.manifest.kinds[k].title}: ` : '';
      if (heat) parts.push(this.table([[kind + (app.state.mode === 'wasted' ? 'wasted tests' : 'tests'), counted(heat.counts[side][triangle])]]));
    });
    return parts;
  }

  showNode({ body, slot, triangle }) {
    const { app } = this, { manifest } = app;
    const link = (to) => {
      const made = element('button', { type: 'button', textContent: app.treeOf(0, body).order[to] });
      made.addEventListener('click', () => app.select(body, to));
      return made;
    };
    const tree = app.treeOf(0, body), depth = tree.levelOf(slot), chain = [];
    for (let at = tree.parent[slot]; at >= 0; at = tree.parent[at]) chain.unshift(at);
    const children = Array.from({ length: Math.min(tree.children[slot], 8) }, (_, i) => tree.firstChild[slot] + i);
    const rows = [
      ['body', manifest.bodies[body].name],
      ...(triangle === null ? [] : [['triangle', String(triangle)]]),
      [triangle === null ? 'node' : 'in the leaf', String(tree.order[slot])],
      ['depth', String(depth)],
    ];
    const parts = [this.table(rows), ...(triangle === null ? [] : this.triangleParts(body, triangle))];
    manifest.kinds.forEach((kind, k) => {
      const of = app.treeOf(k, body);
      if (of.has(depth)) parts.push(element('div', { className: 'faint', textContent: kind.title }), this.table(numbersText(of.volume(slot), of.told.center)));
    });
    parts.push(...this.testParts(body, slot));
    if (chain.length) parts.push(element('div', { className: 'faint', textContent: 'Above, from the root' }), element('div', { className: 'row' }, ...chain.slice(-12).map(link)));
    parts.push(element('div', { className: 'faint', textContent: tree.children[slot] ? `Children: ${counted(tree.children[slot])}` : 'A leaf' }), element('div', { className: 'row' }, ...children.map(link)));
    const only = element('button', { type: 'button', textContent: 'Only what is below it' });
    only.setAttribute('aria-pressed', app.state.isolated ? 'true' : 'false');
    only.addEventListener('click', () => app.set({ isolated: !app.state.isolated }));
    parts.push(element('div', { className: 'row' }, only));
    this.node.replaceChildren(...parts);
  }
}

// The numbers of a volume as its type has them, in the body's frame.
function numbersText({ shape, numbers, extras }, center) {
  const n = Array.from(numbers), point = (i) => n.slice(i, i + 3).map(short).join(', ');
  const at = add(n.slice(0, 3), center).map(short).join(', ');
  switch (shapeNames[shape]) {
    case 'scb': return n[8] <= -n[3] && n[7] >= n[3] ? [['c', at], ['r', short(n[3])]] : [['c', at], ['r', short(n[3])], ['n', point(4)], ['e', short(n[7])], ['f', short(n[8])], ['e − f', short(n[7] - n[8])]];
    case 'scb2': return [['c', at], ['r', short(n[3])], ['n1', point(4)], ['e1, f1', `${short(n[7])}, ${short(n[12])}`], ['n2', point(8)], ['e2, f2', `${short(n[11])}, ${short(n[13])}`]];
    case 'box': return [['center', at], ['half sides', [n[3], n[7], n[11]].map(short).join(', ')], ['axis 1', point(4)], ['axis 2', point(8)]];
    case 'polytope': return [['center', at], ['planes', counted(extras & 0x7fffffff)]];
    case 'rounded': return [['center', at], ['rounding', short(n[4])], ['points of the core', counted(extras)]];
    default: return [['volume', 'none']];
  }
}
