'use strict';
// Everything that can be read without a script is in the page; this adds filters, ways to compare,
// and lists of commands. What is only of use with it has the class "script".
(() => {
  /** @type {(selector: string, root?: ParentNode) => HTMLElement[]} */
  const all = (selector, root = document) =>
    [.../** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll(selector))];
  /** @type {(selector: string, root?: ParentNode) => HTMLElement | null} */
  const find = (selector, root = document) => root.querySelector(selector);
  // An element that the template always has.
  const one = /** @type {(selector: string, root?: ParentNode) => HTMLElement} */ (find);
  /** @type {(target: EventTarget | null, selector: string) => HTMLElement | null} */
  const closest = (target, selector) =>
    target instanceof Element ? target.closest(selector) : null;
  // The case of an item of the navigation.
  /** @param {HTMLElement} item */
  const caseOf = (item) =>
    /** @type {HTMLElement} */ (document.getElementById(item.dataset.for ?? ''));
  const cases = all('.case');
  const stillness = matchMedia('(prefers-reduced-motion: reduce)');
  const mostZoom = 64;
  // Slow enough not to flash: under three changes a second.
  const blinkMilliseconds = 500;

  document.documentElement.classList.add('scripted');

  // --- pictures -------------------------------------------------------------------------------

  // What one case shows of its pictures. All pictures of a case move together.
  /**
   * @typedef {'side' | 'slider' | 'flip'} Mode
   * @typedef {object} Viewer
   * @property {HTMLElement} root
   * @property {HTMLElement[]} sets of pictures
   * @property {HTMLElement} set the one that is shown
   * @property {Mode} mode
   * @property {boolean} touched whether the reader has chosen the mode
   * @property {'baseline' | 'candidate'} shown
   * @property {number} at of the slider, in percent
   * @property {{ x: number, y: number, scale: number } | null} zoom null: the whole picture; else
   * the pixel in the middle, and how large a pixel is
   * @property {number[] | null} fitted the box that is zoomed to, however wide the page is; null:
   * the reader has zoomed or moved since
   * @property {number} blinking the timer, or 0
   */
  /** @type {Map<HTMLElement | null, Viewer>} */
  const viewers = new Map();
  /** @type {Mode} */
  let lastMode = 'side';

  /** @param {HTMLElement} root */
  function makeViewer(root) {
    const sets = all('.pictures', root);
    /** @type {Viewer} */
    const viewer = {
      root,
      sets,
      set: sets[0],
      mode: 'side',
      touched: false,
      shown: 'candidate',
      at: 50,
      zoom: null,
      fitted: boxOf(sets[0].dataset.box),
      blinking: 0,
    };
    sets.forEach((set, i) => (set.hidden = i > 0));
    all('[data-show-set]', root).forEach((button) =>
      button.addEventListener('click', () => showSet(viewer, button.dataset.showSet)));
    all('[data-set-mode]', root).forEach((button) =>
      button.addEventListener('click', () =>
        setMode(viewer, /** @type {Mode} */ (button.dataset.setMode))));
    all('[data-zoom]', root).forEach((button) =>
      button.addEventListener('click', () => zoomBy(viewer, button.dataset.zoom)));
    one('[data-flip]', root).addEventListener('click', () => flip(viewer));
    one('[data-blink]', root).addEventListener('click', () => blink(viewer));
    const slider = sliderOf(root);
    slider.addEventListener('input', () => slide(viewer, Number(slider.value)));
    sets.forEach((set) => dragIn(viewer, set));
    new ResizeObserver(() => update(viewer)).observe(root);
    update(viewer);
    return viewer;
  }

  /** @param {HTMLElement} root */
  const sliderOf = (root) => /** @type {HTMLInputElement} */ (one('.slide input', root));
  /** @param {Viewer} viewer */
  const isComparable = (viewer) => 'comparable' in viewer.set.dataset;
  /** @param {HTMLElement} set */
  const sizeOf = (set) => [Number(set.dataset.width), Number(set.dataset.height)];
  /** @param {string | undefined} text */
  const boxOf = (text) => (text ? text.split(' ').map(Number) : null);

  /** @type {(viewer: Viewer, name: string | undefined) => void} */
  function showSet(viewer, name) {
    const set = viewer.sets.find((s) => s.dataset.set === name);
    if (!set) return;
    viewer.set = set;
    viewer.sets.forEach((s) => (s.hidden = s !== set));
    if (!isComparable(viewer)) setMode(viewer, 'side', false);
    else update(viewer);
  }

  /** @param {Viewer} viewer @param {Mode} mode */
  function setMode(viewer, mode, touched = true) {
    if (mode !== 'side' && !isComparable(viewer)) return;
    if (mode !== 'flip') stopBlinking(viewer);
    viewer.mode = mode;
    viewer.touched ||= touched;
    if (touched) lastMode = mode;
    update(viewer);
  }

  /** @type {(viewer: Viewer, at: number) => void} */
  function slide(viewer, at) {
    viewer.at = Math.min(100, Math.max(0, at));
    update(viewer);
  }

  /** @param {Viewer} viewer */
  function flip(viewer) {
    if (!isComparable(viewer)) return;
    if (viewer.mode !== 'flip') setMode(viewer, 'flip');
    viewer.shown = viewer.shown === 'baseline' ? 'candidate' : 'baseline';
    update(viewer);
  }

  /** @param {Viewer} viewer */
  function stopBlinking(viewer) {
    clearInterval(viewer.blinking);
    viewer.blinking = 0;
  }

  /** @param {Viewer} viewer */
  function blink(viewer) {
    if (viewer.blinking) stopBlinking(viewer);
    else if (!stillness.matches && isComparable(viewer)) {
      setMode(viewer, 'flip');
      viewer.blinking = setInterval(() => flip(viewer), blinkMilliseconds);
    }
    update(viewer);
  }

  // The largest whole number of screen pixels a pixel at which the box, with room around it, fits;
  // null: only the whole picture has it. `least`: the least width to show, in pixels.
  /** @type {(viewer: Viewer, box: number[], least: number) => Viewer['zoom']} */
  function zoomOn(viewer, [left, top, right, bottom], least) {
    const frame = one('.frame', viewer.set);
    const [width, height] = sizeOf(viewer.set);
    /** @type {(from: number, to: number) => number} */
    const room = (from, to) => to - from + 2 * Math.max(3, Math.round((to - from) * 0.2));
    const scale = Math.floor(Math.min(
      frame.clientWidth / Math.max(room(left, right), least),
      frame.clientHeight / Math.max(room(top, bottom), (least * height) / width), mostZoom));
    return scale <= frame.clientWidth / width
      ? null : { x: (left + right) / 2, y: (top + bottom) / 2, scale };
  }

  /** @type {(viewer: Viewer, zoom: Viewer['zoom'], fitted?: number[] | null) => void} */
  function setZoom(viewer, zoom, fitted = null) {
    viewer.fitted = fitted;
    viewer.zoom = zoom;
    update(viewer);
  }

  /** @type {(viewer: Viewer, how: string | undefined) => void} */
  function zoomBy(viewer, how) {
    const frame = find('.frame', viewer.set);
    if (!frame) return;
    const [width, height] = sizeOf(viewer.set);
    const box = boxOf(viewer.set.dataset.box);
    if (how === 'whole') setZoom(viewer, null);
    else if (how === 'box') setZoom(viewer, null, box);
    else {
      const fitting = frame.clientWidth / width;
      const zoom = viewer.zoom ?? {
        x: box ? (box[0] + box[2]) / 2 : width / 2,
        y: box ? (box[1] + box[3]) / 2 : height / 2,
        scale: fitting,
      };
      const scale = how === 'in' ? Math.floor(zoom.scale * 1.5) + 1 : Math.floor(zoom.scale / 1.5);
      setZoom(viewer, scale <= fitting ? null : { ...zoom, scale: Math.min(scale, mostZoom) });
    }
  }

  // By screen pixels; what is moved out of sight stays there only as far as it can.
  /** @type {(viewer: Viewer, dx: number, dy: number) => void} */
  function pan(viewer, dx, dy) {
    if (!viewer.zoom) return;
    const frame = one('.frame', viewer.set);
    const [width, height] = sizeOf(viewer.set);
    const { x, y, scale } = viewer.zoom;
    /** @type {(at: number, size: number, extent: number) => number} */
    const within = (at, size, extent) => {
      const half = extent / 2 / scale;
      return half * 2 >= size ? size / 2 : Math.min(size - half, Math.max(half, at));
    };
    setZoom(viewer, {
      x: within(x - dx / scale, width, frame.clientWidth),
      y: within(y - dy / scale, height, frame.clientHeight),
      scale,
    });
  }

  /** @type {(viewer: Viewer, set: HTMLElement) => void} */
  function dragIn(viewer, set) {
    /** @type {PointerEvent | null} */
    let last = null;
    set.addEventListener('pointerdown', (event) => {
      if (!closest(event.target, '.frame') || event.button !== 0) return;
      last = event;
      set.setPointerCapture(event.pointerId);
      if (viewer.mode === 'slider') slideTo(event);
    });
    set.addEventListener('pointermove', (event) => {
      if (!last) return;
      if (viewer.mode === 'slider') slideTo(event);
      else pan(viewer, event.clientX - last.clientX, event.clientY - last.clientY);
      last = event;
    });
    for (const end of ['pointerup', 'pointercancel'])
      set.addEventListener(end, () => (last = null));
    /** @param {PointerEvent} event */
    function slideTo(event) {
      const frame = one('.baseline .frame', set).getBoundingClientRect();
      slide(viewer, Math.round((1000 * (event.clientX - frame.left)) / frame.width) / 10);
    }
  }

  // Pictures are shown in whole multiples of their size where they fit: anything else would make
  // some pixels larger than others.
  /** @param {Viewer} viewer */
  function place(viewer) {
    const { set, mode } = viewer;
    const [width, height] = sizeOf(set);
    const figure = all('figure', set).find((f) => f.clientWidth > 0);
    if (!figure) return;
    const room = (mode === 'side' ? figure : set).clientWidth - 2;
    // One over the other is to be seen as a whole, below its buttons.
    const times = Math.min(
      mode === 'side' ? 2 : 4,
      Math.floor(room / width),
      Math.max(1, Math.floor((0.75 * innerHeight) / height)));
    set.style.setProperty('--frame', times >= 1 ? `${times * width}px` : '100%');
    // With so much around the change that a reader sees where it is.
    if (viewer.fitted) viewer.zoom = zoomOn(viewer, viewer.fitted, width / 8);
    const { zoom } = viewer;
    let scale = 1;
    for (const frame of all('.frame', set)) {
      const layer = one('.layer', frame);
      if (frame.clientWidth === 0) continue;
      scale = zoom ? zoom.scale : frame.clientWidth / width;
      if (!zoom) {
        layer.style.width = layer.style.left = layer.style.top = '';
        continue;
      }
      /** @type {(middle: number, size: number, extent: number) => number} */
      const start = (middle, size, extent) =>
        size * scale <= extent
          ? (extent - size * scale) / 2
          : Math.min(0, Math.max(extent - size * scale, extent / 2 - middle * scale));
      layer.style.width = `${width * scale}px`;
      layer.style.left = `${Math.round(start(zoom.x, width, frame.clientWidth))}px`;
      layer.style.top = `${Math.round(start(zoom.y, height, frame.clientHeight))}px`;
    }
    // A picture made smaller is smoothed: dropping pixels could drop the very ones that changed.
    set.classList.toggle('pixels', scale * devicePixelRatio >= 1);
    set.classList.toggle('zoomed', zoom !== null);
  }

  /** @param {Viewer} viewer */
  function update(viewer) {
    const { root, set, mode } = viewer;
    const comparable = isComparable(viewer);
    for (const s of viewer.sets) {
      s.dataset.mode = s === set ? mode : 'side';
      s.dataset.shown = viewer.shown;
      s.style.setProperty('--at', `${viewer.at}%`);
    }
    one('.slide', root).hidden = mode !== 'slider';
    one('.flips', root).hidden = mode !== 'flip';
    place(viewer);
    const press = (/** @type {HTMLElement} */ button, /** @type {boolean} */ pressed) =>
      button.setAttribute('aria-pressed', String(pressed));
    all('[data-show-set]', root).forEach((b) => press(b, b.dataset.showSet === set.dataset.set));
    all('[data-set-mode]', root).forEach((b) => press(b, b.dataset.setMode === mode));
    one('.modes', root).hidden = !comparable;
    sliderOf(root).value = String(viewer.at);
    const blinker = /** @type {HTMLButtonElement} */ (one('[data-blink]', root));
    press(blinker, viewer.blinking !== 0);
    blinker.disabled = stillness.matches;
    blinker.title = stillness.matches ? 'Off, since this system asks for less motion' : '';
    press(one('[data-zoom="whole"]', root), viewer.zoom === null);
    const box = boxOf(set.dataset.box);
    const changeButton = one('[data-zoom="box"]', root);
    changeButton.hidden = !box;
    press(changeButton, viewer.zoom !== null);
    const words = [];
    // Read out at every change otherwise.
    if (mode === 'flip' && !viewer.blinking)
      words.push(viewer.shown === 'baseline' ? 'baseline' : 'new');
    if (viewer.zoom) words.push(`${viewer.zoom.scale} ×`);
    const text = words.join(', ');
    const state = one('.state', root);
    if (state.textContent !== text) state.textContent = text;
  }

  cases.forEach((article) => {
    const root = find('.viewer', article);
    if (root) viewers.set(article, makeViewer(root));
    all('[data-go]', article).forEach((button) => {
      const viewer = viewers.get(article);
      if (!viewer || !button.dataset.go) return;
      button.addEventListener('click', () => {
        showSet(viewer, button.dataset.goSet);
        const box = boxOf(button.dataset.go);
        if (box) setZoom(viewer, zoomOn(viewer, box, 0));
        viewer.root.scrollIntoView({ block: 'nearest' });
      });
    });
  });
  stillness.addEventListener('change', () => {
    for (const viewer of viewers.values()) {
      if (stillness.matches) stopBlinking(viewer);
      update(viewer);
    }
  });

  // --- filters --------------------------------------------------------------------------------

  const filter = /** @type {HTMLInputElement} */ (one('#filter'));
  const chips = /** @type {HTMLButtonElement[]} */ (all('.chip'));
  const briefs = /** @type {HTMLDetailsElement[]} */ (all('.brief'));
  /** @type {Map<HTMLElement, boolean>} */
  const briefWasOpen = new Map();

  function shownCases() {
    return cases.filter((article) => !article.hidden);
  }

  function applyFilter() {
    const wanted = chips.filter((c) => c.getAttribute('aria-pressed') === 'true')
      .map((c) => c.dataset.verdict);
    const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    const byVerdict = (/** @type {HTMLElement} */ element) =>
      wanted.length === 0 || wanted.includes(element.dataset.verdict);
    const byText = (/** @type {string} */ text) =>
      words.every((word) => text.toLowerCase().includes(word));
    let count = 0;
    for (const article of cases) {
      article.hidden = !byVerdict(article) || !byText(textOf(article));
      count += article.hidden ? 0 : 1;
    }
    for (const item of all('nav li'))
      item.hidden = caseOf(item).hidden;
    for (const brief of briefs) {
      let names = 0;
      for (const item of all('li', brief)) {
        item.hidden = !byText(item.textContent ?? '');
        names += item.hidden ? 0 : 1;
      }
      brief.hidden = !byVerdict(brief) || names === 0;
      count += brief.hidden ? 0 : names;
      // What was asked for is not left folded.
      const asked = wanted.length > 0 || words.length > 0;
      const before = briefWasOpen.get(brief) ?? brief.open;
      brief.open = asked || before;
      if (asked) briefWasOpen.set(brief, before);
      else briefWasOpen.delete(brief);
    }
    const total = cases.length + briefs.reduce((n, b) => n + all('li', b).length, 0);
    one('#shown').textContent = count === total ? '' : `${count} of ${total} cases shown`;
    one('#nothing').hidden = count > 0 || total === 0;
    one('#tick-all').hidden = all('.case:not([hidden]) .tick').length === 0;
  }

  /** @type {Map<HTMLElement, string>} */
  const texts = new Map();
  /** @param {HTMLElement} article */
  function textOf(article) {
    const parts = 'h2, .cause, .message, .lines, tbody th, .commands code';
    const text = texts.get(article) ?? all(parts, article).map((p) => p.textContent).join(' ');
    texts.set(article, text);
    return text;
  }

  chips.forEach((chip) => {
    chip.disabled = false;
    chip.addEventListener('click', () => {
      chip.setAttribute('aria-pressed', String(chip.getAttribute('aria-pressed') !== 'true'));
      applyFilter();
    });
  });
  filter.addEventListener('input', applyFilter);
  one('#clear-filter').addEventListener('click', () => {
    filter.value = '';
    chips.forEach((chip) => chip.setAttribute('aria-pressed', 'false'));
    applyFilter();
    filter.focus();
  });

  // --- ticked cases ---------------------------------------------------------------------------

  const ticks = /** @type {HTMLInputElement[]} */ (all('.tick'));
  const ticked = one('#ticked');

  function showTicked() {
    const chosen = ticks.filter((tick) => tick.checked);
    // One command for all that share a suite and its baselines.
    const commands = new Map();
    for (const { dataset } of chosen)
      commands.set(dataset.prefix, [...(commands.get(dataset.prefix) ?? []), dataset.name]);
    ticked.hidden = chosen.length === 0;
    one('#ticked-words').textContent =
      chosen.length === 1 ? '1 case ticked' : `${chosen.length} cases ticked`;
    one('#ticked-command').textContent =
      [...commands].map(([prefix, names]) => [prefix, ...new Set(names)].join(' ')).join('\n');
    for (const item of all('nav li')) {
      const tick = /** @type {HTMLInputElement | null} */ (find('.tick', caseOf(item)));
      item.classList.toggle('ticked', Boolean(tick?.checked));
    }
  }

  ticks.forEach((tick) => tick.addEventListener('change', showTicked));
  one('#tick-all').addEventListener('click', () => {
    const shown = /** @type {HTMLInputElement[]} */ (all('.case:not([hidden]) .tick'));
    shown.forEach((tick) => (tick.checked = true));
    showTicked();
  });
  one('#untick').addEventListener('click', () => {
    ticks.forEach((tick) => (tick.checked = false));
    showTicked();
    one('#tick-all').focus();
  });

  // --- copying --------------------------------------------------------------------------------

  /** @param {HTMLElement} button */
  async function copy(button) {
    const code = one('code', closest(button, 'dd, aside') ?? document);
    let done = true;
    try {
      await navigator.clipboard.writeText(code.textContent ?? '');
    } catch {
      // Pages from disk may be refused the clipboard; a selection can always be copied.
      const range = document.createRange();
      range.selectNodeContents(code);
      getSelection()?.removeAllRanges();
      getSelection()?.addRange(range);
      done = document.execCommand('copy');
    }
    button.textContent = done ? 'copied' : 'selected';
    setTimeout(() => (button.textContent = 'copy'), 1500);
  }
  all('.copy').forEach((button) => button.addEventListener('click', () => copy(button)));

  // --- keys -----------------------------------------------------------------------------------

  const dialog = /** @type {HTMLDialogElement} */ (one('#keys'));
  one('#show-keys').addEventListener('click', () => dialog.showModal());
  /** @type {HTMLElement | null} */
  let current = null;

  // Unlike scrollIntoView, leaves the page where it is: it must not move under a finger.
  /** @type {(list: HTMLElement, item: HTMLElement) => void} */
  function scrollWithin(list, item) {
    const outer = list.getBoundingClientRect();
    const inner = item.getBoundingClientRect();
    if (inner.top < outer.top) list.scrollTop -= outer.top - inner.top;
    else if (inner.bottom > outer.bottom) list.scrollTop += inner.bottom - outer.bottom;
  }

  /** @param {HTMLElement} article */
  function enter(article) {
    if (current === article) return;
    const before = viewers.get(current);
    if (before?.blinking) {
      stopBlinking(before);
      update(before);
    }
    current = article;
    const links = /** @type {HTMLAnchorElement[]} */ (all('nav a'));
    links.forEach((link) => {
      if (link.hash === `#${article.id}`) {
        link.setAttribute('aria-current', 'true');
        scrollWithin(one('nav'), link);
      } else link.removeAttribute('aria-current');
    });
    const viewer = viewers.get(article);
    if (viewer && !viewer.touched) setMode(viewer, lastMode, false);
  }

  /** @param {HTMLElement} article */
  function go(article) {
    enter(article);
    article.focus({ preventScroll: true });
    article.scrollIntoView({ block: 'start' });
  }

  /** @param {number} by */
  function step(by) {
    const shown = shownCases();
    if (shown.length === 0) return;
    const at = shown.findIndex((article) => article === current);
    const next = at < 0 ? (by > 0 ? 0 : shown.length - 1) : at + by;
    go(shown[Math.min(shown.length - 1, Math.max(0, next))]);
  }

  document.addEventListener('focusin', (event) => {
    const article = closest(event.target, '.case');
    if (article) enter(article);
  });
  // Clicking into a case makes it the one that the keys mean.
  document.addEventListener('pointerdown', (event) => {
    const article = closest(event.target, '.case');
    if (article) enter(article);
  });

  /** @type {Record<string, number[] | undefined>} */
  const arrows = {
    ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
  };

  /** @type {Record<string, Mode | undefined>} */
  const modeKeys = { 1: 'side', 2: 'slider', 3: 'flip' };

  // Returns whether the key meant something.
  /** @param {KeyboardEvent} event */
  function press(event) {
    const { key, target } = event;
    const viewer = viewers.get(current);
    if (key === 'j') return step(1), true;
    if (key === 'k') return step(-1), true;
    if (key === '/') return filter.focus(), filter.select(), true;
    if (key === '?') return dialog.showModal(), true;
    if (!current || current.hidden) return false;
    if (key === 'x') {
      find('.tick', current)?.click();
      return true;
    }
    if (!viewer) return false;
    if (key === ' ' && closest(target, 'button, a, input, summary')) return false;
    if (key === ' ' || key === 'f') return flip(viewer), true;
    if (key === 'b') return blink(viewer), true;
    if (key === 'z') return zoomBy(viewer, viewer.zoom ? 'whole' : 'box'), true;
    if (key === '+' || key === '=') return zoomBy(viewer, 'in'), true;
    if (key === '-' || key === '−') return zoomBy(viewer, 'out'), true;
    if (key === 'i') {
      const next = viewer.sets[(viewer.sets.indexOf(viewer.set) + 1) % viewer.sets.length];
      return showSet(viewer, next.dataset.set), true;
    }
    const mode = modeKeys[key];
    if (mode) return setMode(viewer, mode), true;
    const arrow = arrows[key];
    if (arrow && event.shiftKey && viewer.zoom) {
      const [dx, dy] = arrow;
      return pan(viewer, 40 * dx, 40 * dy), true;
    }
    // Regions that scroll and the slider itself have their own arrows.
    if (viewer.mode === 'slider' && !event.shiftKey && !closest(target, 'input, .scroll')) {
      if (key === 'ArrowLeft') return slide(viewer, viewer.at - 2), true;
      if (key === 'ArrowRight') return slide(viewer, viewer.at + 2), true;
    }
    return false;
  }

  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || dialog.open) return;
    if (event.target === filter) {
      if (event.key === 'Escape' && filter.value === '') filter.blur();
      return;
    }
    if (press(event)) event.preventDefault();
  });

  addEventListener('hashchange', () => {
    const article = cases.find((a) => `#${a.id}` === location.hash);
    if (article && !article.hidden) go(article);
  });
  if (location.hash) dispatchEvent(new Event('hashchange'));
  // Browsers may keep what was typed and ticked when a page is loaded again.
  applyFilter();
  showTicked();
})();
