import { element } from './elements.js';

const key = 'scb-sections';
// The sections that were opened or closed, by their titles, as long as the browser's tab is open.
/** @type {Record<string, boolean>} */
let chosen = {};
try {
  chosen = JSON.parse(sessionStorage.getItem(key) ?? '{}');
} catch {
  // In a frame of a notebook nothing can be stored.
}

// A part of the panel that folds.
/** @type {(title: string, isOpen: boolean, ...children: Node[]) => HTMLDetailsElement} */
export const section = (title, isOpen, ...children) => {
  const summary = element('summary', { textContent: title }), made = element('details', { className: 'section', open: chosen[title] ?? isOpen }, summary, ...children);
  made.addEventListener('toggle', () => {
    chosen[title] = made.open;
    try {
      sessionStorage.setItem(key, JSON.stringify(chosen));
    } catch {
      // See above.
    }
  });
  return made;
};
