// Opens pages of `scb view` as files in Firefox, by WebDriver BiDi, and uses what browsers do differently: shaders, the unpacking of the
// arrays, keys, the mouse, sizes.
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';
import { address, assert_ids_of_picture, assert_same_ids, chromium_arguments, folder, ids_of, page_of, read_png, seen, settled, shot, watched } from './pages.mjs';

const modes = ['levels', 'rejections', 'pairs', 'tests', 'wasted', 'traversal', 'verdicts'];
const scenes = [
  ['cone', '--volume', 'scb2,obb', '--level', '4', '--frames', '100'],
  ['spheres-l1', '--volume', 'scb', '--level', '5', '--frames', '100'],
  ['knots-l1', '--volume', 'rss', '--level', '5', '--frames', '150'],
];

let firefox;
// What Firefox warns of where WebGL is used wrongly; it says so on its standard error only.
const said_of_webgl = [];
before(async () => {
  firefox = await puppeteer.launch({
    browser: 'firefox',
    executablePath: process.env.FIREFOX,
    // Without a display there is only EGL, which Firefox takes if MOZ_WEBGL_FORCE_EGL is set. Without a GPU, Mesa draws.
    env: { ...process.env, MOZ_WEBGL_FORCE_EGL: '1', LIBGL_ALWAYS_SOFTWARE: '1' },
    extraPrefsFirefox: {
      'webgl.force-enabled': true,
      'browser.download.folderList': 2,
      'browser.download.dir': folder,
    },
  });
  firefox.process().stderr.on('data', (data) => said_of_webgl.push(...String(data).split('\n').filter((line) => line.includes('WebGL warning'))));
});
after(() => firefox?.close());

// Runs `body` with a page on which nothing may go wrong.
async function onPageOf(browser, file, { hash = '', width = 960, height = 600, deviceScaleFactor = 1 }, body) {
  const context = await browser.createBrowserContext(), page = await context.newPage(), main = pathToFileURL(file).href, wrong = watched(page, main);
  page.setDefaultTimeout(10000);
  await page.setViewport({ width, height, deviceScaleFactor });
  await page.setOfflineMode(true);
  await page.goto(main + hash);
  const said = () => page.evaluate(() => document.querySelector('#instead p').textContent);
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true')
    .catch(async () => assert.fail(`The page is not ready. ${[await said(), ...wrong].join(' ')}`));
  await body(page);
  assert.deepEqual(wrong, []);
  await context.close();
}
const onPage = (...given) => onPageOf(firefox, ...given);

async function press(page, ...keys) {
  await page.focus('#canvas');
  for (const key of keys) await page.keyboard.press(key);
  await settled(page);
}

// Where a canvas is in the page.
const box_of = (page, id = 'canvas') => page.evaluate((id) => {
  const { x, y, width, height } = document.getElementById(id).getBoundingClientRect();
  return { x, y, width, height };
}, id);
const text_of = (page, selector) => page.$eval(selector, (element) => element.innerText);

for (const [scene, ...options] of scenes) {
  test(`each mode is another picture, by its key: ${scene} ${options.join(' ')}`, async () => {
    await onPage(page_of(scene, ...options), {}, async (page) => {
      const before = new Set([await seen(page)]);
      for (const [i, mode] of modes.entries()) {
        if (mode === 'levels') continue;  // is shown
        await press(page, String(i + 1));
        assert.equal((await address(page)).show, mode);
        const now = await seen(page);
        assert.ok(!before.has(now), `${mode} is another picture`);
        before.add(now);
        await shot(page, `firefox-${scene}-${mode}`);
      }
      await press(page, '1');
      assert.equal((await address(page)).show, undefined);
      assert.ok(before.has(await seen(page)), 'levels are as they were');
    });
  });
}

for (const [scene, level, ...options] of [
  ['spheres-l1', 6, '--volume', 'scb'],
  ['cone', 7, '--volume', 'scb2'],
  ['spheres-l1', 4, '--volume', 'dop14'],
  ['cone', 6, '--volume', 'rss'],
]) {
  test(`the id of each pixel is that of the picture: ${scene} ${options.join(' ')}`, () => assert_ids_of_picture(onPage, scene, level, ...options));
}

test('the id of each pixel is that in Chromium', { skip: process.env.CHROMIUM ? false : 'there is no chromium; install the package chromium' }, async () => {
  const chromium = await puppeteer.launch({ browser: 'chrome', executablePath: process.env.CHROMIUM, args: chromium_arguments });
  try {
    // Volumes are computed at each pixel. Where corners of triangles are, rasterizers round to more or fewer fractions of a pixel.
    const shares = { levels: 0.001, rejections: 0.002, pairs: 0.01 };
    for (const [scene, ...options] of scenes) {
      const [ours, others] = [{}, {}];
      for (const [browser, ids] of [[firefox, ours], [chromium, others]]) {
        await onPageOf(browser, page_of(scene, ...options), {}, async (page) => {
          for (const mode of Object.keys(shares)) {
            // With large volumes, too.
            await page.evaluate((mode) => document.getElementById('canvas').app.set({ mode, focus: 1 }), mode);
            ids[mode] = await ids_of(page, [320, 240]);
          }
        });
      }
      for (const [mode, share] of Object.entries(shares)) assert_same_ids(ours[mode], others[mode], share);
    }
  } finally {
    await chromium.close();
  }
});

test('a link opens what it says', async () => {
  const said = { level: '6', body: '1', node: '5', opacity: '0.5', theme: 'dark' };
  await onPage(page_of(...scenes[1]), { hash: `#${new URLSearchParams(said)}` }, async (page) => {
    const there = await address(page);
    for (const [name, value] of Object.entries(said)) assert.equal(there[name], value, name);
    assert.match(await text_of(page, '#panel'), /node\s+5\b/);
    assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(22, 25, 30)');
    await shot(page, 'firefox-link');
    // One that is followed on the page, too.
    await page.evaluate(() => {
      location.hash = '#level=3';
    });
    await page.waitForFunction(() => document.getElementById('canvas').app.state.level === 3);
    await settled(page);
    assert.equal((await address(page)).theme, 'dark');
  });
});

// A place of the canvas, in pixels of the page, and the node that the buffer of ids has there.
const a_node = (page, from) => page.evaluate((from) => {
  const { app, clientWidth, clientHeight } = document.getElementById('canvas');
  for (let i = from; i < from + 4000; ++i) {
    const [x, y] = [(i * 7919) % clientWidth, (i * 104729) % clientHeight], found = app.pick(x, y);
    if (found) return { x, y, body: found.body, node: app.treeOf(0, found.body).order[found.slot] };
  }
  throw new Error('no node is shown');
}, from);

for (const deviceScaleFactor of [1, 2]) {
  test(`a click selects the node of its pixel: ${deviceScaleFactor} pixels per pixel of the page`, async () => {
    await onPage(page_of(...scenes[0]), { deviceScaleFactor }, async (page) => {
      const box = await box_of(page), clicked = new Set();
      for (let i = 0; i < 5; ++i) {
        const { x, y, body, node } = await a_node(page, 5000 * i);
        await page.mouse.click(box.x + x, box.y + y);
        await settled(page);
        const there = await address(page);
        assert.deepEqual([Number(there.body), Number(there.node)], [body, node]);
        assert.match(await text_of(page, '#panel'), new RegExp(`node\\s+${node}\\b`));
        clicked.add(`${body} ${node}`);
      }
      assert.ok(clicked.size > 1, 'clicks select different nodes');
    });
  });
}

test('the mouse turns, moves and zooms, and goes through the traversal', async () => {
  await onPage(page_of(...scenes[0]), {}, async (page) => {
    const box = await box_of(page), x = box.x + box.width / 2, y = box.y + box.height / 2;
    const drag = async (modifier) => {
      if (modifier) await page.keyboard.down(modifier);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 60, y + 30, { steps: 4 });
      await page.mouse.up();
      if (modifier) await page.keyboard.up(modifier);
      await settled(page);
      return address(page);
    };
    const before = await address(page), turned = await drag(null), moved = await drag('Shift');
    assert.notEqual(turned.backward, before.backward);
    assert.equal(turned.target, before.target);
    assert.equal(moved.backward, turned.backward);
    assert.notEqual(moved.target, turned.target);
    await page.mouse.wheel({ deltaY: 300 });
    await page.waitForFunction((distance) => Number(new URLSearchParams(location.hash.slice(1)).get('distance')) > distance, {}, Number(moved.distance));
    await press(page, '6');
    const icicle = await box_of(page, 'icicle'), picture = await seen(page);
    // The middle of the box of a test that is wide enough to be hit.
    const { test, ...at } = await page.evaluate(() => {
      const { test, x, y, w, h } = document.getElementById('canvas').app.icicle.boxes.find(({ test, w }) => test > 0 && w > 20 && w < 200);
      return { test, x: x + w / 2, y: y + h / 2 };
    });
    await page.mouse.move(icicle.x + at.x, icicle.y + at.y);
    await settled(page);
    assert.notEqual(await seen(page), picture, 'the nodes of the test below the mouse are shown');
    await page.mouse.click(icicle.x + at.x, icicle.y + at.y);
    await settled(page);
    assert.equal(Number((await address(page)).root), test);
  });
});

test('keys search, and open and close the help', async () => {
  await onPage(page_of(...scenes[1]), {}, async (page) => {
    const open = () => page.evaluate(() => document.getElementById('help').open);
    // Firefox itself has a search by this key.
    await press(page, '/');
    await page.keyboard.type('A:5');
    await page.keyboard.press('Enter');
    await settled(page);
    assert.equal((await address(page)).node, '5');
    await press(page, 'h');
    assert.ok(await open());
    await shot(page, 'firefox-help');
    await page.keyboard.press('Escape');
    assert.ok(!(await open()));
    assert.equal((await address(page)).node, '5', 'it only closes the help');
    await press(page, ']');
    assert.equal((await address(page)).level, '6');
  });
});

test('it is drawn again in another size, and saved', async () => {
  await onPage(page_of(...scenes[0]), {}, async (page) => {
    await page.setViewport({ width: 700, height: 500 });
    await page.waitForFunction(() => {
      const { width, height, clientWidth, clientHeight } = document.getElementById('canvas');
      return width === clientWidth && height === clientHeight;
    });
    // As the reader sees it.
    const shown = join(folder, 'shown.png');
    await page.screenshot({ path: shown, clip: await box_of(page) });
    const picture = read_png(shown);
    assert.equal(picture.ids[0], 0xffffff, 'a corner has the color of the background');
    assert.ok(new Set(picture.ids).size > 50, 'the rest has colors');
    await press(page, 's');
    const saved = join(folder, 'cone.png');
    // It is empty at first.
    for (let i = 0; i < 100 && !(statSync(saved, { throwIfNoEntry: false })?.size > 0); ++i) await wait(100);
    const { width, height, ids } = read_png(saved);
    // With title, numbers and legend.
    const canvas = await page.evaluate(() => [document.getElementById('canvas').width, document.getElementById('canvas').height]);
    assert.ok(width === canvas[0] && height > canvas[1] + 50 && height < canvas[1] + 150);
    assert.ok(new Set(ids).size > 50);
  });
});

test('it fits a phone', async () => {
  await onPage(page_of(...scenes[0]), { width: 400, height: 800, deviceScaleFactor: 2 }, async (page) => {
    for (const [i, mode] of modes.entries()) {
      await press(page, String(i + 1));
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth && document.getElementById('panel').scrollWidth <= document.getElementById('panel').clientWidth), `nothing sticks out: ${mode}`);
      if (mode === 'tests') await shot(page, 'firefox-phone');
    }
    assert.ok((await box_of(page)).height > 150);
  });
});

test('WebGL warns of nothing', () => assert.deepEqual([...new Set(said_of_webgl)], []));
