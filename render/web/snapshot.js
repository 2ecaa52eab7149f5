import { modesOf } from './words.js';
import { element, contextOf, counted, css, short } from './elements.js';
import { passedOn } from './icicle.js';

// A picture of the current view that explains itself: title, numbers, the scene with its scale, the traversal, and a legend.
/** @param {App} app */
export function snapshotOf(app) {
  const { canvas, columns, theme } = app, ratio = window.devicePixelRatio || 1, margin = 12, line = 20;
  const tests = /** @type {HTMLElement} */ (document.getElementById('tests')), parts = [canvas, ...(tests.hidden ? [] : [tests])], width = canvas.clientWidth, middle = parts.reduce((sum, part) => sum + part.clientHeight, 0);
  const made = element('canvas'), context = contextOf(made), font = (/** @type {number} */ size, weight = 400) => (context.font = `${weight} ${size}px Roboto, system-ui, sans-serif`);
  const head = [{ text: document.title, size: 16, weight: 500 }, ...columns.map((_, k) => ({ text: numbersLine(app, k), size: 13, weight: 400 }))];
  // Rows of the legend, each entry with its square of color.
  font(13);
  const scale = scaleOf(app);
  /** @type {(Entry & { at: number })[][]} */
  const rows = [[]];
  let x = margin;
  for (const { color, text } of scale ? [] : entriesOf(app)) {
    const w = context.measureText(text).width + 36;
    if (x + w > width && rows[rows.length - 1].length > 0) {
      rows.push([]);
      x = margin;
    }
    rows[rows.length - 1].push({ at: x, color, text });
    x += w;
  }
  const top = margin + head.length * line + 4, bottom = scale ? 52 : rows.length * line + margin, height = top + middle + bottom;
  Object.assign(made, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.fillStyle = css(theme.background);
  context.fillRect(0, 0, width, height);
  context.textBaseline = 'middle';
  const write = (/** @type {string} */ text, /** @type {number} */ at, /** @type {number} */ y, room = width - at - margin) => {
    context.fillStyle = css(theme.text);
    let shown = text;
    while (shown.length > 1 && context.measureText(shown).width > room) shown = `${shown.slice(0, -2).trimEnd()}\u2026`;
    context.fillText(shown, at, y);
  };
  head.forEach(({ text, size, weight }, i) => {
    font(size, weight);
    write(text, margin, margin + (i + 0.5) * line);
  });
  context.drawImage(canvas, 0, top, width, canvas.clientHeight);
  if (!tests.hidden) for (const one of tests.querySelectorAll('canvas')) context.drawImage(one, one.offsetLeft, top + canvas.clientHeight + one.offsetTop, one.clientWidth, one.clientHeight);
  font(13);
  if (columns.length > 1) app.rectangles.forEach(([left, y, w], k) => write(columns[k].title, left / ratio + 8, top + y / ratio + 14, w / ratio - 16));
  const [barText, barLine] = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#bar > *')), size = parseFloat(barLine.style.width), y = top + canvas.clientHeight - 16;
  context.strokeStyle = css(theme.text);
  context.strokeRect(16, y, size, 0);
  write(barText.textContent ?? '', 16, y - 10);
  const legendTop = top + middle + margin / 2;
  if (scale) {
    const { title, ticks } = scale, room = Math.min(width - 2 * margin, 360);
    write(title, margin, legendTop + 8);
    for (let i = 0; i < room; ++i) {
      context.fillStyle = css(app.scaleColor(i / room));
      context.fillRect(margin + i, legendTop + 17, 1, 9);
    }
    ticks.forEach(([at, text], i) => {
      context.textAlign = i === 0 ? 'left' : at === 1 ? 'right' : 'center';
      write(text, margin + at * room, legendTop + 36, Infinity);
    });
    return made;
  }
  rows.forEach((row, i) => row.forEach(({ at, color, text }) => {
    context.fillStyle = css(color);
    context.fillRect(at, legendTop + i * line + 4, 11, 11);
    write(text, at + 17, legendTop + i * line + 10, width - at - 17);
  }));
  return made;
}

// The numbers of a column, in a line.
/** @type {(app: App, k: number) => string} */
function numbersLine(app, k) {
  const { state, manifest, columns } = app, { title, query } = columns[k], stored = query?.frames.get(manifest.frames[state.at]);
  const words = [modesOf(app).find(({ name }) => name === state.mode)?.text ?? '', ...(manifest.frames.length > 1 ? [`frame ${manifest.frames[state.at]}`] : []), ...(state.mode === 'levels' ? [`level ${state.level}`] : [])];
  if (stored && state.mode !== 'levels') words.push(stored.distance !== undefined ? `distance ${short(stored.distance)}` : `${counted(stored.pairs)} pairs`, `${counted(stored.n_v)} volume tests`, `${counted(stored.n_p)} triangle tests`, ...(stored.judged ? [`${counted(stored.wasted)} wasted`] : []));
  return (columns.length > 1 ? `${title}: ` : '') + words.join(', ');
}

// The scale of the colors; null where colors are of entriesOf.
/** @type {(app: App) => { title: string, ticks: Tick[] } | null} */
function scaleOf(app) {
  const { state, manifest } = app, heat = app.scenes[state.column]?.heat;
  return state.mode === 'levels' ? manifest.legend : heat ? app.panel.queryPanel.heatScale(heat) : null;
}

// Colors and what they mean.
/** @typedef {{ color: Color, text: string }} Entry */
/** @type {(app: App) => Entry[]} */
function entriesOf(app) {
  const { state, theme } = app, frame = app.scenes[state.column]?.frame;
  if (state.mode === 'levels' || state.mode === 'pairs' || !frame || app.isHeat) return app.columns[state.column].bodies.map(({ color, name }) => ({ color, text: name }));
  const { stored } = frame.query, verdicts = state.mode === 'verdicts' || (state.mode === 'traversal' && state.by === 'worth'), classes = verdicts ? frame.judged : frame.ended;
  const groups = (verdicts ? stored.worths : stored.groups).flatMap((group, i) => (classes.counts[i] > 0 && !state.hidden.includes(group.label) ? [{ color: group[state.theme], text: `${group.label}: ${counted(classes.counts[i])}` }] : []));
  return state.mode === 'traversal' && !verdicts ? [{ color: passedOn(theme), text: 'passed on' }, ...groups] : groups;
}
