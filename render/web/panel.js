import { dot } from './linear.js';
import { terms, concepts, keysOf } from './words.js';
import { element, counted, short, faint, row, table, button, slider, swatch, colorScale } from './elements.js';
import { ballAbout } from './camera.js';
import { FrameChart } from './frames.js';
import { QueryPanel } from './query_panel.js';
import { NodePanel } from './node_panel.js';
import { section } from './sections.js';
import { tabsOf } from './tabs.js';

// What is beside the scene.
export class Panel {
  /** @type {(() => void)[]} */
  updates = [];
  // What was, of each kind.
  /** @type {Map<string, unknown>} */
  chosen = new Map();
  // Shown with levels alone.
  /** @type {HTMLElement[]} */
  ofLevels = [];
  numbers = element('div');
  commands = element('div');
  query = element('div');
  clip = element('div');
  /** @type {HTMLDetailsElement | null} */
  eachLevel = null;

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.root = /** @type {HTMLElement} */ (document.getElementById('panel'));
    const { manifest, state } = app, { bodies } = app.longest;
    const kept = (/** @type {import('./elements.js').Slider} */ made) => (this.updates.push(() => made.update()), made);
    const several = bodies.length > 1, frames = manifest.frames.length;
    this.level = kept(slider('Level', 0, app.depth, () => state.level, (value) => app.set({ level: value })));
    const bodyLevels = several ? bodies.map((body, i) => kept(slider(body.name, 0, app.depth, () => state.levels[i] ?? state.level, (value) => app.set({ levels: { ...state.levels, [i]: value } })))) : [];
    const opacity = kept(slider('Opacity', 0, 100, () => Math.round(100 * state.opacity), (value) => app.set({ opacity: value / 100 }), () => `${Math.round(100 * state.opacity)}%`));
    const frame = frames > 1 ? kept(slider('Frame', 0, frames - 1, () => state.at, (value) => app.set({ at: value }), () => String(manifest.frames[state.at]))) : null;
    this.chart = new FrameChart(app);
    this.queryPanel = new QueryPanel(app);
    this.nodePanel = new NodePanel(app);
    const ofLevels = (/** @type {HTMLElement[]} */ ...elements) => (this.ofLevels.push(...elements), elements);
    /** @type {(text: string, key: 'mesh' | 'edges' | 'orthographic' | 'differences', title: string) => HTMLButtonElement} */
    const toggle = (text, key, title) => this.toggle(text, title, () => app.set({ [key]: !state[key] }), () => state[key]);
    this.meshes = toggle('Meshes', 'mesh', 'M');
    this.tabs = tabsOf(app);
    if (app.hasQueries) {
      document.querySelector('header')?.after(this.tabs.root);
      this.root.setAttribute('role', 'tabpanel');
      this.updates.push(() => this.tabs.update());
    }
    const { legend } = manifest;
    this.node = section(this.nodePanel.title, true, ...this.nodePanel.parts());
    this.root.append(
      ...app.columns.flatMap(({ title, verdict }) => verdict.map((line, i) => element('p', { className: 'verdict', textContent: (i === 0 && app.columns.length > 1 ? `${title}: ` : '') + line }))),
      ...(frame ? [section('Frame', true, frame, ...this.chart.parts(), row(this.toggle('Play', 'Space', () => app.play(), () => app.playing), button('\u2039', 'One frame back (,)', () => app.step(-1)), button('\u203a', 'One frame on (.)', () => app.step(1))))] : []),
      this.query,
      ...ofLevels(section('Levels', true, this.level,
        ...(bodyLevels.length ? [element('details', {}, element('summary', { textContent: 'Each body by itself' }), ...bodyLevels)] : []), this.numbers,
        ...(legend ? colorScale(manifest.viridis, legend.title, legend.ticks) : bodies.map((body) => element('div', {}, swatch(body.color), body.name))))),
      this.node,
      section('View', true,
        row(button('Fit', 'All of it (F)', () => app.fit()), button('Go to', 'Go to the node that is chosen, or to what is marked (A)', () => app.approach()), ...['x', 'y', 'z'].map((axis, i) => button(axis.toUpperCase(), `Look along ${axis}`, () => app.along(i, 1))), button('Keys', 'H', () => app.help())),
        ...(several ? [row(...bodies.slice(0, 24).map((body, b) => this.toggle(body.name, 'Show or hide this body', () => app.set({ without: state.without.includes(b) ? state.without.filter((one) => one !== b) : [...state.without, b] }), () => !state.without.includes(b))))] : []),
        this.clip),
      section('Look, and save', false, ...ofLevels(opacity),
        row(this.meshes, toggle('Edges', 'edges', 'E'), toggle('Orthographic', 'orthographic', 'O'),
          this.toggle('Dark', 'T', () => app.set({ theme: state.theme === 'dark' ? 'light' : 'dark' }), () => state.theme === 'dark'),
          this.toggle('Clip', 'A plane that cuts (K)', () => this.toggleClip(), () => state.clip !== null),
          ...(app.columns.length === 2 && manifest.same_nodes ? [toggle('Differences', 'differences', 'Outline differences (D)')] : [])),
        row(button('PNG', 'Save this view (S)', () => app.save()), button('GLB', 'Save the chosen volume, or all volumes in view (G)', () => app.saveGlb()))),
      section('The same without a browser', false, this.commands),
    );
    this.fillHelp();
  }

  fillHelp() {
    const { app } = this;
    const two = (/** @type {(Node | string)[][]} */ pairs) => element('table', {}, ...pairs.map(([key, what]) => element('tr', {}, element('td', {}, key), element('td', {}, what))));
    /** @type {HTMLElement} */ (document.getElementById('help')).append(
      element('form', { method: 'dialog' }, element('button', { textContent: 'Close' })),
      element('h2', { textContent: 'Keys' }), two(keysOf(app).map(([key, what]) => [element('kbd', { textContent: key }), what])),
      element('p', { className: 'faint', textContent: 'Drag to turn, with Shift or the right button to move, wheel or pinch to zoom. Click a volume, a triangle or a line of contact to ask about it. Words with dots below them say what they mean under the mouse.' }),
      element('h2', { textContent: 'Words' }), two(concepts.map((name) => [name, terms[name]])));
  }

  // A button that is pressed while `pressed` says so.
  /** @type {(text: string, title: string, act: () => unknown, pressed: () => boolean) => HTMLButtonElement} */
  toggle(text, title, act, pressed) {
    const made = button(text, title, act);
    this.updates.push(() => made.setAttribute('aria-pressed', pressed() ? 'true' : 'false'));
    return made;
  }

  update() {
    const { app } = this, { state } = app, levels = state.mode === 'levels';
    for (const update of this.updates) update();
    this.chart.update();
    // Elsewhere they are there in any case.
    this.meshes.disabled = !levels;
    for (const part of this.ofLevels) part.hidden = !levels;
    this.query.replaceChildren(...(levels ? [] : this.queryPanel.parts()));
    if (levels) this.numbers.replaceChildren(...this.levelNumbers());
    this.clip.replaceChildren(...(state.clip ? this.clipParts(state.clip) : []));
    this.showCommands();
    this.nodePanel.update();
    this.show('node', this.node, state.pair ?? state.selected);
    if (!levels) this.show('test', this.query.querySelector('.test'), state.hover < 0 && state.test >= 0 ? `${state.column} ${state.at} ${state.test}` : null);
  }

  // Brings the answer to what was just chosen into sight.
  /** @type {(of: string, part: Element | null, chosen: unknown) => void} */
  show(of, part, chosen) {
    const last = this.chosen.get(of);
    this.chosen.set(of, chosen);
    if (!part || !chosen || chosen === last) return;
    const folded = part.closest('details');
    if (folded) folded.open = true;
    const [box, all] = [part, this.root].map((one) => one.getBoundingClientRect());
    if (box.top < all.top || box.top > all.top + 0.6 * all.height) this.root.scrollTop += box.top - all.top - 4;
  }

  showCommands() {
    const { app } = this, { state } = app, commands = app.commands(), drawsAll = state.isolated || (state.without.length > 0 && !commands.some((command) => command.includes('--body ')));
    const notes = commands.length === 0 ? [app.manifest.commands[state.mode] ? 'scb draws two kinds of volumes at a time.' : Object.keys(app.manifest.commands).length ? app.measures ? 'None draws this of distances.' : 'None: scb inspect draws packed queries, see Verdicts.' : 'None: the scene was made in a program.'] : [...(drawsAll ? ['They draw all bodies, and all that is hidden here.'] : []), 'Files are named as in the folder where the page was made.'];
    this.commands.replaceChildren(...commands.map((command) => element('code', { textContent: command })), ...notes.map(faint));
  }

  // The level that is shown in numbers, body by body; a column of the table for each column of the scene.
  levelNumbers() {
    const { app } = this, many = app.columns.length > 1, titles = many ? [['', ...app.columns.map(({ title }) => title)]] : [];
    const parts = app.longest.bodies.flatMap((body, b) => {
      const level = Math.min(app.levelOf(b), app.depth), of = app.columns.map(({ bodies }) => bodies[b]?.tree.stored.levels).map((levels) => levels?.[Math.min(level, levels.length - 1)]);
      const line = (/** @type {string} */ name, /** @type {number} */ i, /** @type {(n: number) => string} */ words) => [name, ...of.map((numbers) => (numbers ? words(numbers[i]) : ''))];
      return [faint(`${app.longest.bodies.length > 1 ? `${body.name}, level` : 'Level'} ${level} of ${app.depth}`),
        table([...titles, line('volumes', 0, counted), line('mean d', 1, short), line('mean \u03c4', 2, short), line('area', 3, short), line('volume', 4, short)])];
    });
    return [...this.levelOverlaps(titles), ...parts];
  }

  // How many pairs of volumes overlap on each level, and which level first shows a gap.
  /** @param {string[][]} titles */
  levelOverlaps(titles) {
    const { app } = this, { state, columns, manifest } = app, number = manifest.frames[state.at];
    const of = columns.map(({ query }) => query?.frames.get(number)?.overlaps ?? []);
    if (of.every((counts) => counts.length === 0)) return app.hasQueries ? [faint('The page has no query of this frame, and no pairs of its levels.')] : [];
    // Of many pairs no more levels are counted.
    const last = (/** @type {number} */ k) => Math.max(...columns[k].bodies.slice(0, 2).map(({ tree }) => tree.depth));
    const isWhole = (/** @type {number[]} */ counts, /** @type {number} */ k) => counts.at(-1) === 0 || counts.length > last(k);
    const at = (/** @type {number} */ level) => of.map((counts, k) => (counts.length === 0 ? '' : level < counts.length ? counted(counts[level]) : counts.at(-1) === 0 ? '0' : isWhole(counts, k) ? counted(counts[counts.length - 1]) : 'over 20,000'));
    const gaps = of.map((counts, k) => (counts.length === 0 ? '' : counts.at(-1) === 0 ? `level ${counts.length - 1}` : isWhole(counts, k) ? 'none has one' : 'not counted so far'));
    const rows = Array.from({ length: Math.max(...of.map((counts) => counts.length)) }, (_, level) => [button(String(level), 'Show this level', () => app.set({ level }), level === state.level), ...at(level)]);
    const pairs = columns.map(({ query }) => query?.frames.get(number)).map((stored) => (stored ? (stored.distance !== undefined ? short(stored.distance) : counted(stored.pairs)) : ''));
    return [table([...titles, [app.measures ? 'distance' : 'pairs', ...pairs], ['overlapping pairs', ...at(state.level)], ['first level with a gap', ...gaps]]),
      (this.eachLevel = element('details', { open: this.eachLevel?.open ?? false }, element('summary', { textContent: 'Overlapping pairs of each level' }), table(rows)))];
  }

  // What a plane cuts away, by axis and place.
  toggleClip() {
    const { app } = this, backward = app.view.axes[2], axis = backward.map(Math.abs).indexOf(Math.max(...backward.map(Math.abs)));
    this.setClip(app.state.clip ? null : axis, 0, Math.sign(backward[axis]) || 1);
  }
  /** @type {(axis: number | null, place: number, sign: number) => Promise<void>} */
  setClip(axis, place, sign) {
    if (axis === null) return this.app.set({ clip: null });
    const { center, radius } = ballAbout(this.app.ballsOf(0)), normal = [0, 1, 2].map((i) => (i === axis ? sign : 0));
    return this.app.set({ clip: { normal, offset: dot(center, normal) + sign * place * radius } });
  }
  /** @param {Clip} clip */
  clipParts({ normal, offset }) {
    const { center, radius } = ballAbout(this.app.ballsOf(0)), axis = normal.findIndex((x) => Math.abs(x) === 1), sign = normal[axis] ?? 1;
    if (axis < 0) return [faint(`Cut at ${normal.map(short).join(', ')}: ${short(offset)}.`)];
    const place = radius > 0 ? (sign * (offset - dot(center, normal))) / radius : 0;
    return [row(...['x', 'y', 'z'].map((name, i) => button(name, `Cut across ${name}`, () => this.setClip(i, 0, sign), i === axis)),
      button('Other side', 'Keep the other side', () => this.setClip(axis, place, -sign))),
    slider('Cut at', -100, 100, () => Math.round(100 * place), (value) => this.setClip(axis, value / 100, sign), () => short(sign * offset))];
  }
}
