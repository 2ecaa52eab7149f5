import { terms } from './words.js';

// Parts of the panel. Text from files is set as text, never as markup.
/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} name
 * @param {Partial<HTMLElementTagNameMap[K]> & { [attribute: `aria-${string}`]: string, for?: string, role?: string }} properties
 * @param {...(Node | string)} children
 */
export const element = (name, properties = {}, ...children) => {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties))
    if (key.startsWith('aria-') || key === 'for' || key === 'role') made.setAttribute(key, String(value));
    else Object.assign(made, { [key]: value });
  made.append(...children);
  return made;
};
/** @param {number} n */
export const counted = (n) => n.toLocaleString('en-US');
/** @param {number} x */
export const short = (x) => (Math.abs(x) >= 1e6 || (x !== 0 && Math.abs(x) < 1e-4) ? x.toExponential(2) : String(+x.toPrecision(5)));
/** @type {(part: number, whole: number) => string} */
export const percent = (part, whole) => `${whole > 0 ? ((100 * part) / whole).toFixed(1) : 0} %`;
/** @param {Numbers} color */
export const css = (color) => `rgb(${color[0]},${color[1]},${color[2]})`;

/** @param {string} text */
export const faint = (text) => element('div', { className: 'faint', textContent: text });
// A word that says what it means, where it is one of the field's.
/** @param {string} text */
export const word = (text) => (terms[text] ? element('abbr', { textContent: text, title: terms[text] }) : text);
/** @param {...Node} children */
export const row = (...children) => element('div', { className: 'row' }, ...children);
/** @param {(Node | string)[][]} rows */
export const table = (rows) => element('table', {}, ...rows.map(([name, ...values]) => element('tr', {}, element('td', {}, typeof name === 'string' ? word(name) : name), ...values.map((value) => element('td', {}, value)))));

/** @type {(text: string, title: string, act: () => unknown, pressed?: boolean | null) => HTMLButtonElement} */
export const button = (text, title, act, pressed = null) => {
  const made = element('button', { type: 'button', textContent: text, title });
  made.addEventListener('click', act);
  if (pressed !== null) made.setAttribute('aria-pressed', pressed ? 'true' : 'false');
  return made;
};

// Has a method `update` that shows what `read` gives; `words` says it otherwise.
/** @typedef {HTMLLabelElement & { update: () => void }} Slider */
/** @type {(text: string, least: number, most: number, read: () => number, write: (value: number) => unknown, words?: () => string) => Slider} */
export const slider = (text, least, most, read, write, words = () => String(read())) => {
  const input = element('input', { type: 'range', min: String(least), max: String(most), step: '1' }), output = element('output');
  input.setAttribute('aria-label', text);
  input.addEventListener('input', () => write(Number(input.value)));
  const update = () => {
    input.value = String(read());
    output.textContent = words();
    input.setAttribute('aria-valuetext', output.textContent);
  };
  update();
  return Object.assign(element('label', {}, element('span', { textContent: text }), input, output), { update });
};

/** @param {HTMLCanvasElement} canvas */
export const contextOf = (canvas) => /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));

// A square of a color in a legend.
/** @param {Numbers} color */
export const swatch = (color) => {
  const made = element('span', { className: 'key' });
  made.style.background = css(color);
  return made;
};
// The colors of magnitudes from 0 to 1, and what they mean.
/** @type {(colors: Color[], title: string, labels: Tick[]) => HTMLElement[]} */
export const colorScale = (colors, title, labels) => {
  const bar = element('div', { className: 'scale' }), ticks = element('div', { className: 'ticks' });
  bar.style.background = `linear-gradient(to right, ${colors.map(css).join(',')})`;
  for (const [at, text] of labels) {
    const tick = element('span', { textContent: text });
    tick.style.left = `${100 * at}%`;
    ticks.append(tick);
  }
  return [faint(title), bar, ticks];
};
