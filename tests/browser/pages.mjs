// Pages of `scb view`, and what a test asks of them in whichever browser: by `evaluate`, and by events of the same names.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { inflateSync } from 'node:zlib';

export const folder = process.env.PAGE_FOLDER;
const screenshots = process.env.SCREENSHOTS;
export const scb = (...words) => execFileSync(process.env.SCB, ['--quiet', ...words], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });
// The sandbox needs rights that containers often lack; the page is our own.
export const chromium_arguments = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];

const made = new Map();
// The page that the options give; each is made once.
export function page_of(...options) {
  const key = options.join(' ');
  if (!made.has(key)) {
    made.set(key, join(folder, `page-${made.size}.html`));
    scb('view', ...options, '-o', made.get(key));
  }
  return made.get(key);
}

// A list of the problems of a page: any request except the file itself and data, any error, any message of the console,
// any dialog.
export function watched(page, main) {
  const wrong = [];
  page.on('request', (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(main)) wrong.push(`request: ${request.url()}`);
  });
  page.on('pageerror', (error) => wrong.push(`error: ${error.message}`));
  page.on('console', (message) => {
    // Warnings about software rendering are no fault of the page.
    if (!/GPU stall due to ReadPixels|software WebGL/i.test(message.text())) wrong.push(`console: ${message.text()}`);
  });
  page.on('dialog', (dialog) => {
    wrong.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  return wrong;
}

export const settled = (page) => page.evaluate(() => document.getElementById('canvas').app.refresh().then(() => {
  document.getElementById('canvas').app.address.writeNow();
  return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
}));
export const state = (page) => page.evaluate(() => ({ ...document.getElementById('canvas').app.state }));
export const address = (page) => page.evaluate(() => Object.fromEntries(new URLSearchParams(location.hash.slice(1))));
export async function shot(page, name) {
  if (screenshots) await page.screenshot({ path: join(screenshots, `view-${name}.png`) });
}
// What the canvas shows: its pixels as text.
export const seen = (page) => page.evaluate(() => {
  const { app } = document.getElementById('canvas');
  app.draw();
  const { gl } = app.painter, [width, height] = app.painter.size, pixels = new Uint8Array(4 * width * height);
  gl.bindFramebuffer(gl.FRAMEBUFFER, app.painter.target);
  gl.readBuffer(gl.COLOR_ATTACHMENT0);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let text = '';
  for (let i = 0; i < pixels.length; i += 4 * 97) text += String.fromCharCode(32 + (pixels[i] >> 2), 32 + (pixels[i + 1] >> 2));
  return text;
});
export const share_of_differences = (a, b) => [...a].filter((c, i) => c !== b[i]).length / Math.max(a.length, b.length);

// The four bytes of each pixel of a PNG file without interlacing, of 8 bits a channel.
export function read_png(path) {
  const bytes = readFileSync(path), width = bytes.readUInt32BE(16), height = bytes.readUInt32BE(20), channels = bytes[25] === 6 ? 4 : 3;
  const parts = [];
  for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at))
    if (bytes.toString('latin1', at + 4, at + 8) === 'IDAT') parts.push(bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at)));
  const lines = inflateSync(Buffer.concat(parts)), pixels = new Uint8Array(4 * width * height), row = channels * width;
  const above = (x, y, i) => (y > 0 && x >= 0 ? pixels[4 * ((y - 1) * width + x) + i] : 0);
  for (let y = 0, at = 0; y < height; ++y) {
    const filter = lines[at++];
    for (let k = 0; k < row; ++k) {
      const x = Math.floor(k / channels), i = k % channels, a = x > 0 ? pixels[4 * (y * width + x - 1) + i] : 0, b = above(x, y, i), c = above(x - 1, y, i), p = a + b - c;
      const paeth = Math.abs(p - a) <= Math.abs(p - b) && Math.abs(p - a) <= Math.abs(p - c) ? a : Math.abs(p - b) <= Math.abs(p - c) ? b : c;
      pixels[4 * (y * width + x) + i] = lines[at++] + [0, a, b, (a + b) >> 1, paeth][filter];
    }
  }
  return { width, height, ids: Array.from({ length: width * height }, (_, i) => (pixels[4 * i] | (pixels[4 * i + 1] << 8) | (pixels[4 * i + 2] << 16)) >>> 0) };
}

// The id at every pixel of the page's canvas, which gets the size for good, one target pixel per pixel.
export async function ids_of(page, size) {
  // As text, which drivers hand over faster than a list.
  const text = await page.evaluate(([width, height]) => {
    const canvas = document.getElementById('canvas'), { app } = canvas;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    app.view.aspect = 0;
    app.painter.resize(width, height, 1);
    const resize = app.painter.resize.bind(app.painter);
    app.painter.resize = () => resize(width, height, 1);
    app.draw();
    const { gl } = app.painter, all = new Uint32Array(width * height);
    app.painter.idAt(0, 0);  // binds the ids
    gl.readPixels(0, 0, width, height, gl.RED_INTEGER, gl.UNSIGNED_INT, all);
    // The uppermost three bits are no part of an id.
    const ids = Array.from({ length: width * height }, (_, i) => all[(height - 1 - Math.floor(i / width)) * width + (i % width)] & 0x1fffffff);
    for (let i = 0; i < ids.length; i += 997)
      if (app.painter.idAt(i % width, Math.floor(i / width)) !== ids[i]) throw new Error(`pixel ${i}`);
    return ids.join(' ');
  }, size);
  return text.split(' ').map(Number);
}

// That all but a share of the pixels are of the same node in both.
export function assert_same_ids(ids, others, share) {
  assert.equal(ids.length, others.length);
  const covered = others.filter((id) => id > 0).length, differ = ids.filter((id, i) => id !== others[i]).length;
  assert.ok(covered > 0.03 * ids.length, `something is shown: ${covered} pixels`);
  assert.ok(differ <= share * ids.length, `${differ} of ${ids.length} pixels are of other nodes`);
}

// Every pixel's node, in the page and in the picture's id buffer, by the same camera.
export async function assert_ids_of_picture(onPage, scene, level, ...options) {
  const camera = ['--camera', 'orbit:30,20,4', '--frames', '0'], size = [320, 240];
  const out = join(folder, `ids-${scene}${options.join('')}`);
  mkdirSync(out);
  scb('render', 'levels', scene, ...options, ...camera, '--levels', String(level), '--size', size.join('x'), '--no-panel', '--samples', '1', '--ids', '-o', out);
  const picture = read_png(join(out, readdirSync(out).find((name) => /ids.*\.png$/.test(name))));
  await onPage(page_of(scene, ...options, ...camera, '--level', String(level)), { width: 480, height: 360 }, async (page) => assert_same_ids(await ids_of(page, size), picture.ids, 0.001));
}
