// Opens the sample report as a file, as a reader would, and uses everything on it.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const folder = process.env.PAGE_FOLDER;
const screenshots = process.env.SCREENSHOTS;
const hostile = `<script>alert('x')</script> & "more"`;

let browser;
before(async () => {
  // The sandbox needs rights that containers often lack; the page is our own.
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM,
    args: ['--no-sandbox', '--disable-gpu'],
  });
});
after(() => browser?.close());

// Runs `body` with a page of the report. It fails on any request except the file itself and data,
// on any error of the script and on any dialog.
async function onPage({ file = 'report.html', hash = '', ...options }, body) {
  const context = await browser.newContext({
    viewport: { width: 1360, height: 900 },
    offline: true,
    ...options,
  });
  const wrong = [];
  await context.route('**/*', (route) => {
    const url = route.request().url();
    if (/^(file|data):/.test(url)) return route.continue();
    wrong.push(`request: ${url}`);
    return route.abort();
  });
  const page = await context.newPage();
  const main = pathToFileURL(join(folder, file)).href;
  page.on('request', (request) => {
    const url = request.url();
    if (!url.startsWith(main) && !url.startsWith('data:')) wrong.push(`request: ${url.slice(0, 99)}`);
  });
  page.on('pageerror', (error) => wrong.push(`error: ${error.message}`));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) wrong.push(`console: ${message.text()}`);
  });
  page.on('dialog', (dialog) => {
    wrong.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  await page.goto(main + hash);
  await body(page, context);
  assert.deepEqual(wrong, []);
  await context.close();
}

async function shot(page, name, options = {}) {
  if (screenshots) await page.screenshot({ path: join(screenshots, `${name}.png`), ...options });
}

const article = (page, name) => page.locator(`article[data-name=${JSON.stringify(name)}]`);
const names = (page) =>
  page.locator('article:visible').evaluateAll((found) => found.map((a) => a.dataset.name));
const pressed = (locator) => locator.getAttribute('aria-pressed');
const focusedCase = (page) => page.evaluate(() => document.activeElement.dataset.name);

const inOrder = [
  'spheres-scb-pairs', 'one-pixel', 'tinted', 'thin-cylinder-counts', hostile, 'cone-wide',
  'spheres-fresh', 'knots-extra', 'broken-scene',
];

test('failures come first, by verdict and then as in the suite', () =>
  onPage({}, async (page) => {
    assert.deepEqual(await names(page), inOrder);
    assert.equal(await page.locator('h1').textContent(), '9 of 22 cases failed');
    const chips = await page.locator('.chip').allTextContents();
    assert.deepEqual(chips, [
      'different 5', 'size differs 1', 'missing baseline 1', 'new output 1', 'could not run 1',
      'same 12', 'skipped 1',
    ]);
    assert.match(await page.locator('header').textContent(), /golden\/cases\.json · shard 1\/2/);
    assert.match(await page.locator('.environment').textContent(), /Mesa22\.3\.6/);
    await shot(page, 'top-light');
    // Passing cases are names, folded away.
    assert.equal(await page.locator('.brief[data-verdict=same] li').first().isVisible(), false);
    await page.locator('.brief[data-verdict=same] summary').click();
    assert.equal(await page.locator('.brief[data-verdict=same] li:visible').count(), 12);
    await shot(page, 'whole-light', { fullPage: true });
  }));

test('names from outside are text', () =>
  onPage({}, async (page) => {
    assert.equal(await article(page, hostile).locator('h2').textContent(), hostile);
    assert.match(await article(page, hostile).textContent(), /<i>is<\/i> \{\{hostile\}\}/);
    assert.equal(await page.locator('img[src=x]').count(), 0);
    assert.match(await page.locator('.environment').textContent(), /<b>quoted<\/b>"&'/);
  }));

test('counts have before, after and a signed difference', () =>
  onPage({}, async (page) => {
    const rows = await article(page, 'spheres-scb-pairs')
      .locator('.details section').first().locator('tbody tr')
      .evaluateAll((found) => found.map((row) => [...row.cells].map((c) => c.textContent)));
    assert.equal(rows.length, 49);
    assert.deepEqual(rows.slice(0, 8), [
      ['frames/100/n_v', '24,680', '24,697', '+17'],
      ['frames/100/n_p', '912', '909', '−3'],
      ['frames/100/stages/ball-slab', '4,012', '4,031', '+19'],
      ['frames/100/stages/cylinder-slab', '1,024', '1,007', '−17'],
      ['frames/100/stages/slab-ball-corrected', '–', '3', 'new'],
      ['bodies/A/volumes', '128', '–', 'gone'],
      ['bodies/A/name', '"A"', '"<A>"', 'changed'],
      ['bodies/A/depth', '14.0', '14', 'changed'],
    ]);
    assert.equal(rows[48][3], '+18,446,744,073,709,551,615');
    assert.equal(await article(page, 'spheres-scb-pairs').getByText('25 more rows').count(), 1);
    assert.equal(await article(page, 'thin-cylinder-counts').locator('.viewer').count(), 0);
  }));

test('the sweep lists tolerances only where they change', () =>
  onPage({}, async (page) => {
    const sweep = (name) => article(page, name).locator('.sweep tbody tr')
      .evaluateAll((found) => found.map((row) => [...row.cells].map((c) => c.textContent)));
    assert.deepEqual(await sweep('one-pixel'), [['0', '1', ''], ['1', '0', '']]);
    const pixels = await article(page, 'one-pixel').locator('.pixels-table tbody tr').allInnerTexts();
    assert.deepEqual(pixels.map((row) => row.split(/\s*\t\s*/)),
      [['(143, 77)', '#7872b2', '#7873b2', '0, +1, 0']]);
    const tinted = await sweep('tinted');
    assert.equal(tinted.length, 2);
    assert.deepEqual(tinted.map((row) => row[0]), ['0', '40']);
    assert.match(await article(page, 'one-pixel').textContent(), /1 pixel differs, at \(143, 77\), by up to 1 of 255/);
    assert.match(await article(page, 'tinted').textContent(), /Allowed: up to 2 in a channel, and 16 pixels beyond/);
    assert.match(await article(page, 'tinted').textContent(), /accepted picture 2/);
  }));

test('cases are filtered by verdict and by text', () =>
  onPage({}, async (page) => {
    await page.locator('.chip[data-verdict="different"]').click();
    assert.deepEqual(await names(page), inOrder.slice(0, 5));
    assert.equal(await page.locator('#shown').textContent(), '5 of 22 cases shown');
    await page.locator('#filter').fill('PIXEL one');
    assert.deepEqual(await names(page), ['one-pixel']);
    assert.equal(await page.locator('nav li:visible').count(), 1);
    await page.locator('#filter').fill('nothing has this');
    assert.deepEqual(await names(page), []);
    await page.getByRole('button', { name: 'Show all' }).click();
    assert.equal((await names(page)).length, 9);
    // What passed is found too, and unfolded for it.
    await page.locator('#filter').fill('collide-scene-1');
    assert.equal(await page.locator('.brief[data-verdict=same] li:visible').count(), 4);
    await page.locator('#filter').fill('');
    assert.equal(await page.locator('.brief[data-verdict=same] li:visible').count(), 0);
  }));

test('the slider shows the baseline on its left and the new picture on its right', () =>
  onPage({}, async (page) => {
    const name = 'spheres-scb-pairs';
    const root = article(page, name);
    await root.scrollIntoViewIfNeeded();
    await root.getByRole('button', { name: 'slider' }).click();
    assert.equal(await pressed(root.locator('[data-set-mode=slider]')), 'true');
    assert.equal(await root.locator('.difference:visible').count(), 0);
    const view = root.locator('.pictures:visible .candidate .frame');
    const box = await view.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.25, box.y + box.height / 2, { steps: 4 });
    await page.mouse.up();
    const range = root.locator('.slide input');
    assert.ok(Math.abs(Number(await range.inputValue()) - 25) <= 1);
    const clip = (kind) => root.locator(`.pictures:visible .${kind} .view`)
      .evaluate((v) => getComputedStyle(v).clipPath);
    assert.match(await clip('baseline'), /inset\(0(px)? (75%|calc)/);
    assert.match(await clip('candidate'), /inset\(0(px)? 0(px)? 0(px)? 25%\)/);
    await shot(page, 'slider-light');
    // The pictures lie exactly over one another, pixels a whole number of screen pixels large.
    const over = await root.locator('.pictures:visible img').evaluateAll((images) =>
      images.slice(0, 2).map((i) => JSON.stringify(i.getBoundingClientRect())));
    assert.equal(over[0], over[1]);
    const { width } = JSON.parse(over[0]);
    assert.equal(width % 320, 0);
    await range.focus();
    await page.keyboard.press('ArrowRight');
    assert.ok(Number(await range.inputValue()) > 25);
  }));

test('a key flips between baseline and new, and blinking does it by itself', () =>
  onPage({ hash: '#case-tinted' }, async (page) => {
    const root = article(page, 'tinted');
    const visible = () => root.locator('.pictures:visible').evaluate((set) =>
      ['baseline', 'candidate'].filter((kind) =>
        getComputedStyle(set.querySelector(`.${kind} .view`)).visibility === 'visible').join());
    assert.equal(await focusedCase(page), 'tinted');
    const scrolled = await page.evaluate(() => scrollY);
    await page.keyboard.press('Space');
    assert.equal(await visible(), 'baseline');
    assert.match(await root.locator('.state').textContent(), /^baseline, \d+ ×$/);
    await page.keyboard.press('Space');
    assert.equal(await visible(), 'candidate');
    await page.keyboard.press('f');
    assert.equal(await visible(), 'baseline');
    await page.keyboard.press('z');
    assert.equal(await root.locator('.state').textContent(), 'baseline');
    assert.equal(await page.evaluate(() => scrollY), scrolled);
    await shot(page, 'flip-light');
    await page.keyboard.press('b');
    assert.equal(await pressed(root.locator('[data-blink]')), 'true');
    const seen = new Set();
    for (let i = 0; i < 30 && seen.size < 2; ++i) {
      seen.add(await visible());
      await page.waitForTimeout(60);
    }
    assert.equal(seen.size, 2);
    // Going on to another case ends it.
    await page.keyboard.press('j');
    assert.equal(await pressed(root.locator('[data-blink]')), 'false');
  }));

test('with less motion asked for, nothing blinks; flipping stays', () =>
  onPage({ hash: '#case-tinted', reducedMotion: 'reduce' }, async (page) => {
    const root = article(page, 'tinted');
    await page.keyboard.press('b');
    assert.equal(await root.locator('.pictures:visible').getAttribute('data-mode'), 'side');
    await page.keyboard.press('3');
    assert.equal(await root.locator('[data-blink]').isDisabled(), true);
    await page.keyboard.press('Space');
    assert.equal(await root.locator('.pictures:visible').getAttribute('data-shown'), 'baseline');
  }));

test('the page opens on the change with its surroundings, and a key shows the whole', () =>
  onPage({ hash: '#case-one-pixel' }, async (page) => {
    const root = article(page, 'one-pixel');
    // The part of the picture that a frame shows, and whether the changed pixel is in it.
    const seen = () => root.locator('.pictures:visible .frame').evaluateAll((frames) =>
      frames.map((frame) => {
        const outer = frame.getBoundingClientRect();
        const box = frame.querySelector('.box').getBoundingClientRect();
        const drawn = frame.querySelector('img').getBoundingClientRect();
        return [outer.width / drawn.width,
          box.left > outer.left && box.right < outer.right && box.top > outer.top &&
            box.bottom < outer.bottom];
      }));
    await shot(page, 'opening-light');
    for (const size of [{ width: 1280, height: 800 }, { width: 640, height: 400 }]) {
      await page.setViewportSize(size);
      for (const [part, inside] of await seen())
        assert.ok(inside && part >= 0.12 && part < 0.25, `${size.width}: ${part}`);
    }
    assert.equal(await pressed(root.locator('[data-zoom=box]')), 'true');
    await page.keyboard.press('z');
    for (const [part] of await seen()) assert.ok(Math.abs(part - 1) < 0.01, `${part}`);
    // The ring is as large as a finger, however small the change; only the difference has it.
    const rings = await root.locator('.pictures:visible .ring').evaluateAll((found) =>
      found.map((ring) => [ring.closest('figure').className, ring.getBoundingClientRect().width]));
    assert.deepEqual(rings, [['difference', 28]]);
    await page.keyboard.press('z');
    assert.ok((await seen()).every(([part]) => part < 0.25));
    // Where nothing is compared, the whole is shown.
    assert.equal(await pressed(article(page, 'spheres-fresh').locator('[data-zoom=whole]')), 'true');
  }));

test('a pixel of the table fills the frames, its pixels square', () =>
  onPage({ hash: '#case-one-pixel' }, async (page) => {
    const root = article(page, 'one-pixel');
    await root.locator('[data-go-set=colors]').click();
    const frames = await root.locator('.pictures:visible .frame').evaluateAll((found) =>
      found.map((frame) => {
        const image = frame.querySelector('img');
        const box = frame.querySelector('.box').getBoundingClientRect();
        const outer = frame.getBoundingClientRect();
        const drawn = image.getBoundingClientRect();
        return {
          rendering: getComputedStyle(image).imageRendering,
          scale: [drawn.width / image.width, drawn.height / image.height,
            drawn.width / image.naturalWidth, drawn.height / image.naturalHeight],
          boxSize: [box.width, box.height],
          inside: box.left > outer.left && box.right < outer.right && box.top > outer.top &&
            box.bottom < outer.bottom,
          pixel: [(box.left - drawn.left) / (drawn.width / image.naturalWidth),
            (box.top - drawn.top) / (drawn.height / image.naturalHeight)],
        };
      }));
    assert.equal(frames.length, 3);
    for (const frame of frames) {
      assert.equal(frame.rendering, 'pixelated');
      const scale = frame.scale[2];
      assert.ok(scale >= 16 && Number.isInteger(Math.round(scale * 1000) / 1000), `${scale}`);
      assert.ok(Math.abs(frame.scale[3] - scale) < 0.01);
      assert.ok(frame.boxSize.every((side) => Math.abs(side - scale) < 0.1), `${frame.boxSize}`);
      assert.ok(frame.inside);
      assert.ok(Math.abs(frame.pixel[0] - 143) < 0.01 && Math.abs(frame.pixel[1] - 77) < 0.01);
    }
    await shot(page, 'zoom-light');
    const left = () => root.locator('.layer').first().evaluate((l) => parseFloat(l.style.left));
    const start = await left();
    await page.keyboard.press('Shift+ArrowRight');
    assert.equal(await left(), start - 40);
    await page.keyboard.press('+');
    assert.match(await root.locator('.state').textContent(), /×/);
    await page.keyboard.press('z');
    assert.equal(await root.locator('.layer').first().getAttribute('style'), '');
  }));

test('pictures and ids are shown in turn, and a row of ids zooms to its place', () =>
  onPage({ hash: '#case-spheres-scb-pairs' }, async (page) => {
    const root = article(page, 'spheres-scb-pairs');
    assert.equal(await root.locator('.pictures:visible').getAttribute('data-set'), 'colors');
    await page.keyboard.press('i');
    assert.equal(await root.locator('.pictures:visible').getAttribute('data-set'), 'ids');
    assert.equal(await root.locator('.pictures:visible figure').count(), 3);
    await shot(page, 'ids-light');
    await root.locator('[data-go]:visible').nth(1).click();
    assert.match(await root.locator('.state').textContent(), /\d+ ×/);
    // Ids are opaque where there is a thing: their own alpha would hide them.
    const opaque = await root.locator('.pictures:visible .candidate img').evaluate((image) => {
      const canvas = document.createElement('canvas');
      canvas.width = image.naturalWidth;
      canvas.height = image.naturalHeight;
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      return data.filter((_, i) => i % 4 === 3).filter((alpha) => alpha === 255).length;
    });
    assert.ok(opaque > 10000);
  }));

test('sizes that differ are drawn at one scale', () =>
  onPage({ hash: '#case-cone-wide' }, async (page) => {
    const images = await article(page, 'cone-wide').locator('img').evaluateAll((found) =>
      found.map((i) => [i.naturalWidth, i.getBoundingClientRect().width]));
    assert.equal(images.length, 2);
    const scales = images.map(([natural, drawn]) => drawn / natural);
    assert.ok(Math.abs(scales[0] - scales[1]) < 0.01);
    await page.keyboard.press('2');
    await shot(page, 'size-differs-light');
  }));

test('a missing baseline, a picture that is gone, a case that did not run', () =>
  onPage({ hash: '#case-spheres-fresh' }, async (page) => {
    const fresh = article(page, 'spheres-fresh');
    assert.equal(await fresh.locator('.pictures:visible figure').count(), 1);
    assert.equal(await fresh.locator('.modes').isVisible(), false);
    await page.keyboard.press('Space');
    assert.equal(await fresh.locator('.pictures:visible').getAttribute('data-mode'), 'side');
    await shot(page, 'missing-baseline-light');
    assert.match(await article(page, 'knots-extra').textContent(),
      /could not be read: pictures\/not-there\.png/);
    const broken = article(page, 'broken-scene');
    assert.equal(await broken.locator('.tick').count(), 0);
    assert.match(await broken.textContent(), /cannot be read: it ends after 412 bytes/);
  }));

test('the cause is first, then pictures, then findings', () =>
  onPage({}, async (page) => {
    const root = article(page, 'spheres-scb-pairs');
    const top = async (selector) => (await root.locator(selector).first().boundingBox()).y;
    const tops = [];
    for (const part of ['.title', '.cause', '.viewer', '.message', '.lines', '.details', '.commands'])
      tops.push(await top(part));
    assert.deepEqual(tops, [...tops].sort((a, b) => a - b));
    assert.equal(await root.locator('.cause').textContent(), 'Body B moved: 0.02 along x, 1.5 degrees.');
    assert.equal(await article(page, 'one-pixel').locator('.cause').count(), 0);
    await page.locator('#filter').fill('moved 1.5');
    assert.deepEqual(await names(page), ['spheres-scb-pairs']);
  }));

test('what the traces conclude is said first, and the whole keeps its columns', () =>
  onPage({}, async (page) => {
    const root = article(page, 'spheres-scb-pairs');
    assert.match(await root.locator('.lines li').first().textContent(), /^11 pairs only in the baseline/);
    const trace = root.locator('.trace');
    assert.equal(await trace.isVisible(), false);
    await root.getByText('How the traces differ, 14 lines').click();
    assert.match(await trace.innerText(), /\nN_v {21}24680 {8}24697/);
    assert.equal(await trace.evaluate((t) => getComputedStyle(t).whiteSpaceCollapse), 'preserve');
    await shot(page, 'trace-light');
    // Counts that only traces have are not of the number that the message gives.
    assert.deepEqual(await root.locator('.details h3').allTextContents().then((all) => all.slice(0, 2)),
      ['49 counts differ', '4 counts of tests by depth differ in the traces']);
    // Ids are named as in the lines.
    assert.match(await root.locator('.ids tbody tr').first().innerText(), /^13 node 12 of A, level 7/);
    assert.match(await page.locator('.brief[data-verdict=same]').textContent(),
      /12 cases are the same, 1 of them within the tolerance.*collide-scene-6 within its tolerance: 12 pixels differ, by up to 2 of 255/s);
  }));

test('commands are copied', () =>
  onPage({ permissions: ['clipboard-read', 'clipboard-write'] }, async (page) => {
    const root = article(page, 'spheres-scb-pairs');
    const commands = await root.locator('.commands code').allTextContents();
    assert.deepEqual(commands, [
      'scb golden check spheres-scb-pairs --trace --report out/golden',
      'scb diff out/golden/spheres-scb-pairs.baseline.scbrec out/golden/spheres-scb-pairs.new.scbrec',
      'scb golden update spheres-scb-pairs',
    ]);
    const button = root.locator('.copy').last();
    await button.click();
    await button.getByText('copied').waitFor();
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), commands[2]);
  }));

test('ticked cases yield one update command', () =>
  onPage({}, async (page) => {
    assert.equal(await page.locator('#ticked').isVisible(), false);
    await article(page, 'one-pixel').locator('.tick').check();
    await article(page, 'cone-wide').locator('.tick').check();
    const command = page.locator('#ticked-command');
    assert.equal(await command.textContent(), 'scb golden update one-pixel cone-wide');
    assert.equal(await page.locator('#ticked-words').textContent(), '2 cases ticked');
    assert.equal(await page.locator('nav li.ticked').count(), 2);
    await shot(page, 'ticked-light');
    // Another suite needs a command of its own.
    await article(page, hostile).locator('.tick').check();
    assert.deepEqual((await command.textContent()).split('\n'), [
      'scb golden update one-pixel cone-wide',
      `scb golden update --suite my/cases.json '<script>alert('\\''x'\\'')</script> & "more"'`,
    ]);
    await page.getByRole('button', { name: 'untick all' }).click();
    assert.equal(await page.locator('#ticked').isVisible(), false);
    // All that are shown, and no others.
    await page.locator('#filter').fill('counts');
    await page.locator('#tick-all').click();
    assert.equal(await command.textContent(),
      'scb golden update spheres-scb-pairs thin-cylinder-counts');
  }));

test('everything is done with the keyboard alone', () =>
  onPage({}, async (page) => {
    const { keyboard } = page;
    await keyboard.press('?');
    assert.equal(await page.locator('#keys').isVisible(), true);
    await shot(page, 'keys-light');
    await keyboard.press('j');
    assert.equal(await focusedCase(page), undefined);
    await keyboard.press('Escape');
    assert.equal(await page.locator('#keys').isVisible(), false);

    const visited = [];
    for (let i = 0; i < 10; ++i) {
      await keyboard.press('j');
      visited.push(await focusedCase(page));
    }
    assert.deepEqual(visited, [...inOrder, inOrder.at(-1)]);
    for (let i = 0; i < 8; ++i) await keyboard.press('k');
    assert.equal(await focusedCase(page), inOrder[0]);
    const top = await article(page, inOrder[0]).evaluate((a) => a.getBoundingClientRect().top);
    assert.ok(top >= 0 && top < 100);

    await keyboard.press('2');
    const root = article(page, inOrder[0]);
    const at = root.locator('.slide input');
    await keyboard.press('ArrowLeft');
    assert.equal(await at.inputValue(), '48');
    // The way to compare goes along to the next case.
    await keyboard.press('j');
    assert.equal(
      await article(page, inOrder[1]).locator('.pictures:visible').getAttribute('data-mode'),
      'slider');
    await keyboard.press('x');
    assert.equal(await page.locator('#ticked-command').textContent(), 'scb golden update one-pixel');

    await keyboard.press('/');
    await keyboard.type('jk?x tinted');
    assert.deepEqual(await names(page), []);
    await keyboard.press('Escape');
    assert.equal((await names(page)).length, 9);
    await keyboard.type('tinted');
    assert.deepEqual(await names(page), ['tinted']);
    await keyboard.press('Escape');
    await keyboard.press('Escape');

    // Tab goes through all of the page and out of it, and shows where it is.
    await page.evaluate(() => document.activeElement.blur());
    const stops = await page.locator(
      'a[href], button, input, summary, [tabindex="0"]').evaluateAll((found) =>
      found.filter((e) => e.checkVisibility() && !e.disabled).length);
    const seen = new Set();
    let unseen = 0;
    for (let i = 0; i < 2 * stops && seen.size < stops; ++i) {
      await keyboard.press('Tab');
      const [id, ring] = await page.evaluate(() => {
        const e = document.activeElement;
        window.stops ??= new Map();
        if (e === document.body) return [-1, true];
        if (!window.stops.has(e)) window.stops.set(e, window.stops.size);
        const style = getComputedStyle(e);
        return [window.stops.get(e), style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2];
      });
      if (id >= 0) seen.add(id);
      if (!ring) ++unseen;
    }
    assert.equal(unseen, 0);
    assert.ok(seen.size >= stops - 2, `${seen.size} of ${stops}`);
  }));

test('what is used has a name, and what is named exists', () =>
  onPage({}, async (page) => {
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll('button, input, a[href], [role], img')].filter((e) => {
        const label = e.getAttribute('aria-label') || e.getAttribute('alt') ||
          e.textContent.trim() || e.labels?.[0]?.textContent.trim();
        return !label;
      }).map((e) => e.outerHTML.slice(0, 120)));
    assert.deepEqual(nameless, []);
    const ids = await page.evaluate(() => [...document.querySelectorAll('[id]')].map((e) => e.id));
    assert.equal(new Set(ids).size, ids.length);
    const lost = await page.evaluate(() =>
      [...document.querySelectorAll('[aria-labelledby]')].filter((e) =>
        !document.getElementById(e.getAttribute('aria-labelledby'))).length);
    assert.equal(lost, 0);
  }));

// The contrast of every text with what is behind it.
const faintTexts = (page) => page.evaluate(() => {
  const channels = (color) => color.match(/[\d.]+/g).map(Number);
  const luminance = (color) => {
    const [r, g, b] = channels(color).map((c) => {
      const s = c / 255;
      return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const behind = (e) => {
    for (; e; e = e.parentElement) {
      const color = getComputedStyle(e).backgroundColor;
      const alpha = channels(color)[3] ?? 1;
      if (alpha > 0) return color;
    }
    return 'rgb(255, 255, 255)';
  };
  const faint = new Set();
  for (const e of document.querySelectorAll('body *')) {
    const text = [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim());
    if (!text || !e.checkVisibility({ visibilityProperty: true }) || e.closest('kbd')) continue;
    const [a, b] = [luminance(getComputedStyle(e).color), luminance(behind(e))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 4.5) faint.add(`${e.tagName}.${e.className}: ${contrast.toFixed(2)}`);
  }
  return [...faint];
});

for (const colorScheme of ['light', 'dark'])
  test(`text has contrast, ${colorScheme}`, () =>
    onPage({ colorScheme }, async (page) => {
      assert.deepEqual(await faintTexts(page), []);
      const background = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      assert.equal(background, colorScheme === 'dark' ? 'rgb(22, 25, 30)' : 'rgb(255, 255, 255)');
      if (colorScheme === 'dark') {
        await shot(page, 'whole-dark', { fullPage: true });
        await page.keyboard.press('j');
        await page.keyboard.press('x');
        await page.keyboard.press('2');
        await page.keyboard.press('z');
        await shot(page, 'slider-zoom-dark');
      }
    }));

test('a phone shows all without scrolling sideways', () =>
  onPage({ viewport: { width: 420, height: 860 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 },
    async (page) => {
      const wide = () => page.evaluate(() => document.documentElement.scrollWidth);
      assert.equal(await wide(), 420);
      await shot(page, 'phone-top');
      await shot(page, 'phone-whole', { fullPage: true });
      const root = article(page, 'spheres-scb-pairs');
      await root.getByRole('button', { name: 'slider' }).scrollIntoViewIfNeeded();
      const scrolled = await page.evaluate(() => scrollY);
      await root.getByRole('button', { name: 'slider' }).tap();
      assert.equal(await page.evaluate(() => scrollY), scrolled, 'the page moved under the finger');
      await root.locator('[data-zoom=box]').tap();
      await root.locator('.tick').tap();
      assert.equal(await wide(), 420);
      assert.equal(await root.locator('.pictures:visible').getAttribute('data-mode'), 'slider');
      await shot(page, 'phone-slider');
      // Nothing to tap is smaller than a fingertip needs.
      const small = await page.locator('.tools button:visible').evaluateAll((found) =>
        found.filter((b) => b.getBoundingClientRect().height < 30).length);
      assert.equal(small, 0);
    }));

for (const colorScheme of ['light', 'dark'])
  test(`a narrow page cuts neither the list of failures nor the table of ids, ${colorScheme}`, () =>
    onPage({ viewport: { width: 400, height: 860 }, colorScheme }, async (page) => {
      const list = await page.locator('nav').evaluate((nav) => [nav.scrollHeight, nav.clientHeight]);
      assert.ok(list[0] <= list[1], `${list}`);
      assert.match(await page.locator('nav p').textContent(), /9 failures/);
      const ids = article(page, 'spheres-scb-pairs').locator('.scroll:has(.ids)');
      await ids.scrollIntoViewIfNeeded();
      const table = await ids.evaluate((scroll) => [scroll.scrollWidth, scroll.clientWidth]);
      assert.ok(table[0] <= table[1], `${table}`);
      await shot(page, `narrow-ids-${colorScheme}`);
    }));

test('without a script all of it can be read', () =>
  onPage({ javaScriptEnabled: false }, async (page) => {
    assert.equal(await page.locator('article:visible').count(), 9);
    assert.equal(await page.locator('.script:visible').count(), 0);
    assert.equal(await article(page, 'spheres-scb-pairs').locator('figure:visible').count(), 6);
    assert.equal(await page.locator('.box:visible').count() > 0, true);
    assert.equal(await page.locator('#ticked').isVisible(), false);
    assert.equal(await page.locator('#keys').isVisible(), false);
    assert.match(await article(page, 'one-pixel').innerText(), /scb golden update one-pixel/);
    await shot(page, 'no-script', { fullPage: true });
  }));

test('a run without failures says so', async () => {
  await onPage({ file: 'passing.html' }, async (page) => {
    assert.equal(await page.locator('h1').textContent(), '13 cases, none failed');
    assert.equal(await page.locator('#tick-all').isVisible(), false);
    await page.keyboard.press('j');
    await shot(page, 'passing');
  });
  await onPage({ file: 'incomplete.html' }, async (page) => {
    assert.equal(await page.locator('h1.alarm').textContent(), '13 cases, but not all');
    assert.equal(await page.locator('p.alarm').textContent(), 'These shards are missing: 2/2.');
    await shot(page, 'incomplete');
  });
  await onPage({ file: 'empty.html' }, async (page) => {
    assert.equal(await page.locator('h1').textContent(), 'No cases were run');
  });
});
