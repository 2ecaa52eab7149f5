import { element, counted, short, percent, faint, word, row, table, button, swatch, colorScale } from './elements.js';
import { worth } from './query.js';
import { passedOn } from './icicle.js';
import { section } from './sections.js';

// The part of the panel about the queries: numbers, endings and verdicts of tests, and one test step by step.
export class QueryPanel {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
  }

  // Of the query of each column.
  parts() {
    const { app } = this, { columns, state } = app, { selected } = state;
    /** @type {HTMLElement[]} */
    const parts = [];
    if (columns.length > 1) parts.push(section('Counts of the frame', true, ...this.comparison()));
    columns.forEach(({ title, query }, k) => {
      const { frame, heat, meeting, classes } = app.scenes[k], judged = frame?.stored.judged || !['wasted', 'verdicts'].includes(state.mode);
      if (columns.length > 1) parts.push(element('h2', { textContent: title }));
      if (!query) return parts.push(faint('No query of it is in the page.'));
      if (!frame) return parts.push(...this.otherFrames(query));
      const costly = (/** @type {HTMLElement[]} */ ...shown) => (shown.length ? [section('What cost the most', true, ...shown)] : []);
      if (!judged) parts.push(faint('What these tests were worth is not known: the recording tells no results, or its poses are not rigid.'));
      else if (heat) parts.push(...costly(...(state.mode === 'wasted' ? this.worstParts(k, query) : [])), section('What is shown', true, ...this.heatParts(k, heat)));
      else if (state.mode === 'traversal') parts.push(...(k === state.column ? [section('Test', true, ...this.testParts(k, frame)), ...costly(...this.worstParts(k, query))] : [button('Its traversal', '', () => app.set({ column: k }))]));
      else if (meeting) parts.push(section('What is shown', true, ...this.pairParts(k, frame, meeting)));
      else if (classes) parts.push(...costly(...(state.mode === 'verdicts' ? this.worstParts(k, query) : []), ...this.mostParts(k, query, classes)), section('What is shown', true, ...this.classParts(k, query, classes), ...this.differingParts(k, query)));
      if (columns.length === 1) parts.push(section('Counts of the frame', true, table(this.counts(k))));
    });
    if (state.mode === 'rejections' || state.mode === 'verdicts')
      parts.push(row(button('Large volumes too', 'Also large volumes at which few tests ended', () => app.set({ focus: state.focus === 1 ? 0.5 : 1 }), state.focus === 1)));
    return state.isolated && selected ? [faint(`Only tests below node ${app.treeOf(selected.column, selected.body).numberOf(selected.slot)} are shown and listed. The counts of the frame include all tests.`), ...parts] : parts;
  }

  /**
   * @param {number} k
   * @returns {string[][]}
   */
  counts(k) {
    const { frame } = this.app.scenes[k];
    if (!frame) return [];
    const { stored, passed, query } = frame;
    return [stored.distance !== undefined ? ['distance', short(stored.distance)] : [query.stored.objects ? 'pairs of nodes' : 'pairs', counted(stored.pairs)], ['N_v', counted(stored.n_v)], ['N_p', counted(stored.n_p)], ['passed on', counted(passed)],
      ...(stored.judged ? [['wasted N_v', counted(stored.wasted)], ['wasted share', percent(stored.wasted, stored.n_v)]] : [])];
  }

  // The counts of all columns beside each other, and what differs.
  comparison() {
    const { app } = this, { columns, scenes, state } = app, of = columns.map((_, k) => this.counts(k)), rows = (of.find((counts) => counts.length) ?? []).map(([name], i) => [name, ...of.map((counts) => counts[i]?.[1] ?? '')]);
    const titles = ['', ...columns.map(({ title }) => title)], wide = (/** @type {string[][]} */ more) => element('div', { className: 'wide' }, table([titles, ...rows, ...more]));
    const frames = scenes.flatMap(({ frame }) => frame ?? []);
    if (!app.compares || frames.length < 2) return [wide([])];
    const only = frames.map((frame, k) => {
      const other = frames[1 - k];
      return (frame.onlyHere ??= frame.a.reduce((sum, slot, i) => sum + (other.query.testOf(other, slot, frame.b[i]) < 0 ? 1 : 0), 0));
    });
    const more = [['tests only here', ...only.map(counted)]];
    if (state.mode === 'pairs') more.push(['pairs only here', ...scenes.map((_, k) => counted(app.content.pairsOnlyHere(k).length))]);
    if (scenes.every(({ nodes }) => nodes) && state.mode !== 'traversal') more.push(['nodes that differ', ...scenes.map((_, k) => counted(app.content.differing(k).size))]);
    return [wide(more), ...(scenes.some((_, k) => app.content.differing(k).size > app.content.outlines(k).size) ? [faint(`Too many differ for outlines in ${scenes.map((_, k) => k).filter((k) => app.content.differing(k).size > app.content.outlines(k).size).map((k) => columns[k].title).join(' and ')}.`)] : [])];
  }

  /** @param {Query} query */
  otherFrames(query) {
    const { app } = this, { frames } = app.manifest, have = query.stored.frames.map(({ frame }) => frame), now = frames[app.state.at];
    const nearest = have.reduce((best, frame) => (Math.abs(frame - now) < Math.abs(best - now) ? frame : best), have[0]);
    return [faint(`The page has no query of frame ${now}, but of ${have.slice(0, 8).join(', ')}${have.length > 8 ? ', ...' : ''}; \u201c--queries\u201d of scb view adds others.`),
      ...(have.length ? [row(button(`Frame ${nearest}`, 'The nearest with a query', () => app.set({ at: frames.indexOf(nearest) })))] : [])];
  }

  /** @type {(k: number, heat: Heat) => HTMLElement[]} */
  heatParts(k, heat) {
    const { app } = this, { bodies } = app.columns[k], scale = this.heatScale(heat), wasted = app.state.mode === 'wasted', what = wasted ? 'wasted tests' : 'volume tests';
    return [...bodies.map((body, side) => table([[`${body.name}, most ${what} of a triangle`, counted(heat.counts[side].reduce((most, n) => Math.max(most, n), 0))]])),
      ...colorScale(app.manifest.viridis, scale.title, scale.ticks)];
  }

  // Its title and its ticks.
  /** @param {Heat} heat */
  heatScale({ end }) {
    const at = (/** @type {number} */ n) => Math.log(n / 0.25) / Math.log(end / 0.25);
    /** @type {Tick[]} */
    const ticks = [[0, '0']];
    for (let n = 1; at(n) < 0.85; n *= 10) ticks.push([at(n), counted(n)]);
    ticks.push([1, counted(end)]);
    return { title: `${this.app.state.mode === 'wasted' ? 'wasted' : 'volume'} tests of a triangle`, ticks };
  }

  /** @type {(k: number, frame: QueryFrame, meeting: Set<number>[]) => HTMLElement[]} */
  pairParts(k, frame, meeting) {
    const { app } = this, { bodies } = app.columns[k], { query } = frame, { objects } = query.stored, only = app.content.pairsOnlyHere(k), most = 12, what = objects ? 'nodes' : 'triangles';
    if (query.stored.distance) return this.distanceParts(k, frame);
    const parts = bodies.map((body, side) => element('div', {}, swatch(body.color), `${body.name}: ${counted(meeting[side].size)} ${what} meet others`));
    if (!objects) parts.push(faint('Dashed, or pale: behind a body'));
    if (only.length === 0) return parts;
    const link = (/** @type {number[]} */ pair) => {
      if (!objects) return button(pair.join(), 'Choose this pair, and see where the other lost it', () => app.selectPair(k, pair));
      const slots = pair.map((node, side) => query.trees[side].slotOf(node));
      return button(slots.map((slot, side) => query.trees[side].numberOf(slot)).join(), 'Show their test', () => app.showTest(k, query.testOf(frame, slots[0], slots[1])));
    };
    return [...parts, faint(`Pairs of ${what} that only this one found${only.length > most ? `, the first ${most} of ${counted(only.length)}` : ''}`), row(...only.slice(0, most).map(link))];
  }

  // The closest triangles, and the tests whose bounds are the nearest to the distance.
  /** @type {(k: number, frame: QueryFrame) => HTMLElement[]} */
  distanceParts(k, frame) {
    const { app } = this, { bodies } = app.columns[k], { query, pairs, stored: { distance } } = frame;
    if (distance === undefined) return [faint('No triangles are within the limit.')];
    const closest = bodies.slice(0, 2).map((body, side) => [element('span', {}, swatch(body.color), `closest of ${body.name}`), button(String(pairs[side]), 'Choose this triangle', () => app.selectTriangle(k, side, pairs[side]))]);
    return [table([['distance', short(distance)], ...closest]), row(button('This pair', 'Choose the closest triangles', () => app.selectPair(k, [pairs[0], pairs[1]])), button('Go to it', 'A', () => app.approach())),
      faint(distance > 0 ? 'The line joins the closest points. Dashed, or pale: behind a body' : 'These triangles intersect.'), ...this.boundParts(k, frame), ...this.worstParts(k, query)];
  }

  // Tests by their bounds: those that were left out, and those that were divided in vain.
  /** @type {(k: number, frame: QueryFrame) => HTMLElement[]} */
  boundParts(k, frame) {
    const { app } = this, { query, outcomes, worths, bounds } = frame, most = 6;
    if (!bounds) return [];
    /** @type {[string, (test: number) => boolean][]} */
    const lists = [['left out', (i) => query.rejects(outcomes[i])], ['divided in vain', (i) => outcomes[i] < 2 && worths[i] !== worth.right]];
    return lists.flatMap(([name, wanted]) => {
      const tests = query.byBound(frame, wanted);
      const rows = tests.slice(0, most).map((i) => [button(query.pairText(frame, i), 'Show this test', () => app.showTest(k, i)), short(bounds[i]), outcomes[i] < 2 ? counted(frame.followers.sizes[i] - 1) : query.endingOf(frame, i)]);
      return tests.length === 0 ? [] : [faint(`${name}: ${counted(tests.length)}; the bounds nearest to the distance`), element('div', { className: 'wide bounds' }, table([['nodes', word('bound'), name === 'left out' ? 'by' : 'tests that follow'], ...rows]))];
    });
  }

  // Checkboxes for the endings of paths, or for the verdicts of tests.
  /** @type {(k: number, query: Query, classes: Classes) => HTMLElement[]} */
  classParts(k, query, classes) {
    const { app } = this, { bodies } = app.columns[k], { state } = app, { nodes = [], all = 0 } = app.scenes[k], labels = app.labelsOf(query), verdicts = state.mode === 'verdicts';
    const names = labels.map(({ label }) => label);
    /** @type {HTMLElement[]} */
    const parts = [faint(`${verdicts ? 'Pairs' : 'Paths that ended'}; ${counted(nodes.length)} of ${counted(all)} nodes drawn, those of ${bodies[1].name} hatched`)];
    labels.forEach((group, i) => {
      if (classes.counts[i] === 0 && !verdicts) return;
      const box = element('input', { type: 'checkbox', checked: !state.hidden.includes(group.label) }), output = element('output', { textContent: counted(classes.counts[i]) });
      box.addEventListener('change', () => app.set({ hidden: box.checked ? state.hidden.filter((label) => label !== group.label) : [...state.hidden, group.label] }));
      parts.push(element('label', { className: 'ending' }, box, element('span', {}, swatch(group[state.theme]), word(group.label)), output,
        button('only', `Only ${group.label}`, () => app.set({ hidden: names.filter((label) => label !== group.label) }))));
    });
    parts.push(row(button('All', 'Show all of them', () => app.set({ hidden: [] })), button('None', 'Show none of them', () => app.set({ hidden: names }))));
    return parts;
  }

  // The nodes with the most rejections, or false passes. Nodes with equal counts are sorted by their numbers.
  /** @type {(k: number, query: Query, classes: Classes) => HTMLElement[]} */
  mostParts(k, query, classes) {
    const { app } = this, { bodies } = app.columns[k], verdicts = app.state.mode === 'verdicts', most = 5;
    return bodies.flatMap((body, side) => {
      const all = query.mostOf(classes, side, (group) => verdicts || query.stored.groups[group].rejects);
      if (all.length === 0) return [];
      const rest = all.length > most && all[most][1] === all[most - 1][1] ? `; ${counted(all.slice(most).filter(([, n]) => n === all[most - 1][1]).length)} more have as many as the last` : '';
      return [faint(`nodes of ${body.name} with the most ${verdicts ? 'of these' : 'rejections'}${rest}`),
        row(...all.slice(0, most).map(([slot, n]) => button(`${query.trees[side].numberOf(slot)}: ${counted(n)}`, 'Choose this node', () => app.select(k, side, slot))))];
    });
  }

  // The nodes that differ from what the other column shows, those with the most tests first.
  /** @type {(k: number, query: Query) => HTMLElement[]} */
  differingParts(k, query) {
    const { app } = this, { bodies } = app.columns[k], differing = [...app.content.differing(k)].sort((x, y) => y.paths - x.paths), most = 5;
    return bodies.slice(0, 2).flatMap((body, side) => {
      const own = differing.filter((node) => node.side === side);
      if (own.length === 0) return [];
      return [faint(`${counted(own.length)} nodes of ${body.name} that the other does not show, or shows otherwise; those with the most tests`),
        row(...own.slice(0, most).map(({ slot, paths }) => button(`${query.trees[side].numberOf(slot)}: ${counted(paths)}`, 'Choose this node', () => app.select(k, side, slot))))];
    });
  }

  // The tests of all frames in the page that cost the most.
  /** @type {(k: number, query: Query) => HTMLElement[]} */
  worstParts(k, query) {
    const { app } = this, many = query.stored.frames.length > 1;
    return query.stored.worst.flatMap((list, i) => {
      if (list.length === 0) return [];
      const { label } = query.stored.worths[i], missing = i + 1 === worth.wrong;
      const rows = list.map(({ frame, test, nodes, n_v = 0, n_p = 0, missed = 0 }) => [button(nodes.join(), 'Show this test', () => app.showTest(k, test, frame)), ...(many ? [String(frame)] : []), ...(missing ? [counted(missed)] : [counted(n_v), counted(n_p)])]);
      return [element('div', { className: 'faint' }, many ? 'worst of all frames, ' : 'worst, ', word(label), missing ? ': pairs of triangles missed' : ': tests that followed in vain'),
        element('div', { className: 'wide worst' }, table([['nodes', ...(many ? ['frame'] : []), ...(missing ? ['missed'] : [word('N_v'), word('N_p')])], ...rows]))];
    });
  }

  // The test of the traversal that is looked at.
  /** @type {(k: number, frame: QueryFrame) => HTMLElement[]} */
  testParts(k, frame) {
    const { app } = this, { bodies } = app.columns[k], { query } = frame, { state } = app, i = app.shownTest(frame);
    if (i < 0) return [faint('There are no tests.')];
    const group = query.stored.groups[frame.outcomes[i] - 2], verdict = query.stored.worths[frame.worths[i] - 1], slots = [frame.a[i], frame.b[i]];
    const [x, y] = state.cell ?? [], cell = frame.cells.all.get(`${x},${y}`);
    /** @type {(Node | string)[][]} */
    const rows = [
      ['test', counted(i)],
      ...bodies.map((body, side) => [`node of ${body.name}`, slots[side] < 0 ? 'none that a root leads to' : button(`${query.trees[side].wordsOf(slots[side])}, depth ${query.trees[side].levelOf(slots[side])}`, 'Choose this node', () => app.select(k, side, slots[side]))]),
      ['how it ended', group ? group.label : `passed: ${query.dividesBoth(frame, i) ? 'both were' : `${bodies[frame.outcomes[i]].name} was`} divided`],
      ...(verdict ? [['worth', word(verdict.label)]] : []),
      ...(frame.bounds ? [['bound', `${short(frame.bounds[i])}${frame.stored.distance ? `, ${percent(frame.bounds[i], frame.stored.distance)} of the distance` : ''}`]] : []),
      ['tests that follow', counted(frame.followers.sizes[i] - 1)],
    ];
    const about = element('div', { className: 'faint test', textContent: cell ? `Depth ${x} of ${bodies[0].name}, ${y} of ${bodies[1].name}: ${counted(cell.tests)} tests, ${counted(cell.rejected)} rejected` : 'A test, above those that follow from it' });
    const parts = [about, table(rows), ...this.otherParts(k, frame, i), ...this.stepParts(k, query, i)];
    parts.push(row(button('By ending', 'Colors say how tests ended (V)', () => app.set({ by: 'ending' }), state.by === 'ending'), button('By worth', 'Colors say which passed in vain (V)', () => app.set({ by: 'worth' }), state.by === 'worth')));
    const legend = (/** @type {Color} */ color, /** @type {(Node | string)[]} */ ...words) => element('div', {}, swatch(color), ...words);
    if (state.by === 'ending') parts.push(legend(passedOn(app.theme), word('passed on')), ...query.stored.groups.flatMap((g, n) => (frame.ended.counts[n] ? [legend(g[state.theme], `${g.label}: ${counted(frame.ended.counts[n])}`)] : [])));
    else parts.push(legend(passedOn(app.theme, 0.5), query.stored.distance ? 'led to the answer' : 'triangles below meet'), legend(passedOn(app.theme, 0.12), query.stored.distance ? 'left out' : 'rejected'), ...query.stored.worths.map((w, n) => legend(w[state.theme], word(w.label), `: ${counted(frame.judged.counts[n])}`)));
    return parts;
  }

  // What the other column made of the same nodes.
  /** @type {(k: number, own: QueryFrame, test: number) => HTMLElement[]} */
  otherParts(k, own, test) {
    const { app } = this, other = 1 - k, frame = app.compares ? app.scenes[other].frame : null;
    if (!frame) return [];
    const { query } = frame, { title } = app.columns[other], there = query.testOf(frame, own.a[test], own.b[test]);
    if (there >= 0) return [table([[`in ${title}`, button(query.endingOf(frame, there), 'Show it there', () => app.showTest(other, there))]])];
    const lost = query.lostAt(frame, own.a[test], own.b[test]);
    return [table([[`in ${title}`, lost < 0 ? 'not tested' : button(`not tested: ended at ${query.pairText(frame, lost)}, ${query.endingOf(frame, lost)}`, 'Show the test that ended this path', () => app.showTest(other, lost))]])];
  }

  // The overlap test step by step, as scb explain prints it.
  /** @type {(k: number, query: Query, test: number) => HTMLElement[]} */
  stepParts(k, query, test) {
    const { app } = this, stored = app.scenes[k].steps?.[test], command = app.explain(k, test);
    /** @type {HTMLElement[]} */
    const parts = [];
    if (stored) {
      const lines = stored.steps.map((step) => element('tr', { title: step.not_tried ?? step.error ?? step.stage, className: `step ${step.rejects ? 'decides' : step.not_tried ? 'skipped' : ''}` },
        element('td', {}, step.formula, ...(step.error ? [element('div', { className: 'wrong', textContent: step.error })] : []), ...(step.not_tried && step.not_tried !== 'not reached' ? [faint(step.not_tried)] : [])),
        element('td', { textContent: step.not_tried ? 'not tried' : short(step.slack) })));
      parts.push(element('details', { open: true }, element('summary', { textContent: `Steps: ${stored.answer}` }),
        table([['exactly', stored.exact], ...(stored.room !== undefined ? [[stored.exact === 'disjoint' ? 'gap' : 'depth of overlap', short(stored.room)]] : [])]),
        element('table', {}, element('tr', {}, element('td', { className: 'faint', textContent: 'step, separates if' }), element('td', {}, word('slack'))), ...lines),
        ...symbolsOf(stored.steps, query.stored.symbols).map(faint)));
    } else if (command) {
      parts.push(faint('Its steps are not in the page (--steps adds more); this prints them:'));
    }
    return command ? [...parts, element('code', { textContent: command })] : parts;
  }
}

// What the symbols of the formulas mean.
/** @type {(steps: Step[], stored: string[]) => string[]} */
function symbolsOf(steps, stored) {
  const has = (/** @type {string} */ text) => steps.some(({ formula }) => formula.includes(text)), both = stored.join(' ').startsWith('0:'), first = [...(both ? [] : ['0: of A; 1: of B']), 'c1\u2032: B\u2019s center, from A\u2019s'];
  if (has('r0')) first.push('r: radius');
  if (!both && (has('d0') || has('d1'))) first.push('d: the other center, along the normal n');
  if (has('e0') || has('f0')) first.push('e, f: upper and lower plane');
  if (has('c\u03b1')) first.push('c\u03b1, s\u03b1: cosine and sine of the angle of the normals');
  return [`${first.join('; ')}. ${stored.join(' ')}`];
}
