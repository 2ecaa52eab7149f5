// Opens pages of `scb view` as files, as a reader would, and uses everything on them.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { address, assert_ids_of_picture, chromium_arguments, folder, page_of, read_png, scb, seen, settled, share_of_differences, shot, state, watched } from './pages.mjs';

function traced() {
  const file = join(folder, 'cone.scbrec');
  scb('trace', 'cone', '--volume', 'scb', '--frames', '100', '-o', file);
  return execFileSync(process.env.SCB, ['--quiet', 'trace', file, '--json', '--events'], { encoding: 'utf8', maxBuffer: 1 << 28 });
}

let browser;
before(async () => {
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: chromium_arguments });
});
after(() => browser?.close());

// Runs `body` with a page on which nothing may go wrong.
async function onPage(file, { hash = '', width = 960, height = 600, ...options }, body) {
  const context = await browser.newContext({ viewport: { width, height }, offline: true, ...options });
  const page = await context.newPage(), main = pathToFileURL(file).href, wrong = watched(page, main);
  await page.goto(main + hash);
  if (options.javaScriptEnabled !== false) await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
  await body(page, context);
  assert.deepEqual(wrong, []);
  await context.close();
}

async function press(page, ...keys) {
  for (const key of keys) await page.locator('#canvas').press(key);
  await settled(page);
}
// All sections of the panel.
const unfold = (page) => page.evaluate(() => document.querySelectorAll('details.section').forEach((one) => (one.open = true)));
// The canvas itself, with outlines.
const seen_on_canvas = (page) => page.evaluate(() => {
  const { app } = document.getElementById('canvas');
  app.draw();
  const { gl } = app.painter, { width, height } = app.canvas, pixels = new Uint8Array(4 * width * height);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let text = '';
  for (let i = 0; i < pixels.length; i += 12) text += String.fromCharCode(32 + (pixels[i] >> 2));
  return text;
});

for (const [scene, level, ...options] of [
  ['spheres-l1', 6, '--volume', 'scb'],
  ['knots-l1', 5, '--volume', 'obb'],
  ['cone', 7, '--volume', 'scb2'],
  ['spheres-l1', 4, '--volume', 'dop14'],
  ['cone', 6, '--volume', 'rss'],
  ['knots-l1', 7, '--volume', 'ball'],
  ['spheres-l1', 4, '--volume', 'scb', '--clip', '0.3,-1,0,0'],
  ['cone', 4, '--volume', 'scb2', '--clip', '0,-3,1,0', '--ortho'],
  ['knots-l1', 4, '--volume', 'obb', '--clip', '1,-1,0,0.1'],
  ['spheres-l1', 3, '--volume', 'dop14', '--clip', '0,-1,0,0.1'],
  ['cone', 2, '--volume', 'capsule', '--clip', '0,-1,0,0'],
]) {
  test(`the id of each pixel is that of the picture: ${scene} ${options.join(' ')}`, () => assert_ids_of_picture(onPage, scene, level, ...options));
}

test('levels, opacity, meshes, theme and frames change what is shown, and the address', async () => {
  await onPage(page_of('spheres-l1', '--level', '5'), {}, async (page) => {
    const seen_before = new Set([await seen(page)]);
    const changes = async (what) => {
      await settled(page);
      const now = await seen(page);
      assert.ok(!seen_before.has(now), `${what} changes the picture`);
      seen_before.add(now);
    };
    await page.getByLabel('Level', { exact: true }).fill('6');
    await changes('the level');
    assert.equal((await address(page)).level, '6');
    await page.getByText('Each body by itself').click();
    await page.getByLabel('B', { exact: true }).fill('2');
    await changes('the level of one body');
    assert.equal((await address(page)).level1, '2');
    await unfold(page);
    await page.getByLabel('Opacity').fill('40');
    await changes('opacity');
    await page.getByRole('button', { name: 'Meshes' }).click();
    await changes('meshes');
    await page.getByRole('button', { name: 'Edges' }).click();
    await changes('edges');
    await page.getByRole('button', { name: 'Orthographic' }).click();
    await changes('orthographic');
    await page.getByLabel('Frame', { exact: true }).fill('300');
    await changes('the frame');
    assert.equal((await address(page)).frame, '300');
    await page.getByRole('button', { name: 'Dark' }).click();
    await changes('the theme');
    await shot(page, 'dark');
    for (const name of ['X', 'Y', 'Z']) {
      await page.getByRole('button', { name, exact: true }).click();
      await changes(`the view along ${name}`);
    }
    await page.getByRole('button', { name: 'Fit' }).click();
    await changes('fit');
    // The address opens the same view.
    const hash = await page.evaluate(() => location.hash), picture = await seen(page);
    await onPage(page_of('spheres-l1', '--level', '5'), { hash }, async (again) => {
      await settled(again);
      // Rounded in the address.
      assert.ok(share_of_differences(await seen(again), picture) < 0.005);
    });
  });
});

// The numbers of the query, and the nodes at which its paths ended, are the same as in the pictures.
for (const options of [['--volume', 'scb'], ['--volume', 'obb', '--split', 'cost'], ['--volume', 'scb2', '--focus', '1']]) {
  test(`rejections are those of the picture: ${options.join(' ')}`, async () => {
    const out = join(folder, `rejections-${options.join('')}`), whole = options.includes('--focus'), own = options.filter((word, i) => word !== '--focus' && options[i - 1] !== '--focus');
    mkdirSync(out);
    scb('render', 'rejections', 'cone', ...options, '--frames', '100', '--size', '320x240', '--no-panel', '-o', out);
    const told = JSON.parse(readFileSync(join(out, 'index.json'))).files[0];
    await onPage(page_of('cone', ...own, '--frames', '100'), { hash: whole ? '#show=rejections&focus=1' : '#show=rejections' }, async (page) => {
      const found = await page.evaluate(() => {
        const { app } = document.getElementById('canvas'), { frame, nodes } = app.scenes[0];
        return {
          ...frame.stored, counts: frame.ended.counts, groups: app.columns[0].query.stored.groups, drawn: [0, 1].map((side) => nodes.filter((node) => node.side === side).length),
          lines: app.scenes[0].contacts.length,
        };
      });
      assert.deepEqual([found.n_v, found.n_p, found.pairs], [told.n_v, told.n_p, told.pairs]);
      // Equally large ones are told apart by the last digit, which is another one here.
      found.drawn.forEach((n, side) => assert.ok(Math.abs(n - told.volumes[side]) <= (whole ? 0 : 0.05 * told.volumes[side]), `${n} of ${told.volumes[side]} nodes`));
      const rejected = Object.entries(told.stages).filter(([name]) => name !== 'overlapping').reduce((sum, [, n]) => sum + n, 0);
      const of = (wanted) => found.counts.filter((_, i) => wanted(found.groups[i])).reduce((sum, n) => sum + n, 0);
      assert.equal(of((group) => !group.triangles && group.label !== 'left over'), rejected);
      assert.equal(of((group) => group.label === 'triangles meet'), told.pairs);
      assert.ok(found.lines > 0.95 * told.pairs, 'pairs of triangles meet in lines');
    });
  });
}

test('wasted tests are those that scb inspect counts', async () => {
  const sum = JSON.parse(scb('inspect', 'cone', '--frames', '100', '--json')).sum;
  await onPage(page_of('cone', '--volume', 'scb', '--frames', '100'), { hash: '#show=wasted' }, async (page) => {
    const total = await page.evaluate(() => document.getElementById('canvas').app.scenes[0].heat.total);
    assert.equal(total, sum.wasted.n_v);
    await press(page, '4');
    const [all, tests, first] = await page.evaluate(() => {
      const { app } = document.getElementById('canvas'), { heat, frame } = app.scenes[0], tree = app.treeOf(0, 0);
      const of = (slot) => frame.ended.sides[0].get(slot)?.tests ?? 0;
      let slot = tree.order.length - 1, sum = of(slot);
      const item = tree.itemsOf(slot)[0];
      for (let up = tree.parent[slot]; up >= 0; up = tree.parent[up]) sum += of(up);
      return [heat.total, frame.outcomes.length, [heat.counts[0][item], sum]];
    });
    assert.equal(all, tests);
    assert.equal(first[0], first[1]);
    await shot(page, 'heat');
  });
});

test('the traversal leads from test to test, and shows their nodes', async () => {
  const { frames: [{ tests }] } = JSON.parse(traced());
  await onPage(page_of('cone', '--volume', 'scb', '--frames', '100'), { hash: '#show=traversal' }, async (page) => {
    // Each test is the one that scb trace tells, and followed from the same one.
    const told = await page.evaluate(() => {
      const { frame } = document.getElementById('canvas').app.scenes[0], [a, b] = document.getElementById('canvas').app.columns[0].query.trees;
      return Array.from(frame.outcomes, (_, i) => [a.order[frame.a[i]], b.order[frame.b[i]], frame.parents[i]]);
    });
    assert.deepEqual(told, tests.map((t) => [...t.nodes, t.parent_test ?? -1]));
    const box = await page.locator('#icicle').boundingBox(), picture = await seen(page);
    await page.mouse.move(box.x + box.width / 3, box.y + box.height / 3);
    await settled(page);
    const { hover: test } = await state(page);
    assert.ok(test > 0);
    assert.notEqual(await seen(page), picture);
    await page.mouse.click(box.x + box.width / 3, box.y + box.height / 3);
    await settled(page);
    const there = await address(page);
    assert.equal(Number(there.root), test);
    await shot(page, 'traversal');
    await page.locator('#icicle').press('ArrowDown');
    await page.locator('#icicle').press('ArrowRight');
    await settled(page);
    assert.notEqual((await state(page)).test, test);
    assert.match(await page.locator('#panel').innerText(), /tests that follow/);
    await page.getByRole('button', { name: /^\d+, depth \d+$/ }).first().click();
    await settled(page);
    assert.match((await address(page)).node, /^\d+$/);
  });
});

// The page has the attribution of scb inspect, and the steps of scb explain.
for (const [scene, ...options] of [['cone', '--volume', 'scb', '--frames', '100'], ['spheres-l1', '--test', 'printed', '--frames', '50'], ['cone', '--volume', 'obb', '--frames', '100']]) {
  test(`verdicts and steps are those of inspect and explain: ${scene} ${options.join(' ')}`, async () => {
    // After wrong rejections the exit status of the two commands is not 0.
    const run = (words) => JSON.parse(spawnSync(process.env.SCB, ['--quiet', ...words], { encoding: 'utf8', maxBuffer: 1 << 28 }).stdout);
    const { sum } = run(['inspect', scene, ...options, '--json']);
    await onPage(page_of(scene, ...options), { hash: '#show=verdicts' }, async (page) => {
      const [counts, told] = await page.evaluate(() => {
        const { app } = document.getElementById('canvas');
        return [app.scenes[0].frame.judged.counts, app.columns[0].query.stored];
      });
      assert.deepEqual(counts, ['fit', 'test'].map((reason) => sum.inner[reason] + sum.leaves[reason]).concat(sum.wrongly_rejected));
      assert.equal(told.frames[0].wasted, sum.wasted.n_v);
      assert.ok(counts[0] > 0);
      const [first] = told.worst[0];
      // The list, the panel and the icicle agree on the test.
      await page.locator('.worst').first().getByRole('button', { name: first.nodes.join(), exact: true }).click();
      await settled(page);
      const number = (n) => n.toLocaleString('en-US');
      assert.match(await page.locator('.worst').first().innerText(), new RegExp(`${first.nodes.join()}\\s+${number(first.n_v)}\\s+${number(first.n_p)}`));
      assert.match(await page.locator('#panel').innerText(), new RegExp(`tests that follow\\s+${number(first.n_v)}\\s`));
      const { test, mode } = await state(page);
      assert.deepEqual([test, mode], [first.test, 'traversal']);
      // The two nodes in the scene, and the steps of their test.
      const [steps, command] = await page.evaluate((test) => {
        const { app } = document.getElementById('canvas');
        return [app.scenes[0].steps[test], app.explain(0, test)];
      }, test);
      const [explained] = run([...command.split(' ').slice(1), '--json']);
      assert.deepEqual(steps.steps.map(({ formula, slack, rejects }) => [formula, slack, rejects]), explained.steps.map(({ formula, slack, rejects }) => [formula, slack, rejects]));
      assert.equal(steps.answer, explained.answer);
      const text = await page.locator('#panel').innerText();
      assert.ok(text.includes(explained.steps[0].formula) && text.includes(command));
      await shot(page, 'steps');
    });
  });
}

test('two queries stand beside each other, and what differs is outlined and counted', async () => {
  const traces = ['corrected', 'printed'].map((name) => {
    const file = join(folder, `${name}.scbrec`);
    scb('trace', 'spheres-l1', '--frames', '50', '--test', name, '-o', file);
    return file;
  });
  const diff = JSON.parse(spawnSync(process.env.SCB, ['diff', ...traces, '--json'], { encoding: 'utf8' }).stdout);
  for (const file of [page_of(...traces), page_of('spheres-l1', '--compare', 'corrected,printed', '--frames', '50')])
    await onPage(file, { hash: '#show=pairs' }, async (page) => {
      const only = await page.evaluate(() => [0, 1].map((k) => document.getElementById('canvas').app.content.pairsOnlyHere(k).length));
      assert.deepEqual(only, [diff.pairs_only_in_a, diff.pairs_only_in_b]);
      assert.ok(only[0] > 0);
      await press(page, 'a', 'x');
      const outlined = await seen_on_canvas(page);
      await press(page, 'd');
      assert.ok(share_of_differences(await seen_on_canvas(page), outlined) > 0.0003, 'outlines are drawn');
      assert.equal((await address(page)).differences, '0');
      await press(page, 'd', '2');
      assert.match(await page.locator('#panel').innerText(), /tests only here/);
      await shot(page, 'compared');
      const parts = await page.evaluate(() => {
        const { app } = document.getElementById('canvas'), [a, b] = app.scenes.map(({ frame }) => new Set(Array.from(frame.a, (slot, i) => `${slot} ${frame.b[i]}`)));
        return [[...a].filter((key) => !b.has(key)).length, [...b].filter((key) => !a.has(key)).length];
      });
      const text = await page.locator('#panel').innerText();
      assert.match(text, new RegExp(`tests only here\\s+${parts[0].toLocaleString('en-US')}\\s+${parts[1].toLocaleString('en-US')}`));
      // A pair that one of them missed leads to the test that lost it, with the error of its formula.
      await press(page, '3');
      const pair = await page.evaluate(() => document.getElementById('canvas').app.content.pairsOnlyHere(0)[0].join());
      await page.getByRole('button', { name: pair, exact: true }).click();
      await settled(page);
      assert.match(await page.locator('#panel').innerText(), /corrected: found[\s\S]*printed: missed/);
      await page.getByRole('button', { name: /^Lost at/ }).click();
      await settled(page);
      const lost = await page.evaluate(() => {
        const { app } = document.getElementById('canvas'), { frame } = app.scenes[1];
        return { mode: app.state.mode, column: app.state.column, worth: frame.worths[app.state.test], rejects: app.columns[1].query.rejects(frame.outcomes[app.state.test]) };
      });
      assert.deepEqual(lost, { mode: 'traversal', column: 1, worth: 3, rejects: true });
      assert.match(await page.locator('#panel').innerText(), /rejected wrongly[\s\S]*in corrected\s+passed[\s\S]*as printed/);
      assert.equal(await page.locator('#whose').innerText(), 'printed');
      // All that erred have their steps.
      const steps = await page.evaluate(() => {
        const { app } = document.getElementById('canvas'), { frame, steps } = app.scenes[1];
        return [...frame.worths.keys()].filter((test) => frame.worths[test] === 3).every((test) => test in steps);
      });
      assert.ok(steps);
      // Back leads to the pair, and on to the pairs, in this page.
      await page.goBack();
      await settled(page);
      assert.equal((await address(page)).pair, `${pair},0`);
      await page.goBack();
      await settled(page);
      assert.deepEqual([(await address(page)).pair, (await address(page)).show], [undefined, 'pairs']);
    });
});

test('each level tells how many of its volumes overlap, and which shows a gap', async () => {
  for (const [frame, meets] of [['100', true], ['0', false]])
    await onPage(page_of('cone', '--frames', frame, '--volume', 'obb'), {}, async (page) => {
      const overlaps = await page.evaluate(() => document.getElementById('canvas').app.columns[0].query.stored.frames[0].overlaps);
      assert.equal(overlaps.at(-1) > 0, meets);
      const text = async () => (await page.locator('#panel').innerText()).replaceAll(/\s+/g, ' ');
      assert.ok((await text()).includes(`first level with a gap ${meets ? 'none has one' : `level ${overlaps.length - 1}`}`));
      for (const level of [0, 3]) {
        await page.getByLabel('Level', { exact: true }).fill(String(level));
        await settled(page);
        assert.ok((await text()).includes(`overlapping pairs ${(overlaps[level] ?? 0).toLocaleString('en-US')} `));
      }
    });
});

test('what is isolated holds for queries, and wrong rejections are never left out', async () => {
  await onPage(page_of('spheres-l1', '--test', 'printed', '--frames', '50', '--volume', 'scb'), { hash: '#show=verdicts' }, async (page) => {
    const wrong = () => page.evaluate(() => {
      const { app } = document.getElementById('canvas'), { nodes, classes } = app.scenes[0];
      return [new Set(nodes.filter(({ group }) => group === 2).map(({ side, slot }) => `${side} ${slot}`)).size, classes.counts[2], nodes.length];
    });
    const [drawn, , all] = await wrong();
    await page.evaluate(() => document.getElementById('canvas').app.set({ focus: 1 }));
    const [every, , more] = await wrong();
    assert.ok(drawn > 0 && more > all);
    assert.equal(drawn, every);
    await page.evaluate(() => document.getElementById('canvas').app.set({ mode: 'rejections', focus: 0.5 }));
    const counts = () => page.evaluate(() => {
      const { app } = document.getElementById('canvas'), { frame, classes } = app.scenes[0], tree = app.treeOf(0, 0), slot = tree.slotOf(1);
      let tests = 0;
      frame.outcomes.forEach((outcome, i) => (tests += outcome >= 2 && tree.isBelow(frame.a[i], slot) ? 1 : 0));
      return [tests, classes.counts.reduce((sum, n) => sum + n, 0), app.scenes[0].nodes.length];
    });
    const [part, before] = await counts();
    assert.ok(part < before);
    const picture = await seen(page);
    await page.evaluate(() => document.getElementById('canvas').app.find('A:1'));
    await settled(page);
    // A node that no path ended at is drawn all the same.
    assert.ok(share_of_differences(await seen(page), picture) > 0.01);
    await press(page, 'i');
    const [again, shown] = await counts();
    assert.deepEqual([again, shown], [part, part]);
    await press(page, '3');
    const [pairs, few] = await page.evaluate(async () => {
      const { app } = document.getElementById('canvas'), tree = app.treeOf(0, 0);
      let slot = await app.leafOf(0, 0, app.scenes[0].frame.pairs[0]);
      while (tree.levelOf(slot) > 8) slot = tree.parent[slot];
      await app.select(0, 0, slot);
      return [app.scenes[0].frame.pairs.length, app.scenes[0].pairs.length];
    });
    assert.ok(few < pairs && few > 0);
  });
});

test('two scenes stand beside each other', async () => {
  await onPage(page_of('cone', 'spheres-l1', '--level', '5'), {}, async (page) => {
    const picked = await page.evaluate(() => {
      const { app, clientWidth, clientHeight } = document.getElementById('canvas'), found = new Set();
      for (let i = 0; i < 4000; ++i) {
        const hit = app.pick((i * 7919) % clientWidth, (i * 104729) % clientHeight);
        if (hit) found.add(`${hit.column} ${hit.body}`);
      }
      return [...found].sort();
    });
    assert.deepEqual(picked, ['0 0', '0 1', '1 0', '1 1']);
    assert.equal(await page.locator('#panel code').count(), 2, 'a command for each');
  });
});

test('what hides a contact is translucent, and hidden lines are dashed', async () => {
  for (const options of [[], ['--ortho']])
    await onPage(page_of('cone', '--frames', '100', ...options), { width: 500, height: 400, hash: '#show=pairs' }, async (page) => {
      await page.evaluate(() => {
        const { app } = document.getElementById('canvas'), { axes } = app.view;
        app.approach();
        app.view.axes = axes;  // from where a part of the lines is hidden
        app.moved();
      });
      await settled(page);
      await shot(page, `ghost${options.join('')}`);
      const found = await page.evaluate(() => {
        const { app } = document.getElementById('canvas'), { painter } = app, { gl } = painter, { drawHidden, drawSegments } = painter, read = () => {
          app.draw();
          const [width, height] = painter.size, colors = new Uint8Array(4 * width * height), ids = new Uint32Array(width * height);
          painter.idAt(0, 0);
          gl.readPixels(0, 0, width, height, gl.RED_INTEGER, gl.UNSIGNED_INT, ids);
          gl.readBuffer(gl.COLOR_ATTACHMENT0);
          gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, colors);
          return { colors, ids };
        };
        const black = ({ colors }) => colors.reduce((sum, c, i) => sum + (i % 4 === 0 && app.theme.text.every((x, k) => colors[i + k] === x) ? 1 : 0), 0);
        const whole = read();
        painter.drawSegments = () => {};
        const shining = read();
        painter.drawHidden = () => {};
        const plain = read();
        painter.drawHidden = drawHidden;
        painter.drawSegments = (pane, drawn) => drawn.dashed || drawSegments.call(painter, pane, drawn);
        const seen = read();
        painter.drawSegments = (pane, drawn) => drawSegments.call(painter, pane, { ...drawn, dashed: false });
        const solid = read();
        // Where something shines through, what is in front is not in a pair.
        const { whole: firsts, marked } = app.triangleIds[0], changed = [...plain.ids.keys()].filter((i) => [0, 1, 2].some((k) => plain.colors[4 * i + k] !== shining.colors[4 * i + k]));
        const behind = changed.filter((i) => plain.ids[i] >= firsts[0] && plain.ids[i] < marked[0]).length;
        return { changed: changed.length, behind, ids: whole.ids.every((id, i) => id === plain.ids[i]), black: [seen, whole, solid].map(black) };
      });
      assert.ok(found.changed > 300, `${found.changed} pixels`);
      assert.equal(found.behind, found.changed);
      assert.ok(found.ids, 'a click finds what is in front');
      const [seen, dashed, solid] = found.black, share = (dashed - seen) / (solid - seen);
      assert.ok(solid > seen + 200 && share > 0.5 && share < 0.75, `${found.black}`);
    });
});

test('a hidden node is seen through what hides it, and one goes to where it is visible', async () => {
  await onPage(page_of('cone', '--level', '6'), { width: 700, height: 400 }, async (page) => {
    const { hidden, shining, same } = await page.evaluate(async () => {
      const { app } = document.getElementById('canvas'), { painter, content } = app, { first_id, tree } = app.columns[0].bodies[0];
      const ids = () => (app.draw(), painter.idsIn([0, 0, ...painter.size]));
      const seen = new Set(ids()), slot = app.content.coverOf(0, 0).find((slot) => !seen.has(first_id + tree.order[slot]));
      await app.select(0, 0, slot);
      const hidden = !ids().includes(first_id + tree.order[slot]), colors = () => {
        const before = ids(), pixels = new Uint8Array(4 * before.length);
        painter.gl.readBuffer(painter.gl.COLOR_ATTACHMENT0);
        painter.gl.readPixels(0, 0, ...painter.size, painter.gl.RGBA, painter.gl.UNSIGNED_BYTE, pixels);
        return { before, pixels };
      };
      const through = colors(), pane = content.pane.bind(content);
      content.pane = (k, eye) => ({ ...pane(k, eye), shining: [] });
      const plain = colors();
      content.pane = pane;
      return { hidden, shining: through.pixels.filter((c, i) => c !== plain.pixels[i]).length, same: through.before.every((id, i) => id === plain.before[i]) };
    });
    assert.ok(hidden && same && shining > 200, `${shining}`);
    await shot(page, 'through');
    await press(page, 'a');
    const [there, others] = await page.evaluate(() => {
      const { app } = document.getElementById('canvas'), { first_id, tree } = app.columns[0].bodies[0], id = first_id + tree.order[app.state.selected.slot], { axes } = app.view;
      const count = () => (app.draw(), app.painter.idsIn([0, 0, ...app.painter.size]).filter((one) => one === id).length);
      const there = count(), others = [0, 1, 2].flatMap((axis) => [1, -1].map((sign) => (app.view.along([0, 1, 2].map((i) => (i === axis ? sign : 0))), count())));
      app.view.axes = axes;
      return [there, others];
    });
    assert.ok(there > 1000 && others.every((n) => n < 1.1 * there) && others.some((n) => n < 0.5 * there), `${there}; ${others}`);
    await shot(page, 'approached');
    // Where no direction shows more, it stays.
    const { backward } = await address(page);
    await press(page, 'a');
    assert.equal((await address(page)).backward, backward);
  });
});

test('a line of contact names its pair, and two numbers their test', async () => {
  await onPage(page_of('cone', '--frames', '100'), { hash: '#show=pairs' }, async (page) => {
    await press(page, 'a');
    const [x, y, pair] = await page.evaluate(() => {
      const { app, clientWidth, clientHeight } = document.getElementById('canvas');
      for (let i = 0; i < 20000; ++i) {
        const at = [(i * 7919) % clientWidth, (i * 104729) % clientHeight], found = app.pick(...at);
        if (found?.pair) return [...at, found.pair];
      }
      return [0, 0, null];
    });
    const box = await page.locator('#canvas').boundingBox();
    await page.mouse.click(box.x + x, box.y + y);
    await page.waitForFunction(() => document.getElementById('canvas').app.state.pair);
    await settled(page);
    assert.deepEqual((await state(page)).pair.slice(0, 2), pair);
    assert.ok(await page.evaluate((pair) => {
      const { pairs } = document.getElementById('canvas').app.scenes[0].frame;
      for (let i = 0; i < pairs.length; i += 2) if (pairs[i] === pair[0] && pairs[i + 1] === pair[1]) return true;
      return false;
    }, pair));
    await page.getByRole('button', { name: 'The test of these leaves' }).click();
    await settled(page);
    const { mode, test } = await state(page);
    assert.equal(mode, 'traversal');
    const nodes = await page.evaluate((test) => {
      const { app } = document.getElementById('canvas'), { frame } = app.scenes[0], { trees } = app.columns[0].query;
      const has = trees.every((tree, side) => [...tree.itemsOf((side === 0 ? frame.a : frame.b)[test])].length > 0);
      return has && [trees[0].order[frame.a[test]], trees[1].order[frame.b[test]]];
    }, test);
    assert.ok(nodes);
    await press(page, '2', '/');
    await page.keyboard.type(nodes.join());
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.getElementById('canvas').app.state.mode === 'traversal');
    assert.equal((await state(page)).test, test);
    // A link by nodes, as reports have it.
    await onPage(page_of('cone', '--frames', '100'), { hash: `#frame=100&nodes=${nodes}` }, async (linked) => {
      await settled(linked);
      const there = await state(linked);
      assert.deepEqual([there.mode, there.test], ['traversal', test]);
    });
  });
});

test('the matrix is that of the events, and lights up scene and icicle', async () => {
  const { frames: [{ tests }] } = JSON.parse(traced()), cells = new Map();
  for (const { depths } of tests) cells.set(depths.join(), (cells.get(depths.join()) ?? 0) + 1);
  await onPage(page_of('cone', '--volume', 'scb', '--frames', '100'), { hash: '#show=traversal' }, async (page) => {
    const found = await page.evaluate(() => [...document.getElementById('canvas').app.scenes[0].frame.cells.all].map(([key, { tests }]) => [key, tests]));
    assert.deepEqual(new Map(found), cells);
    const icicle = await page.locator('#icicle').screenshot(), scene = await seen(page), box = await page.locator('#matrix').boundingBox();
    // A node below the mouse lights up its tests.
    const [node_x, node_y] = await page.evaluate(() => {
      const { app, clientWidth, clientHeight } = document.getElementById('canvas');
      for (let i = 0; i < 20000; ++i) {
        const at = [(i * 7919) % clientWidth, (i * 104729) % clientHeight];
        if (app.pick(...at)?.slot >= 0) return at;
      }
      return [0, 0];
    });
    const canvas = await page.locator('#canvas').boundingBox();
    await page.mouse.move(canvas.x + node_x, canvas.y + node_y);
    assert.ok(!(await page.locator('#icicle').screenshot()).equals(icicle));
    await page.mouse.move(5, 5);
    const [x, y, key] = await page.evaluate(() => {
      const { matrix, scenes } = document.getElementById('canvas').app, [key, cell] = [...scenes[0].frame.cells.all].sort((p, q) => q[1].tests - p[1].tests)[0];
      return [matrix.corner[0] + (cell.x + 0.5) * matrix.size, matrix.corner[1] + (cell.y + 0.5) * matrix.size, key];
    });
    await page.mouse.move(box.x + x, box.y + y);
    await settled(page);
    assert.equal(String((await state(page)).cell), key);
    assert.notEqual(await seen(page), scene);
    assert.ok(!(await page.locator('#icicle').screenshot()).equals(icicle));
    await page.mouse.click(box.x + x, box.y + y);
    await page.mouse.move(5, 5);
    await settled(page);
    assert.equal((await address(page)).cell, key, 'a click holds it');
    await shot(page, 'matrix');
    await page.locator('#matrix').press('ArrowLeft');
    await settled(page);
  });
});

test('bodies are hidden, and a plane cuts', async () => {
  await onPage(page_of('cone', '--level', '5'), {}, async (page) => {
    const whole = await seen(page);
    await page.getByRole('button', { name: 'B', exact: true }).click();
    await settled(page);
    const without = await seen(page);
    assert.notEqual(without, whole);
    assert.equal((await address(page)).without, '1');
    await press(page, 'k');
    assert.match((await address(page)).clip, /^-?[01](,-?[01]){2},/);
    assert.notEqual(await seen(page), without);
    const { clip } = await state(page);
    await page.getByRole('button', { name: 'Other side' }).click();
    await settled(page);
    assert.deepEqual((await state(page)).clip.normal, clip.normal.map((x) => -x + 0));
    await shot(page, 'clip');
    await press(page, 'k');
    assert.equal(await seen(page), without);
  });
});

test('rejections and pairs change what is shown, filter, and answer', async () => {
  await onPage(page_of('cone', '--frames', '100', '--queries', '90:110:10'), {}, async (page) => {
    const before = new Set([await seen(page)]);
    const changes = async (what) => {
      await settled(page);
      const now = await seen(page);
      assert.ok(!before.has(now), `${what} changes the picture`);
      before.add(now);
    };
    await page.getByRole('tab', { name: 'Rejections' }).click();
    await changes('rejections');
    assert.equal((await address(page)).show, 'rejections');
    assert.ok(!(await page.getByLabel('Level', { exact: true }).isVisible()));
    await page.getByLabel(/triangles apart/).uncheck();
    await changes('a filter');
    assert.equal((await address(page)).hide, 'triangles apart');
    const [most, highest] = await page.evaluate(() => {
      const { app } = document.getElementById('canvas'), { frame } = app.scenes[0], { query } = app.columns[0], [[slot, n]] = query.mostOf(frame.ended, 0, (group) => query.stored.groups[group].rejects);
      const counts = new Map();
      frame.outcomes.forEach((outcome, i) => outcome > 1 && query.stored.groups[outcome - 2].rejects && counts.set(frame.a[i], (counts.get(frame.a[i]) ?? 0) + 1));
      return [[n, `${query.trees[0].order[slot]}: ${n.toLocaleString('en-US')}`], Math.max(...counts.values())];
    });
    assert.equal(most[0], highest);
    await page.getByRole('button', { name: most[1], exact: true }).first().click();
    await settled(page);
    assert.equal((await address(page)).node, most[1].split(':')[0]);
    await page.getByRole('button', { name: 'Large volumes too' }).click();
    await changes('large volumes');
    await shot(page, 'rejections');
    const [x, y] = await page.evaluate(() => {
      const { app, clientWidth, clientHeight } = document.getElementById('canvas');
      for (let i = 0; i < 4000; ++i) {
        const at = [(i * 7919) % clientWidth, (i * 104729) % clientHeight];
        if (app.pick(...at)) return at;
      }
      return [0, 0];
    });
    const box = await page.locator('#canvas').boundingBox();
    await page.mouse.click(box.x + x, box.y + y);
    await settled(page);
    assert.match(await page.locator('#panel').innerText(), /Tests: [\d,]+/);
    await page.getByRole('tab', { name: 'Pairs', exact: true }).click();
    await changes('pairs');
    assert.match(await page.locator('#panel').innerText(), /A: [\d,]+ triangles meet others/);
    await shot(page, 'pairs');
    // Each triangle that is drawn as meeting others names these.
    const told = await page.evaluate(async () => {
      const { app, clientWidth, clientHeight } = document.getElementById('canvas'), { meeting, parts } = app.scenes[0];
      for (let i = 0; i < 20000; ++i) {
        const found = app.pick((i * 7919) % clientWidth, (i * 104729) % clientHeight);
        if (found?.triangle === undefined || !parts.some((part) => part.side === found.body && part.triangles.includes(found.triangle))) continue;
        await app.selectTriangle(0, found.body, found.triangle);
        const tree = app.treeOf(0, found.body);
        return { has: [...tree.itemsOf(app.state.selected.slot)].includes(found.triangle), text: app.panel.nodePanel.body.textContent, meets: meeting[found.body].has(found.triangle) };
      }
      return null;
    });
    assert.ok(told.has && told.meets);
    assert.match(told.text, /triangle\d+in the leaf\d+.*It meets \d+ of/);
    // From one frame with a query to the next; the slider leads to others, and back to the nearest.
    await press(page, '.');
    assert.equal((await address(page)).frame, '110');
    await page.getByLabel('Frame', { exact: true }).fill('98');
    await settled(page);
    assert.match(await page.locator('#panel').innerText(), /no query of frame 98, but of 90, 100, 110/);
    await page.getByRole('button', { name: 'Frame 100' }).click();
    await settled(page);
    assert.equal((await address(page)).frame, '100');
    const chart = await page.locator('.chart').boundingBox();
    await page.mouse.click(chart.x + 2, chart.y + 10);
    await settled(page);
    assert.equal((await address(page)).frame, '90');
    await press(page, '1');
    assert.equal((await state(page)).mode, 'levels');
  });
});

test('another engine\'s recording is a page like any other', async () => {
  const file = join(folder, 'own.scbrec');
  scb('trace', 'cone', '--frames', '100', '--volume', 'rss', '--records', '-o', file);
  await onPage(page_of(file), { hash: '#show=rejections' }, async (page) => {
    const [recorded, own] = [await seen(page), page_of('cone', '--volume', 'rss', '--frames', '100')];
    const view = await page.evaluate(() => location.hash);
    await onPage(own, { hash: view }, async (page) => {
      assert.equal((await state(page)).mode, 'rejections');
      assert.ok(share_of_differences(await seen(page), recorded) < 0.02);
    });
  });
  // Of boxes the test is exact, so that the levels have the same pairs.
  const boxes = join(folder, 'boxes.scbrec'), overlaps = [];
  scb('trace', 'cone', '--frames', '100', '--volume', 'obb', '--records', '-o', boxes);
  for (const made of [page_of(boxes), page_of('cone', '--volume', 'obb', '--frames', '100')])
    await onPage(made, {}, async (page) => overlaps.push(await page.evaluate(() => document.getElementById('canvas').app.columns[0].query.stored.frames[0].overlaps)));
  assert.ok(overlaps[0].length > 5);
  assert.deepEqual(overlaps[0], overlaps[1]);
});

// A recording of an engine with other node numbers: numbers of A count down, numbers of B are swapped in pairs. Each seventh node has a name.
const number_of = [(node) => 100000 - 3 * node, (node) => 3000000007 + 2 * (node ^ 1)];
function renumbered(file) {
  const lines = file.replace('.scbrec', '.jsonl'), made = file.replace('.scbrec', '-numbers.jsonl');
  scb('convert', file, '-o', lines);
  const numbered = (line) => {
    const number = number_of[line.in_tree];
    if ('node' in line) Object.assign(line, { name: line.node % 7 === 0 ? `node of ${line.node}` : '', node: number(line.node), children: line.children?.map(number), parent: line.parent === null ? null : number(line.parent) });
    if ('refit' in line) line.refit = number(line.refit);
    if ('tests' in line) line.tests = line.tests.map((test) => (typeof test[0] === 'string' ? test : [test[0], number_of[0](test[1]), number_of[1](test[2])]));
    return line;
  };
  writeFileSync(made, readFileSync(lines, 'utf8').trim().split('\n').map((line) => JSON.stringify(numbered(JSON.parse(line)))).join('\n'));
  return made;
}

test('another engine\'s nodes have its numbers', async () => {
  const file = join(folder, 'numbers.scbrec');
  scb('trace', 'cone', '--frames', '100', '--volume', 'obb', '--records', '-o', file);
  const other = renumbered(file), { frames: [{ tests }] } = JSON.parse(execFileSync(process.env.SCB, ['--quiet', 'trace', other, '--json', '--events'], { encoding: 'utf8', maxBuffer: 1 << 28 }));
  // One whose node of A has a name, and from which others followed.
  const sizes = tests.map(() => 1);
  for (let i = tests.length - 1; i > 0; --i) sizes[tests[i].parent_test] += sizes[i];
  const test = tests.findIndex(({ nodes: [a] }, i) => i > 0 && (100000 - a) % 21 === 0 && sizes[i] > 1), [a, b] = tests[test].nodes;
  assert.ok(test > 0);
  await onPage(page_of(other), { hash: `#frame=100&nodes=${a},${b}` }, async (page) => {
    await settled(page);
    const now = await state(page), evaluated = (...what) => page.evaluate(...what);
    assert.deepEqual([now.mode, now.test], ['traversal', test]);
    // The page has the tests of scb trace.
    assert.deepEqual(await evaluated(() => {
      const { app } = document.getElementById('canvas'), { frame } = app.scenes[0];
      return Array.from(frame.outcomes, (_, i) => app.columns[0].query.pairText(frame, i));
    }), tests.map(({ nodes }) => nodes.join()));
    const panel = () => page.locator('#panel').innerText(), name = `${a} "node of ${(100000 - a) / 3}"`;
    assert.ok((await panel()).includes(`${name}, depth ${tests[test].depths[0]}`));
    await evaluated((root) => document.getElementById('canvas').app.set({ root }), test);
    await settled(page);
    const [command] = await evaluated(() => document.getElementById('canvas').app.commands());
    assert.ok(command.includes(` --root ${a},${b} `), command);
    const words = command.split(' ').slice(1), out = join(folder, 'numbers');
    scb(...words.slice(0, -1), out);
    assert.equal(JSON.parse(readFileSync(join(out, 'index.json'))).files[0].n_v, sizes[test]);
    // Lists, links and searches.
    for (const list of await evaluated(() => document.getElementById('canvas').app.columns[0].query.stored.worst))
      for (const { test: worst, nodes } of list) assert.deepEqual(nodes, tests[worst].nodes);
    await page.getByRole('button', { name: `${name}, depth`, exact: false }).click();
    await settled(page);
    const chosen = await address(page);
    assert.deepEqual([chosen.body, chosen.node], ['0', String(a)]);
    const hash = await evaluated(() => location.hash);
    await onPage(page_of(other), { hash }, async (again) => {
      await settled(again);
      assert.equal((await state(again)).selected.slot, (await state(page)).selected.slot);
      assert.equal((await address(again)).node, String(a));
    });
    // Whom it met, and what is above it.
    const met = new Set(tests.filter(({ nodes }) => nodes[0] === a).map(({ nodes }) => String(nodes[1])));
    const listed = await page.locator('#panel button').allInnerTexts();
    assert.ok([...met].slice(0, 5).every((number) => listed.includes(number)));
    assert.ok(listed.includes('100000'), 'the root');
    await press(page, '1', '/');
    await page.keyboard.type(`B:${b}`);
    await page.keyboard.press('Enter');
    await settled(page);
    assert.equal((await address(page)).node, String(b));
    await unfold(page);
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'GLB' }).click()]);
    await download.saveAs(join(folder, 'numbers.glb'));
    const bytes = readFileSync(join(folder, 'numbers.glb')), glb = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)));
    assert.deepEqual(glb.nodes.slice(1).map(({ name, extras }) => [name, extras.id]), [[`B ${b}`, b]]);
    await press(page, '2');
    const most = await page.getByRole('button', { name: /^\d+: [\d,]+$/ }).allInnerTexts();
    assert.ok(most.length > 4 && most.every((text) => { const n = Number(text.split(':')[0]); return n > 3e9 || (100000 - n) % 3 === 0; }), most.join('; '));
  });
  // Beside the query of this program each has its own.
  await onPage(page_of(other, '--compare', 'recorded,scb2'), { hash: `#frame=100&nodes=${a},${b}` }, async (page) => {
    await settled(page);
    assert.deepEqual([(await state(page)).column, (await state(page)).test], [0, test]);
    const numbers = await page.evaluate(() => document.getElementById('canvas').app.columns.map(({ query }) => query.trees.map((tree) => [tree.numberOf(1), tree.slotOfNumber(1), tree.slotOfNumber(99997)])));
    assert.deepEqual(numbers, [[[99997, -1, 1], [3000000007, -1, -1]], [[1, 1, -1], [1, 1, -1]]]);
  });
});

test('an engine may go into both nodes at once', async () => {
  const box = (from, to) => ['aabb', from, 0, 0, to, 1, 1], file = join(folder, 'both.jsonl');
  const tree = (number) => [{ tree: number, name: '', of_mesh: null, directions: [] }, { node: 10, in_tree: number, parent: null, children: [11, 12], items: [], volume: box(0, 2) },
    { node: 11, in_tree: number, parent: 10, children: [], items: [0], volume: box(0, 1) }, { node: 12, in_tree: number, parent: 10, children: [], items: [1], volume: box(1, 2) }];
  const lines = [...tree(0), ...tree(1), { body: 0, name: 'A', of_tree: 0 }, { body: 1, name: 'B', of_tree: 1 }, { frame: 0 }, { query: [0, 1] },
    { tests: [[0, 10, 10], [0, 11, 11], [1, 11, 12], [1, 12, 11], [0, 12, 12], ['pair', 0, 0], ['pair', 1, 1]] }, { complete: true, nanoseconds: 0 }, { end: true }];
  writeFileSync(file, lines.map((line) => JSON.stringify(line)).join('\n'));
  await onPage(page_of(file), { hash: '#show=traversal&test=0' }, async (page) => {
    assert.match(await page.locator('#panel').innerText(), /passed: both were divided/);
  });
});

test('keys do all of it', async () => {
  await onPage(page_of('spheres-l1', '--level', '5'), {}, async (page) => {
    await press(page, ']', ']', '[');
    assert.equal((await state(page)).level, 6);
    await press(page, '.', '.', ',');
    assert.equal((await state(page)).at, 1);
    await press(page, 'm', 'e', 'o', 't');
    const now = await state(page);
    assert.deepEqual([now.mesh, now.edges, now.orthographic, now.theme], [true, true, true, 'dark']);
    const picture = await seen(page);
    await press(page, 'ArrowLeft', 'ArrowUp', '+');
    assert.notEqual(await seen(page), picture);
    await press(page, 'f', 'x', 'Y');
    await press(page, '/');
    await page.keyboard.type('A:5');
    await page.keyboard.press('Enter');
    await settled(page);
    assert.match(await page.locator('#panel').innerText(), /node\s+5\b/);
    await press(page, 'p');
    const parent = (await address(page)).node;
    assert.notEqual(parent, '5');
    await press(page, 'c', 'n');
    await press(page, 'i');
    assert.equal((await address(page)).only, '1');
    await press(page, 'Escape');
    assert.equal((await state(page)).selected, null);
    await press(page, 'h');
    assert.ok(await page.locator('#help').isVisible());
    await page.keyboard.press('Escape');
    await press(page, ' ');
    await page.waitForFunction(() => document.getElementById('canvas').app.state.at > 1);  // frames are played
    await press(page, ' ');
  });
});

test('a click names the node, and what hangs on it', async () => {
  await onPage(page_of('cone', '--volume', 'scb2,obb', '--level', '4'), {}, async (page) => {
    const box = await page.locator('#canvas').boundingBox();
    const [x, y] = await page.evaluate(() => {
      const { app, clientWidth, clientHeight } = document.getElementById('canvas');
      for (let x = clientWidth / 4; x > 0; x -= 10) if (app.pick(x, clientHeight / 2)) return [x, clientHeight / 2];
      return [0, 0];
    });
    await page.mouse.click(box.x + x, box.y + y);
    await settled(page);
    const panel = await page.locator('#panel').innerText();
    assert.match(panel, /depth\s+4/);
    assert.match(panel, /SCB2/);
    assert.match(panel, /Tests, OBB: (none|\d+)/);
    assert.match(panel, /half sides/);
    const { node } = await address(page);
    assert.match(node, /^\d+$/);
    await shot(page, 'node');
    await page.getByRole('button', { name: 'Only what is below it' }).click();
    await settled(page);
    assert.ok(await page.evaluate(() => document.getElementById('canvas').app.content.level(0, Number(new URLSearchParams(location.hash.slice(1)).get('body'))).length > 0));
    await shot(page, 'isolated');
    await page.getByLabel('Search a node by its number').fill('no such');
    await page.getByLabel('Search a node by its number').press('Enter');
    assert.match(await page.locator('#panel').innerText(), /There is no node no such/);
  });
});

async function saved_png(page) {
  await unfold(page);
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'PNG' }).click()]);
  assert.equal(download.suggestedFilename(), 'cone.png');
  const file = join(folder, 'saved.png');
  await download.saveAs(file);
  return read_png(file);
}

test('what is seen is saved as PNG', async () => {
  await onPage(page_of('cone', '--level', '4'), {}, async (page) => {
    const { width, height, ids } = await saved_png(page), size = await page.evaluate(() => [document.getElementById('canvas').width, document.getElementById('canvas').height]);
    // With title, numbers and legend.
    assert.ok(width === size[0] && height > size[1] + 50 && height < size[1] + 150);
    assert.ok(new Set(ids).size > 50, 'it has colors');
  });
});

test('at a frame without a query, a PNG has the colors of the bodies and no scale', async () => {
  await onPage(page_of('cone', '--frames', '100', '--queries', '90:110:10'), {}, async (page) => {
    await page.getByLabel('Frame', { exact: true }).fill('98');
    await press(page, '3');
    const of_pairs = await saved_png(page);
    await press(page, '4');
    assert.equal((await saved_png(page)).height, of_pairs.height);
  });
});

test('volumes are saved as GLB, which scb reads', async () => {
  await onPage(page_of('cone', '--volume', 'scb2', '--level', '3'), {}, async (page) => {
    await unfold(page);
    const saved = async () => {
      const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'GLB' }).click()]);
      const file = join(folder, 'saved.glb');
      await download.saveAs(file);
      const bytes = readFileSync(file);
      return JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)));
    };
    const all = await saved();
    assert.equal(all.meshes.length, 16, 'eight volumes of each body');
    assert.equal(JSON.parse(scb('stats', join(folder, 'saved.glb'), '--json')).hierarchies.length, 1);
    await press(page, '/');
    await page.keyboard.type('B:5');
    await page.keyboard.press('Enter');
    await settled(page);
    assert.deepEqual((await saved()).meshes.map(({ name }) => name), ['B 5']);
  });
});

test('the commands of all modes work', async () => {
  await onPage(page_of('cone', '--frames', '100'), {}, async (page) => {
    const commands = new Set();
    for (const key of ['1', '2', '3', '4', '5', '6', '7']) {
      await press(page, key);
      for (const command of await page.evaluate(() => document.getElementById('canvas').app.commands())) commands.add(command);
    }
    await press(page, '2', 'k', 'o', 't');
    for (const command of await page.evaluate(() => document.getElementById('canvas').app.commands())) commands.add(command);
    assert.equal(commands.size, 8);
    for (const command of commands) {
      const words = command.split(' ').slice(1), out = join(folder, 'commands');
      words[words.length - 1] = out;
      assert.equal(spawnSync(process.env.SCB, ['--quiet', ...words, '--size', '320x240'], { stdio: 'inherit' }).status, 0, command);
    }
  });
});

test('it turns by dragging, moves, zooms, and follows its size', async () => {
  await onPage(page_of('cone', '--level', '4'), {}, async (page) => {
    const box = await page.locator('#canvas').boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
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
    assert.notEqual(moved.target, turned.target);
    await page.mouse.wheel(0, 300);
    await page.waitForFunction((distance) => {
      document.getElementById('canvas').app.address.writeNow();
      return new URLSearchParams(location.hash.slice(1)).get('distance') > distance;
    }, Number(moved.distance));
    await page.setViewportSize({ width: 700, height: 500 });
    await page.waitForFunction((before) => {
      const { width, clientWidth } = document.getElementById('canvas');
      return width === clientWidth && width !== before;
    }, box.width);
    // It is drawn in the new size, too: a corner has the color of the background.
    const corner = await page.evaluate(() => {
      const { app } = document.getElementById('canvas'), { gl } = app.painter, pixel = new Uint8Array(4);
      app.draw();
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.readPixels(2, 2, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return [...pixel];
    });
    assert.deepEqual(corner, [255, 255, 255, 255]);
  });
});

test('the modes are tabs in a row, and what is folded stays folded', async () => {
  await onPage(page_of('cone', '--frames', '100'), {}, async (page) => {
    const tab = (name) => page.getByRole('tab', { name }), chosen = () => page.locator('[role=tab][aria-selected=true]').allInnerTexts();
    assert.equal(new Set(await page.getByRole('tab').evaluateAll((tabs) => tabs.map((one) => one.offsetTop))).size, 1, 'in one row');
    await tab('Levels').focus();
    for (const [key, name] of [['ArrowRight', 'Rejections'], ['Home', 'Levels'], ['ArrowLeft', 'Verdicts'], ['ArrowRight', 'Levels'], ['End', 'Verdicts']]) {
      await page.keyboard.press(key);
      await settled(page);
      assert.deepEqual([(await state(page)).mode, await chosen(), await page.evaluate(() => document.activeElement.textContent)], [name.toLowerCase(), [name], name]);
    }
    assert.equal(await page.locator('[role=tab][tabindex="0"]').count(), 1, 'Tab leads to one of them');
    // What cost the most is above, tools are below and folded.
    const titles = await page.locator('.section:visible > summary').allInnerTexts();
    assert.deepEqual([...titles.slice(0, 2), ...titles.slice(-2)], ['Frame', 'What cost the most', 'Look, and save', 'The same without a browser']);
    assert.ok(!(await page.getByRole('button', { name: 'PNG' }).isVisible()));
    const counts = page.getByText('wasted share');
    assert.ok(await counts.isVisible());
    await page.getByText('Counts of the frame').click();
    await page.getByText('Look, and save').click();
    await press(page, '2');
    assert.ok(!(await counts.isVisible()), 'folded in another mode too');
    await page.reload();
    await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
    assert.ok(!(await counts.isVisible()), 'folded after it is loaded again');
    assert.ok(await page.getByRole('button', { name: 'PNG' }).isVisible());
  });
});

test('it fits a phone, and is touched', async () => {
  await onPage(page_of('spheres-l1', '--level', '5'), { viewport: { width: 400, height: 800 }, hasTouch: true, deviceScaleFactor: 2 }, async (page) => {
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), 'nothing sticks out');
    const box = await page.locator('#canvas').boundingBox();
    assert.ok(box.height > 250);
    await page.touchscreen.tap(box.x + box.width * 0.3, box.y + box.height / 2);
    await settled(page);
    assert.match(await page.locator('#panel').innerText(), /depth\s+5/);
    await shot(page, 'phone');
    await page.getByRole('tab', { name: 'Verdicts' }).tap();
    await settled(page);
    assert.equal((await state(page)).mode, 'verdicts');
  });
});

test('without script, or without WebGL2, the still picture is shown', async () => {
  await onPage(page_of('cone', '--level', '4'), { javaScriptEnabled: false }, async (page) => {
    assert.ok(await page.locator('#instead img').isVisible());
    assert.ok(await page.locator('#instead p').isVisible());
    assert.ok(!(await page.locator('#loading').isVisible()));
    await shot(page, 'still');
  });
  const context = await browser.newContext({ viewport: { width: 900, height: 600 } }), page = await context.newPage();
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto(pathToFileURL(page_of('cone', '--level', '4')).href);
  await page.waitForFunction(() => document.querySelector('#instead p').textContent.includes('no WebGL2'));
  assert.ok(await page.locator('#instead img').isVisible());
  assert.ok(!(await page.locator('#loading').isVisible()));
  await context.close();
});

test('it says that it loads, until the scene is drawn', async () => {
  const context = await browser.newContext({ viewport: { width: 900, height: 600 } }), page = await context.newPage();
  await page.addInitScript(() => {
    const { arrayBuffer } = Response.prototype, held = new Promise((go) => Object.assign(window, { go }));
    Response.prototype.arrayBuffer = async function () {
      await held;
      return arrayBuffer.call(this);
    };
  });
  await page.goto(pathToFileURL(page_of('cone', '--level', '4')).href);
  const loading = page.getByText('Loading', { exact: true });
  assert.ok(await loading.isVisible());
  assert.ok(!(await page.locator('#instead').isVisible()), 'nothing says that the browser cannot draw');
  await shot(page, 'loading');
  await page.evaluate(() => window.go());
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
  assert.ok(!(await loading.isVisible()));
  assert.ok(await page.locator('#canvas').isVisible());
  await context.close();
});

test('it is dark from the start where the reader prefers that, unless the button or --background says otherwise', async () => {
  const background = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor), dark = 'rgb(22, 25, 30)', light = 'rgb(255, 255, 255)';
  for (const [options, colorScheme, expected] of [[[], 'dark', dark], [['--background', 'light'], 'dark', light], [['--background', 'dark'], 'light', dark]]) {
    const file = page_of('cone', '--level', '4', ...options);
    // What is painted before the script has started.
    await onPage(file, { colorScheme, javaScriptEnabled: false }, async (page) => assert.equal(await background(page), expected));
    await onPage(file, { colorScheme }, async (page) => {
      assert.equal(await background(page), expected);
      await press(page, 't');
      assert.equal(await background(page), expected === dark ? light : dark);
    });
  }
});

test('names from files are text', async () => {
  const name = '<img src=x onerror=alert(1)>', mesh = join(folder, 'plain.off');
  writeFileSync(mesh, 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n');
  const scene = join(folder, 'hostile.json'), body = { model: 'm' };
  writeFileSync(scene, JSON.stringify({ scb_scene: 1, name: 'hostile', models: [{ name: 'm', file: 'plain.off' }], bodies: [{ name, ...body }, { name: 'B', ...body }] }));
  const file = page_of(scene, '--level', '1');
  await onPage(file, {}, async (page) => {
    assert.equal(await page.locator('#panel img').count(), 0);
    assert.ok((await page.locator('#panel').innerText()).includes(name));
  });
});

test('a page of a distance has no pairs within one', () => {
  const { status, stderr } = spawnSync(process.env.SCB, ['view', 'cone', '--kind', 'distance', '--within', '1', '-o', join(folder, 'none.html')], { encoding: 'utf8' });
  assert.equal(status, 2);
  assert.match(stderr, /--within: .* `scb render distance --within T`/);
});

test('a distance: its line with its number, its tests by bound, and each test with its volumes', async () => {
  // An order in which parents are not those that a depth-first search has.
  const query = ['spheres-l1', '--frames', '0', '--order', 'nearest'], told = JSON.parse(scb('distance', ...query, '--json')).frames[0];
  await onPage(page_of(...query, '--kind', 'distance'), {}, async (page) => {
    await settled(page);
    const found = await page.evaluate(() => {
      const { app } = document.getElementById('canvas'), { frame, contacts } = app.scenes[0], { query } = frame;
      return {
        ...frame.stored, triangles: [...frame.pairs], line: contacts[0].line, parents: [...frame.parents], bounds: [...frame.bounds], worths: [...frame.worths],
        divided: [...frame.outcomes].map((outcome) => outcome < 2), left_out: [...frame.outcomes].map((outcome) => query.rejects(outcome) && query.stored.groups[outcome - 2].label !== 'not needed any more'),
        depths: [...frame.a].map((slot, i) => query.trees[0].levelOf(slot) + query.trees[1].levelOf(frame.b[i])), commands: app.commands(),
      };
    });
    assert.deepEqual([found.distance, found.triangles, found.n_v, found.n_p], [told.distance, told.triangles, told.n_v, told.n_p]);
    const [p, q] = [found.line.slice(0, 3), found.line.slice(3)];
    assert.ok(Math.abs(Math.hypot(...p.map((x, i) => x - q[i])) - told.distance) < 1e-9, 'the line is as long as the distance');
    assert.match(found.commands[0], /^scb render distance spheres-l1 /);
    // Each test is a level below its parent, and what was left out is not nearer than the answer.
    assert.equal(found.parents.filter((parent) => parent < 0).length, 1);
    found.parents.forEach((parent, i) => assert.ok(parent < i && (parent < 0 || found.depths[i] === found.depths[parent] + 1), `test ${i}`));
    found.left_out.forEach((is, i) => assert.ok(!is || found.bounds[i] > 0.999999 * told.distance, `bound ${i}`));
    // What led to the answer has a small bound, and so have its parents.
    const led = found.divided.map((is, i) => is && found.worths[i] === 0);
    assert.ok(led.some((is) => is) && found.divided.some((is, i) => is && !led[i]), 'some were divided in vain');
    led.forEach((is, i) => assert.ok(!is || (found.bounds[i] < told.distance && (found.parents[i] < 0 || led[found.parents[i]])), `test ${i}`));
    assert.equal(found.wasted, found.parents.filter((parent) => parent >= 0 && found.divided[parent] && !led[parent]).length);
    assert.equal(Number(await page.locator('#labels .dimension').textContent()), Number(told.distance.toPrecision(5)));
    assert.equal(await page.getByRole('tab', { selected: true }).textContent(), 'Distance');
    // The line is seen in its length, at first and when one goes there.
    const share = () => page.evaluate(() => {
      const { app } = document.getElementById('canvas'), { line } = app.scenes[0].contacts[0], [p, q] = [line.slice(0, 3), line.slice(3)].map(app.projection(0));
      return Math.hypot(p[0] - q[0], p[1] - q[1]) / app.rectangles[0][3];
    });
    const first = await share();
    assert.ok(first > 0.15 && first < 0.6, `${first} of the height`);
    await shot(page, 'distance');
    await press(page, 'f');
    await settled(page);
    assert.ok((await share()) < 0.1);
    await page.getByRole('button', { name: 'Go to it' }).first().click();
    await settled(page);
    assert.ok(Math.abs((await share()) - first) < 0.02 * first);
    // The list leads to the test, whose volumes the scene shows.
    await unfold(page);
    await page.locator('.bounds button').first().click();
    await settled(page);
    const shown = await state(page), nearest = found.bounds.map((bound, i) => [Math.abs(bound - told.distance), i]).filter(([, i]) => found.left_out[i]).sort(([x], [y]) => x - y)[0][1];
    assert.equal(shown.mode, 'traversal');
    assert.ok(Math.abs(found.bounds[shown.test] - told.distance) <= Math.abs(found.bounds[nearest] - told.distance));
    assert.deepEqual(await page.evaluate(() => document.getElementById('canvas').app.scenes[0].nodes.map(({ side }) => side)), [0, 1]);
    await page.getByRole('cell', { name: /% of the distance/ }).waitFor();
    await shot(page, 'distance-traversal');
  });
});
