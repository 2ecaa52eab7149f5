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
const short = (x) => (Math.abs(x) >= 1e6 || (x !== 0 && Math.abs(x) < 1e-4) ? x.toExponential(2) : String(+x.toPrecision(5)));
const percent = (part, whole) => `${whole > 0 ? ((100 * part) / whole).toFixed(1) : 0} %`;
const css = (color) => `rgb(${color.slice(0, 3).join(',')})`;

// What can be shown, by the keys 1, 2 and so on.
const modes = [
  { name: 'levels', text: 'Levels', about: 'The volumes of a level of the hierarchies' },
  { name: 'rejections', text: 'Rejections', about: 'The nodes at which paths of the traversal ended, colored by how' },
  { name: 'pairs', text: 'Pairs', about: 'The triangles that meet, and the lines in which they do' },
  { name: 'tests', text: 'Tests', about: 'How many volume tests each triangle took part in' },
  { name: 'wasted', text: 'Wasted', about: 'Of these, the tests that followed from a pair below which no triangles meet' },
  { name: 'traversal', text: 'Traversal', about: 'Every test, above those that followed from it' },
  { name: 'verdicts', text: 'Verdicts', about: 'The nodes of pairs that passed though no triangles below them meet, or that were rejected wrongly' },
];

// What words of the field mean.
const terms = {
  'N_v': 'tests of two volumes',
  'N_p': 'tests of two triangles',
  'passed on': 'pairs that overlap, whose children were tested next',
  'pairs': 'pairs of triangles that meet',
  'wasted N_v': 'volume tests that followed from a pair below which no triangles meet',
  'mean d': 'mean diameter of the volumes, 2r',
  'mean \u03c4': 'mean thickness of the volumes, e \u2212 f',
  'area': 'surface area of all volumes together',
  'volume': 'volume of all volumes together',
  'slack': 'by how much the step separates the two: positive if it does',
  'fit too loose': 'the volumes meet, but no triangles below them do',
  'test too weak': 'the volumes do not meet, but the test let them pass',
  'rejected wrongly': 'the test rejected volumes that overlap, or that hold triangles that meet',
  'c': 'center', 'r': 'radius of the ball', 'n': 'normal of the planes', 'e': 'height of the upper plane above the center', 'f': 'height of the lower plane',
};

const keys = [
  ['1 to 7', modes.map(({ text }) => text.toLowerCase()).join(', ')],
  ['arrows', 'turn; with Shift, move'],
  ['+ \u2212', 'nearer, farther'],
  ['[ ]', 'one level up, down'],
  [', .', 'one frame back, on'],
  ['Space', 'play the frames'],
  ['X Y Z', 'look along an axis; with Shift, from the other side'],
  ['F', 'fit'],
  ['O', 'orthographic or perspective'],
  ['M', 'the meshes'],
  ['E', 'edges of the meshes'],
  ['K', 'a plane that cuts'],
  ['D', 'outlines of what differs'],
  ['T', 'light or dark'],
  ['P', 'the parent of the node'],
  ['C', 'its first child'],
  ['N', 'its next sibling'],
  ['A', 'closer: the node, or what is marked'],
  ['I', 'only what is below the node'],
  ['/', 'search a node, or a test'],
  ['V', 'the traversal by how tests ended, or by what they were worth'],
  ['in the traversal', 'Tab to icicle or matrix, arrows from test to test, Enter enlarges one, or leads back'],
  ['S', 'save a PNG'],
  ['G', 'save the volumes as GLB'],
  ['Esc', 'nothing chosen'],
  ['H', 'this help'],
];

class Panel {
  constructor(app) {
    this.app = app;
    this.root = document.getElementById('panel');
    const { manifest, state } = app, { bodies } = app.longest;
    this.level = this.slider('Level', 0, app.depth, () => state.level, (value) => app.set({ level: value }));
    this.bodyLevels = bodies.length > 1
      ? bodies.map((body, i) => this.slider(body.name, 0, app.depth, () => state.levels[i] ?? state.level, (value) => app.set({ levels: { ...state.levels, [i]: value } })))
      : [];
    this.opacity = this.slider('Opacity', 0, 100, () => Math.round(100 * state.opacity), (value) => app.set({ opacity: value / 100 }), '%');
    this.frame = manifest.frames.length > 1
      ? this.slider('Frame', 0, manifest.frames.length - 1, () => state.at, (value) => app.set({ at: value }), '', () => String(manifest.frames[state.at]))
      : null;
    this.updates = [];
    this.chart = new FrameChart(app);
    if (this.frame) this.frame.append(this.button('Play', 'Space', () => app.play(), () => app.playing));
    this.search = element('input', { type: 'search', placeholder: app.hasQueries ? 'node, A:node, or two: 5,7' : 'node, or body:node', spellcheck: false });
    this.search.setAttribute('aria-label', 'Search a node by its number');
    this.search.addEventListener('keydown', (event) => {
      event.stopPropagation();
      if (event.key === 'Enter') app.find(this.search.value);
      if (event.key === 'Escape') app.canvas.focus();
    });
    for (const part of ['numbers', 'commands', 'legend', 'query', 'clip']) this[part] = element('div');
    this.node = element('div', { 'aria-live': 'polite' });
    this.ofLevels = [];
    const ofLevels = (...elements) => (this.ofLevels.push(...elements), elements);
    const toggle = (text, key, title) => this.button(text, title, () => app.set({ [key]: !state[key] }), () => state[key]);
    const shown = modes.filter(({ name }) => name === 'levels' || app.hasQueries);
    this.root.append(
      ...(shown.length > 1 ? [element('div', { className: 'row', role: 'group', 'aria-label': 'What is shown' },
        ...shown.map(({ name, text, about }, i) => this.button(text, `${about} (key ${i + 1})`, () => app.set({ mode: name }), () => state.mode === name)))] : []),
      ...(this.frame ? [this.frame, ...this.chart.parts()] : []),
      this.query,
      ...ofLevels(element('h2', { textContent: 'Levels' }), this.level),
      ...(this.bodyLevels.length ? ofLevels(element('details', {}, element('summary', { textContent: 'Each body by itself' }), ...this.bodyLevels)) : []),
      ...ofLevels(this.numbers),
      element('h2', { textContent: bodies.length > 1 ? 'Node, triangle or pair' : 'Node or triangle' }), element('label', {}, element('span', { textContent: 'Search' }), this.search), this.node,
      element('h2', { textContent: 'Look' }), ...ofLevels(this.opacity),
      ...(bodies.length > 1 ? [element('div', { className: 'row' }, ...bodies.slice(0, 24).map((body, b) => this.button(body.name, 'Show or hide this body', () => app.set({ without: state.without.includes(b) ? state.without.filter((one) => one !== b) : [...state.without, b] }), () => !state.without.includes(b))))] : []),
      element('div', { className: 'row' }, toggle('Meshes', 'mesh', 'M'), toggle('Edges', 'edges', 'E'), toggle('Orthographic', 'orthographic', 'O'),
        this.button('Dark', 'T', () => app.set({ theme: state.theme === 'dark' ? 'light' : 'dark' }), () => state.theme === 'dark'),
        this.button('Clip', 'A plane that cuts (K)', () => this.toggleClip(), () => state.clip !== null),
        ...(app.columns.length === 2 && manifest.same_nodes ? [toggle('Differences', 'differences', 'Outline what differs (D)')] : [])),
      this.clip,
      element('div', { className: 'row' }, this.button('Fit', 'All of it (F)', () => app.fit()), this.button('Closer', 'Go to the node that is chosen, or to what is marked (A)', () => app.approach()), ...['x', 'y', 'z'].map((axis, i) => this.button(axis.toUpperCase(), `Look along ${axis}`, () => app.along(i, 1))),
        this.button('PNG', 'Save what is seen (S)', () => app.save()), this.button('GLB', 'Save the volumes that are shown, or the one that is chosen (G)', () => this.saveGlb()), this.button('Keys', 'H', () => app.help())),
      ...ofLevels(element('h2', { textContent: 'Color' }), this.legend),
      element('h2', { textContent: 'The same without a browser' }), this.commands,
    );
    const help = document.getElementById('help');
    help.append(element('h2', { textContent: 'Keys' }), element('table', {}, ...keys.map(([key, what]) => element('tr', {}, element('td', {}, element('kbd', { textContent: key })), element('td', { textContent: what })))),
      element('p', { className: 'faint', textContent: 'Drag to turn, with Shift or the right button to move, wheel or pinch to zoom. Click a volume, a triangle or a line of contact to ask about it. Words with dots below them say what they mean under the mouse.' }),
      element('form', { method: 'dialog' }, element('button', { textContent: 'Close' })));
    this.drawLegend();
  }

  button(text, title, act, pressed) {
    const made = this.chooser(text, title, act);
    const update = () => made.setAttribute('aria-pressed', pressed() ? 'true' : 'false');
    if (pressed) this.updates.push(update);
    return made;
  }
  // One that is made anew at each update.
  chooser(text, title, act, pressed = null) {
    const made = element('button', { type: 'button', textContent: text, title });
    made.addEventListener('click', act);
    if (pressed !== null) made.setAttribute('aria-pressed', pressed ? 'true' : 'false');
    return made;
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
    const { legend } = this.app.manifest;
    if (legend) this.legend.append(...this.scale(legend.title, legend.ticks));
    else this.legend.append(...this.app.longest.bodies.map((body) => element('div', {}, this.key(body.color), body.name)));
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

  word(text) {
    return terms[text] ? element('abbr', { textContent: text, title: terms[text] }) : text;
  }
  table(rows) {
    return element('table', {}, ...rows.map(([name, ...values]) => element('tr', {}, element('td', {}, this.word(name)), ...values.map((value) => element('td', {}, value)))));
  }
  faint(text) {
    return element('div', { className: 'faint', textContent: text });
  }

  update() {
    const { app } = this, { state } = app;
    for (const slider of [this.level, ...this.bodyLevels, this.opacity, ...(this.frame ? [this.frame] : [])]) slider.update();
    for (const update of this.updates) update();
    this.chart.update();
    for (const part of this.ofLevels) part.hidden = state.mode !== 'levels';
    this.query.replaceChildren(...(state.mode === 'levels' ? [] : this.queryParts()));
    if (state.mode === 'levels') this.numbers.replaceChildren(...this.levelNumbers());
    this.clip.replaceChildren(...(state.clip ? this.clipParts() : []));
    this.showCommands();
    const { selected } = state, chosen = state.pair ?? selected;
    if (state.pair) this.showPair(state.pair);
    else if (selected) this.showNode(selected);
    else this.node.replaceChildren(this.faint('Click a volume, or search its number.'));
    if (chosen && chosen !== this.shown) this.node.scrollIntoView({ block: 'nearest' });
    this.shown = chosen;
  }

  showCommands() {
    const { app } = this;
    this.commands.replaceChildren(...(app.commands().length ? app.commands().map((command) => element('code', { textContent: command })) : [this.faint('scb draws two kinds of volumes at a time.')]));
  }

  // The level that is shown in numbers, body by body; a column of the table for each column of the scene.
  levelNumbers() {
    const { app } = this, many = app.columns.length > 1;
    return app.longest.bodies.flatMap((body, b) => {
      const level = Math.min(app.levelOf(b), app.depth), of = app.columns.map(({ bodies }) => bodies[b]?.tree.told.levels).map((levels) => levels?.[Math.min(level, levels.length - 1)]);
      const row = (name, i, words) => [name, ...of.map((numbers) => (numbers ? words(numbers[i]) : ''))];
      return [this.faint(`${app.longest.bodies.length > 1 ? `${body.name}, level` : 'Level'} ${level} of ${app.depth}`),
        this.table([...(many ? [['', ...app.columns.map(({ title }) => title)]] : []), row('volumes', 0, counted), row('mean d', 1, short), row('mean \u03c4', 2, short), row('area', 3, short), row('volume', 4, short)])];
    });
  }

  // What a plane cuts away, by axis and place.
  toggleClip() {
    const { app } = this, backward = app.view.axes[2], axis = backward.map(Math.abs).indexOf(Math.max(...backward.map(Math.abs)));
    this.setClip(app.state.clip ? null : axis, 0, Math.sign(backward[axis]) || 1);
  }
  setClip(axis, place, sign) {
    if (axis === null) return this.app.set({ clip: null });
    const { center, radius } = ballAbout(this.app.ballsOf(0)), normal = [0, 1, 2].map((i) => (i === axis ? sign : 0));
    return this.app.set({ clip: { normal, offset: dot(center, normal) + sign * place * radius } });
  }
  clipParts() {
    const { normal, offset } = this.app.state.clip, { center, radius } = ballAbout(this.app.ballsOf(0)), axis = normal.findIndex((x) => Math.abs(x) === 1), sign = normal[axis] ?? 1;
    if (axis < 0) return [this.faint(`Cut at ${normal.map(short).join(', ')}: ${short(offset)}.`)];
    const place = radius > 0 ? (sign * (offset - dot(center, normal))) / radius : 0;
    const slider = this.slider('Cut at', -100, 100, () => Math.round(100 * place), (value) => this.setClip(axis, value / 100, sign), '', () => short(sign * offset));
    slider.update();
    return [element('div', { className: 'row' }, ...['x', 'y', 'z'].map((name, i) => this.chooser(name, `Cut across ${name}`, () => this.setClip(i, 0, sign), i === axis)),
      this.chooser('Other side', 'Keep the other side', () => this.setClip(axis, place, -sign))), slider];
  }

  // Numbers and endings of the query of each column.
  queryParts() {
    const { app } = this, { columns, state } = app, parts = [];
    if (columns.length > 1) parts.push(...this.comparison());
    columns.forEach(({ title, query }, k) => {
      const { frame } = app.scenes[k];
      if (columns.length > 1) parts.push(element('h2', { textContent: title }));
      if (!query) return parts.push(this.faint('No query of it is in the page.'));
      if (!frame) return parts.push(...this.otherFrames(query));
      if (columns.length === 1) parts.push(this.table(this.counts(k).map(([name, value]) => [name, value])));
      if (!frame.told.judged && ['wasted', 'verdicts'].includes(state.mode)) return parts.push(this.faint('What these tests were worth is not known: the recording tells no results, or its poses are not rigid.'));
      if (app.scenes[k].heat) return parts.push(...this.heatParts(k));
      if (state.mode === 'traversal') return parts.push(...(k === state.column ? this.testParts(k) : [this.chooser('Its traversal', '', () => app.set({ column: k }))]));
      if (state.mode === 'pairs') return parts.push(...this.pairParts(k));
      parts.push(...this.classParts(k), ...this.mostParts(k));
    });
    if (state.mode === 'rejections' || state.mode === 'verdicts')
      parts.push(element('div', { className: 'row' }, this.chooser('Large volumes too', 'Also those that are large for the few tests that ended at them', () => app.set({ focus: state.focus === 1 ? 0.5 : 1 }), state.focus === 1)));
    return parts;
  }

  counts(k) {
    const { query } = this.app.columns[k], { frame } = this.app.scenes[k];
    if (!frame) return [];
    const { told } = frame, passed = (frame.passed ??= frame.outcomes.reduce((sum, outcome) => sum + (outcome < 2 ? 1 : 0), 0));
    return [[query.told.objects ? 'pairs of nodes' : 'pairs', counted(told.pairs)], ['N_v', counted(told.n_v)], ['N_p', counted(told.n_p)], ['passed on', counted(passed)],
      ...(told.judged ? [['wasted N_v', `${counted(told.wasted)}, ${percent(told.wasted, told.n_v)}`]] : [])];
  }

  // The counts of all columns beside each other, and what differs.
  comparison() {
    const { app } = this, { columns, scenes, state } = app, of = columns.map((_, k) => this.counts(k)), rows = (of.find((counts) => counts.length) ?? []).map(([name], i) => [name, ...of.map((counts) => counts[i]?.[1] ?? '')]);
    const parts = [element('div', { className: 'wide' }, this.table([['', ...columns.map(({ title }) => title)], ...rows]))];
    if (!app.compares || scenes.some(({ frame }) => !frame)) return parts;
    const only = (k) => {
      const { query } = columns[1 - k], { frame } = scenes[k], other = scenes[1 - k].frame;
      return (frame.onlyHere ??= frame.a.reduce((sum, slot, i) => sum + (query.testOf(other, slot, frame.b[i]) < 0 ? 1 : 0), 0));
    };
    const rowsOf = [['tests only here', ...columns.map((_, k) => counted(only(k)))]];
    if (state.mode === 'pairs') rowsOf.push(['pairs only here', ...scenes.map(({ frame }) => counted(frame.told.only_here ?? 0))]);
    if (scenes.every(({ nodes }) => nodes) && state.mode !== 'traversal') rowsOf.push(['nodes that differ', ...scenes.map((_, k) => counted(app.content.differing(k).size))]);
    parts.push(this.table(rowsOf));
    if (scenes.some((_, k) => app.content.differing(k).size > app.content.outlines(k).size)) parts.push(this.faint('Too many differ for outlines.'));
    return parts;
  }

  otherFrames(query) {
    const { app } = this, have = query.told.frames.map(({ frame }) => frame);
    return [this.faint(`The page has no query of this frame, but of ${have.slice(0, 8).join(', ')}${have.length > 8 ? ', ...' : ''}; \u201c--queries\u201d of scb view adds others.`),
      ...(have.length ? [this.chooser(`Frame ${have[0]}`, '', () => app.set({ at: app.manifest.frames.indexOf(have[0]) }))] : [])];
  }

  heatParts(k) {
    const { app } = this, { bodies, query } = app.columns[k], { heat } = app.scenes[k], wasted = app.state.mode === 'wasted';
    const at = (n) => Math.log(n / 0.25) / Math.log(heat.end / 0.25), labels = [[0, '0']];
    for (let n = 1; at(n) < 0.85; n *= 10) labels.push([at(n), counted(n)]);
    return [...bodies.map((body, side) => this.table([[`${body.name}, most tests of a triangle`, counted(heat.counts[side].reduce((most, n) => Math.max(most, n), 0))]])),
      ...this.scale(wasted ? 'wasted tests of a triangle' : 'volume tests of a triangle', [...labels, [1, counted(heat.end)]]), ...(wasted ? this.worstParts(k, query) : [])];
  }

  pairParts(k) {
    const { app } = this, { bodies } = app.columns[k], { frame } = app.scenes[k];
    return bodies.map((body, side) => element('div', {}, this.key(body.color), `${body.name}: ${counted(frame.meeting[side].size)} triangles meet others`));
  }

  // How paths ended, or what tests were worth, to be chosen from.
  classParts(k) {
    const { app } = this, { query } = app.columns[k], { state } = app, { nodes, all, classes } = app.scenes[k], labels = app.labelsOf(query), verdicts = state.mode === 'verdicts';
    const names = labels.map(({ label }) => label), parts = [this.faint(`${verdicts ? 'Pairs' : 'Paths that ended'}; ${counted(nodes.length)} of ${counted(all)} nodes drawn, B hatched`)];
    labels.forEach((group, i) => {
      if (classes.counts[i] === 0 && !verdicts) return;
      const box = element('input', { type: 'checkbox', checked: !state.hidden.includes(group.label) }), output = element('output', { textContent: counted(classes.counts[i]) });
      box.addEventListener('change', () => app.set({ hidden: box.checked ? state.hidden.filter((label) => label !== group.label) : [...state.hidden, group.label] }));
      parts.push(element('label', { className: 'ending' }, box, element('span', {}, this.key(group[state.theme]), this.word(group.label)), output,
        this.chooser('only', `Only ${group.label}`, () => app.set({ hidden: names.filter((label) => label !== group.label) }))));
    });
    parts.push(element('div', { className: 'row' }, this.chooser('All', 'Show all of them', () => app.set({ hidden: [] })), this.chooser('None', 'Show none of them', () => app.set({ hidden: names }))));
    return verdicts ? [...parts, ...this.worstParts(k, query)] : parts;
  }

  // The nodes with the most rejections, or false passes.
  mostParts(k) {
    const { app } = this, { bodies, query } = app.columns[k], { frame } = app.scenes[k], verdicts = app.state.mode === 'verdicts';
    return bodies.flatMap((body, side) => {
      const most = query.mostOf(app.classesOf(frame), side, (group) => verdicts || query.told.groups[group].rejects, 5);
      if (most.length === 0) return [];
      return [this.faint(`nodes of ${body.name} with the most ${verdicts ? 'of these' : 'rejections'}`),
        element('div', { className: 'row' }, ...most.map(([slot, n]) => this.chooser(`${query.trees[side].order[slot]}: ${counted(n)}`, 'Choose this node', () => app.select(k, side, slot))))];
    });
  }

  // The tests of all frames in the page that cost the most.
  worstParts(k, query) {
    const { app } = this, many = query.told.frames.length > 1;
    return query.told.worst.flatMap((list, i) => {
      if (list.length === 0) return [];
      const { label } = query.told.worths[i], what = i + 1 === worth.wrong ? 'pairs missed' : 'tests wasted';
      return [this.faint(`worst, ${label}: ${what}`),
        element('div', { className: 'row' }, ...list.map(({ frame, test, cost }) => this.chooser(`${many ? `frame ${frame}: ` : ''}${counted(cost)}`, `Show test ${test}`, () => app.showTest(k, test, frame))))];
    });
  }

  // The test of the traversal that is looked at.
  testParts(k) {
    const { app } = this, { bodies, query } = app.columns[k], { frame, steps } = app.scenes[k], { state } = app, i = app.shownTest(frame);
    if (i < 0) return [this.faint('There are no tests.')];
    Icicle.follow(frame);
    const group = query.told.groups[frame.outcomes[i] - 2], verdict = query.told.worths[frame.worths[i] - 1], slots = [frame.a[i], frame.b[i]];
    const cell = state.cell && frame.cells?.all.get(state.cell.join());
    const rows = [
      ['test', counted(i)],
      ...bodies.map((body, side) => [`node of ${body.name}`, slots[side] < 0 ? 'none that a root leads to' : this.chooser(`${query.trees[side].order[slots[side]]}, depth ${query.trees[side].levelOf(slots[side])}`, 'Choose this node', () => app.select(k, side, slots[side]))]),
      ['how it ended', group ? group.label : `they overlap: ${bodies[frame.outcomes[i]].name} was divided`],
      ...(verdict ? [['worth', this.word(verdict.label)]] : []),
      ['tests that follow', counted(frame.sizes[i] - 1)],
    ];
    const parts = [this.faint(cell ? `Depth ${state.cell[0]} of ${bodies[0].name}, ${state.cell[1]} of ${bodies[1].name}: ${counted(cell.tests)} tests, ${counted(cell.rejected)} rejected` : 'A test, above those that follow from it'), this.table(rows), ...this.stepParts(k, i, steps)];
    parts.push(element('div', { className: 'row' }, this.chooser('By ending', 'Colors say how tests ended (V)', () => app.set({ by: 'ending' }), state.by === 'ending'), this.chooser('By worth', 'Colors say which passed in vain (V)', () => app.set({ by: 'worth' }), state.by === 'worth')));
    if (state.by === 'ending') parts.push(element('div', {}, this.key(passedOn(app.theme)), this.word('passed on')), ...query.told.groups.flatMap((g, n) => (frame.ended.counts[n] ? [element('div', {}, this.key(g[state.theme]), `${g.label}: ${counted(frame.ended.counts[n])}`)] : [])));
    else parts.push(element('div', {}, this.key(passedOn(app.theme, 0.5)), 'triangles below meet'), element('div', {}, this.key(passedOn(app.theme, 0.12)), 'rejected'), ...query.told.worths.map((w, n) => element('div', {}, this.key(w[state.theme]), this.word(w.label), `: ${counted(frame.judged.counts[n])}`)));
    return [...parts, ...this.worstParts(k, query)];
  }

  // The overlap test step by step, as scb explain prints it.
  stepParts(k, test, steps) {
    const { app } = this, told = steps?.[test], command = app.explain(k, test), parts = [];
    if (told) {
      const room = 'room' in told ? `, ${told.exact === 'disjoint' ? 'gap' : 'depth'} ${short(told.room)}` : '';
      const line = (step) => {
        const row = element('tr', { title: step.not_tried ?? step.error ?? step.stage, className: `step ${step.rejects ? 'decides' : step.not_tried ? 'skipped' : ''}` }, element('td', { textContent: step.formula }), element('td', { textContent: step.not_tried ? 'not tried' : short(step.slack) }));
        return row;
      };
      parts.push(element('details', { open: true }, element('summary', { textContent: `Steps: ${told.answer}; exactly ${told.exact}${room}` }),
        element('table', {}, element('tr', {}, element('td', { className: 'faint', textContent: 'step' }), element('td', {}, this.word('slack'))), ...told.steps.map(line))));
    } else if (command) {
      parts.push(this.faint('Its steps are not in the page (--steps adds more); this prints them:'));
    }
    return command ? [...parts, element('code', { textContent: command })] : parts;
  }

  // What became of the tests of a node, and with whom.
  nodeTests(body, k) {
    const { app } = this, { query, title, bodies } = app.columns[k], { frame } = app.scenes[k] ?? {}, slot = app.selectedSlot(k);
    if (!query || !frame || slot < 0) return [];
    const entry = frame.ended.sides[body].get(slot), of = app.columns.length > 1 ? `Tests, ${title}` : 'Tests';
    if (!entry) return [this.faint(`${of}: none`)];
    const passed = entry.tests - entry.counts.reduce((sum, n) => sum + n, 0), other = 1 - body, most = 12;
    const rows = query.told.groups.flatMap((group, i) => (entry.counts[i] > 0 ? [element('tr', {}, element('td', {}, this.key(group[app.state.theme]), group.label), element('td', { textContent: counted(entry.counts[i]) }))] : []));
    if (passed > 0) rows.push(element('tr', {}, element('td', {}, this.word('passed on')), element('td', { textContent: counted(passed) })));
    const tests = query.testsWith(frame, body, slot);
    const met = tests.slice(0, this.all ? 200 : most).map((test) => {
      const outcome = frame.outcomes[test], node = query.trees[other].order[(other === 0 ? frame.a : frame.b)[test]];
      const made = this.chooser(String(node), `${outcome < 2 ? 'they overlap' : query.told.groups[outcome - 2].label}; ${counted(frame.sizes[test] - 1)} tests follow`, () => app.showTest(k, test));
      made.prepend(this.key(outcome < 2 ? passedOn(app.theme) : query.told.groups[outcome - 2][app.state.theme]));
      return made;
    });
    const more = tests.length > met.length ? [this.chooser(this.all ? `${counted(tests.length - met.length)} more` : 'more', '', () => ((this.all = true), this.update()))] : [];
    return [this.faint(`${of}: ${counted(entry.tests)}`), element('table', {}, ...rows), this.faint(`with nodes of ${bodies[other].name}`), element('div', { className: 'row' }, ...met, ...more)];
  }

  // What a triangle meets, and how often it was tested.
  triangleParts(body, triangle) {
    const { app } = this, parts = [], own = app.state.selected.column;
    app.columns.forEach(({ query, bodies, title }, k) => {
      const { frame, heat } = app.scenes[k] ?? {};
      if (!query || !frame || query.told.objects || body > 1 || (k !== own && !app.manifest.same_nodes)) return;
      const meets = [], other = bodies[1 - body].name, kind = app.columns.length > 1 ? `${title}: ` : '';
      for (let i = 0; i < frame.pairs.length; i += 2) if (frame.pairs[i + body] === triangle) meets.push([frame.pairs[i], frame.pairs[i + 1]]);
      if (k === own) parts.push(this.faint(meets.length ? `It meets ${counted(meets.length)} of ${other}` : `It meets none of ${other}`), element('div', { className: 'row' }, ...meets.slice(0, 60).map((pair) => this.chooser(String(pair[1 - body]), 'Show this pair', () => app.selectPair(k, pair)))));
      if (heat) parts.push(this.table([[kind + (app.state.mode === 'wasted' ? 'wasted tests' : 'tests'), counted(heat.counts[body][triangle] ?? 0)]]));
    });
    return parts;
  }

  // A pair of triangles that meet.
  showPair([a, b, k, test]) {
    const { app } = this, { bodies, query } = app.columns[k], { frame } = app.scenes[k];
    if (!frame) return this.node.replaceChildren(this.faint('The page has no query of this frame.'));
    const rows = [a, b].map((triangle, side) => [`triangle of ${bodies[side].name}`, this.chooser(String(triangle), 'Choose this triangle', () => app.selectTriangle(k, side, triangle))]);
    const parts = [this.table(rows)];
    if (test >= 0 && test < frame.outcomes.length) parts.push(this.table([['in the leaves', `${query.trees[0].order[frame.a[test]]}, ${query.trees[1].order[frame.b[test]]}`]]), element('div', { className: 'row' }, this.chooser('The test of these leaves', '', () => app.showTest(k, test))));
    else parts.push(this.faint('Their leaves were not tested against each other.'));
    this.node.replaceChildren(...parts);
  }

  showNode({ column, body, slot, triangle }) {
    const { app } = this, tree = app.treeOf(column, body), depth = tree.levelOf(slot), chain = [];
    const link = (to) => this.chooser(String(tree.order[to]), 'Choose this node', () => app.select(column, body, to));
    for (let at = tree.parent[slot]; at >= 0; at = tree.parent[at]) chain.unshift(at);
    const children = Array.from({ length: Math.min(tree.children[slot], 8) }, (_, i) => tree.firstChild[slot] + i);
    const rows = [
      ['body', app.columns[column].bodies[body].name],
      ...(triangle === null ? [] : [['triangle', String(triangle)]]),
      [triangle === null ? 'node' : 'in the leaf', String(tree.order[slot])],
      ['depth', String(depth)],
    ];
    const parts = [this.table(rows), element('div', { className: 'row' }, this.chooser('Go to it', 'A', () => app.approach()), this.chooser('Only what is below it', 'I', () => app.set({ isolated: !app.state.isolated }), app.state.isolated))];
    if (triangle !== null) parts.push(...this.triangleParts(body, triangle));
    app.columns.forEach(({ title, bodies }, k) => {
      const at = app.selectedSlot(k), of = bodies[body]?.tree;
      if (at >= 0 && of.has(of.levelOf(at))) parts.push(this.faint(title), this.table(numbersText(of.volume(at), of.told.center)));
    });
    app.columns.forEach((_, k) => parts.push(...this.nodeTests(body, k)));
    if (chain.length) parts.push(this.faint('Above, from the root'), element('div', { className: 'row' }, ...chain.slice(-12).map(link)));
    parts.push(this.faint(tree.children[slot] ? `Children: ${counted(tree.children[slot])}` : 'A leaf'), element('div', { className: 'row' }, ...children.map(link)));
    this.node.replaceChildren(...parts);
  }

  // The volumes that are shown, of one column; or the node that is chosen.
  saveGlb() {
    const { app } = this, { selected } = app.state, k = selected?.column ?? app.state.column, { bodies } = app.columns[k], most = 20000;
    const chosen = selected && !app.state.isolated;
    const shown = chosen ? [{ b: selected.body, slot: selected.slot }]
      : bodies.flatMap((_, b) => (app.state.mode === 'levels' ? app.content.coverOf(k, b).map((slot) => ({ slot })) : (app.scenes[k].nodes ?? []).filter(({ side }) => side === b && !app.state.without.includes(b))).map(({ slot }) => ({ b, slot })));
    if (shown.length > most) return this.node.replaceChildren(this.faint(`These are ${counted(shown.length)} volumes; a file has ${counted(most)} at most. Choose a level further up.`));
    // Round things by fewer corners where there are many of them.
    const corners = shown.length <= 300 ? 48 : shown.length <= 4000 ? 24 : 12;
    const colors = new Map((app.scenes[k].nodes ?? []).map((node) => [`${node.side} ${node.slot}`, app.state.mode === 'traversal' ? bodies[node.side].color : app.labelsOf(app.columns[k].query)[node.group][app.state.theme]]));
    const file = glbOf(shown.map(({ b, slot }) => {
      const { name, tree } = bodies[b], volume = tree.volume(slot), node = tree.order[slot];
      return {
        name: `${name} ${node}`, ...solidOf(volume.shape, volume.numbers, tree.extrasOf(slot), corners), color: colors.get(`${b} ${slot}`) ?? volume.color,
        opacity: app.state.mode === 'levels' ? Math.max(app.state.opacity, 0.05) : 1, pose: app.poseOf(k, b), center: tree.told.center, id: node, depth: tree.levelOf(slot),
      };
    }), app.manifest.scene);
    if (file) app.offer(new Blob([file], { type: 'model/gltf-binary' }), 'glb');
    else this.node.replaceChildren(this.faint('No volumes are shown here.'));
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
