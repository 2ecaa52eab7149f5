import { modesOf } from './words.js';
import { element } from './elements.js';

// The modes as tabs in one row. Arrows, Home and End lead from tab to tab.
/** @type {(app: App) => { root: HTMLElement, update: () => void }} */
export function tabsOf(app) {
  const shown = modesOf(app).filter(({ name }) => name === 'levels' || app.hasQueries);
  const tabs = shown.map(({ name, text, about }, i) => {
    const tab = element('button', { type: 'button', role: 'tab', id: `tab-${name}`, textContent: text, title: `${about} (key ${i + 1})`, 'aria-controls': 'panel' });
    tab.addEventListener('click', () => app.set({ mode: name }));
    return tab;
  });
  const root = element('div', { className: 'tabs', role: 'tablist', 'aria-label': 'What is shown' }, ...tabs);
  root.addEventListener('keydown', (event) => {
    const now = tabs.findIndex((tab) => tab === document.activeElement), to = { ArrowLeft: now - 1, ArrowRight: now + 1, Home: 0, End: -1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const next = tabs.at(to % tabs.length);
    next?.focus();
    next?.click();
  });
  let last = '';
  return { root, update: () => {
    const { mode } = app.state;
    tabs.forEach((tab, i) => {
      tab.setAttribute('aria-selected', String(shown[i].name === mode));
      tab.tabIndex = shown[i].name === mode ? 0 : -1;
      // Into sight, where the row is wider than the page.
      if (shown[i].name === mode && mode !== last) root.scrollLeft = tab.offsetLeft - root.offsetLeft - (root.clientWidth - tab.offsetWidth) / 2;
    });
    last = mode;
    document.getElementById('panel')?.setAttribute('aria-labelledby', `tab-${mode}`);
  } };
}
