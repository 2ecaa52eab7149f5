// The meshes that the page of `scb view` makes of volumes, and the files of them. Needs no browser.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { glbOf } from '../../render/web/glb.js';
import { add, cross, dot, length, scaled, subtract, times, unit } from '../../render/web/linear.js';
import { solidOf } from '../../render/web/solids.js';
import { Tree, shapeNames } from '../../render/web/tree.js';

const floats = (...numbers) => Float32Array.from(numbers.flat(2));
const solid = (name, numbers, extras = []) => solidOf(shapeNames.indexOf(name), floats(...numbers), floats(...extras));
const pointsOf = ({ positions }) => Array.from({ length: positions.length / 3 }, (_, i) => positions.slice(3 * i, 3 * i + 3));
function trianglesOf(mesh) {
  const points = pointsOf(mesh);
  return Array.from({ length: mesh.indices.length / 3 }, (_, i) => mesh.indices.slice(3 * i, 3 * i + 3).map((k) => points[k]));
}
// About a point near it, so that nothing is lost far from the origin.
function volumeOf(mesh) {
  const triangles = trianglesOf(mesh), o = triangles[0]?.[0];
  return triangles.reduce((sum, [a, b, c]) => sum + dot(subtract(a, o), cross(subtract(b, o), subtract(c, o))) / 6, 0);
}
const areaOf = (triangles) => triangles.reduce((sum, [a, b, c]) => sum + length(cross(subtract(b, a), subtract(c, a))) / 2, 0);

function assertClosed({ indices }) {
  const edges = new Map(), key = (a, b) => `${a} ${b}`;
  for (let t = 0; t < indices.length; t += 3)
    for (let k = 0; k < 3; ++k) {
      const a = indices[t + k], b = indices[t + ((k + 1) % 3)];
      assert.notEqual(a, b);
      assert.ok(!edges.has(key(a, b)), `the edge ${a} ${b} is there twice`);
      edges.set(key(a, b), [a, b]);
    }
  for (const [a, b] of edges.values()) assert.ok(edges.has(key(b, a)), `the edge ${a} ${b} has one triangle`);
}

// `beyond`: how far outside a point is.
function assertSolid(mesh, { volume, size, beyond, what = '' }) {
  assertClosed(mesh);
  assert.ok(mesh.positions.every(Number.isFinite), what);
  for (const p of pointsOf(mesh)) assert.ok(beyond(p) <= 1e-6 * size, `${what}: ${p} is ${beyond(p)} outside`);
  for (const [a, b, c] of trianglesOf(mesh)) for (const [p, q] of [[a, b], [b, c], [c, a]]) assert.ok(length(subtract(p, q)) > 5e-7 * size, `${what}: two corners at ${p}`);
  assert.ok(Math.abs(volumeOf(mesh) - volume) <= 0.01 * volume + 1e-5 * size ** 3, `${what}: ${volumeOf(mesh)} for ${volume}`);
}

let state = 42;
const random = () => (state = (1103515245 * state + 12345) % 2 ** 31) / 2 ** 31;
const between = (a, b) => a + (b - a) * random();
function randomUnit() {
  for (;;) {
    const v = [between(-1, 1), between(-1, 1), between(-1, 1)];
    if (length(v) > 0.1 && length(v) < 1) return unit(v);
  }
}
function randomFrame() {
  const n = randomUnit(), u = unit(cross(n, randomUnit()));
  return [n, u, cross(n, u)];
}
const somewhere = () => [between(-5, 5), between(-5, 5), between(-5, 5)];
// Numbers as the page has them.
const rounded = (numbers) => numbers.flat().map(Math.fround);

// What the plane at a height leaves of a disc or ball below it.
const segmentArea = (r, h) => (h >= r ? Math.PI * r * r : h <= -r ? 0 : r * r * (Math.PI / 2 + Math.asin(h / r)) + h * Math.sqrt(r * r - h * h));
const belowPlane = (r, h) => Math.PI * (r * r * h - (h * h * h) / 3 + (2 * r * r * r) / 3);
function integral(from, to, f, steps = 2000) {
  let sum = 0;
  for (let i = 0; i < steps; ++i) sum += f(from + ((i + 0.5) * (to - from)) / steps);
  return (sum * (to - from)) / steps;
}
const beyondSlabs = (c, r, slabs) => (p) => Math.max(length(subtract(p, c)) - r, ...slabs.flatMap(({ n, e, f }) => [dot(n, subtract(p, c)) - e, f - dot(n, subtract(p, c))]));

function checkScb(c, r, n, e, f) {
  [c, n, [r, e, f]] = [c, n, [r, e, f]].map(rounded);
  const mesh = solid('scb', [c, r, n, e, f]), what = `scb ${[c, r, n, e, f]}`;
  assertSolid(mesh, { volume: belowPlane(r, Math.min(e, r)) - belowPlane(r, Math.max(f, -r)), size: r, beyond: beyondSlabs(c, r, [{ n, e, f }]), what });
  // The flat sides are there wholly, so the rims are on the sphere.
  for (const k of [e, f]) {
    if (Math.abs(k) >= r || e - f < 1e-5 * r) continue;
    const side = trianglesOf(mesh).filter((t) => t.every((p) => Math.abs(dot(n, subtract(p, c)) - k) < 2e-6 * r));
    const disc = Math.PI * (r * r - k * k);
    assert.ok(Math.abs(areaOf(side) - disc) < 0.01 * disc + 1e-6 * r * r, `${what}: side ${areaOf(side)} for ${disc}`);
  }
  return mesh;
}

test('slab cut balls', () => {
  const ball = checkScb([1, 2, 3], 2, [0, 0, 1], 2, -2);
  assert.ok(ball.indices.length / 3 >= 500);
  for (let i = 0; i < 60; ++i) {
    const r = 10 ** between(-4, 4), heights = [between(-r, r), between(-r, r)].sort((a, b) => a - b);
    checkScb(scaled(r, somewhere()), r, randomUnit(), heights[1], heights[0]);
    checkScb(somewhere(), 1, randomUnit(), 1, between(-1, 0.999));
    checkScb(somewhere(), 1, randomUnit(), between(-0.999, 1), -1);
    checkScb(somewhere(), 1, randomUnit(), between(0, 0.01), between(-0.01, 0));
  }
  checkScb([0, 0, 0], 1, [1, 0, 0], 5, -5);
  checkScb([0, 0, 0], 1, [1, 0, 0], 0.5 + 4e-7, 0.5);
});

test('slab cut balls without thickness are discs, and others are nothing', () => {
  for (const height of [0, 0.5, -0.9]) {
    const disc = checkScb([1, 2, 3], 2, randomUnit(), height, height), area = 2 * Math.PI * (4 - height * height);
    assert.ok(Math.abs(areaOf(trianglesOf(disc)) - area) < 0.01 * area);
  }
  for (const [r, e, f] of [[0, 0, 0], [1, 1, 1], [1, -1, -1], [1, 3, 2], [1, -2, -3], [NaN, NaN, NaN]])
    assert.deepEqual(solid('scb', [0, 0, 0, r, 0, 0, 1, e, f]).indices, [], `${[r, e, f]}`);
});

function checkScb2(c, r, n, e, f, m, e2, f2) {
  [c, n, m, [r, e, f, e2, f2]] = [c, n, m, [r, e, f, e2, f2]].map(rounded);
  const mesh = solid('scb2', [c, r, n, e, m, e2, f, f2]), what = `scb2 ${[c, r, n, e, f, m, e2, f2]}`;
  const slice = (x) => segmentArea(Math.sqrt(r * r - x * x), e2) - segmentArea(Math.sqrt(r * r - x * x), f2);
  assertSolid(mesh, { volume: integral(f, e, slice), size: r, beyond: beyondSlabs(c, r, [{ n, e, f }, { n: m, e: e2, f: f2 }]), what });
  for (const k of [e, f]) {
    if (Math.abs(k) >= r || e - f < 1e-4 * r) continue;
    const side = trianglesOf(mesh).filter((t) => t.every((p) => Math.abs(dot(n, subtract(p, c)) - k) < 2e-6 * r));
    assert.ok(Math.abs(areaOf(side) - slice(k)) < 0.03 * slice(k) + 1e-3 * r * r, `${what}: side ${areaOf(side)} for ${slice(k)}`);
  }
  // The edges reach the sphere.
  for (const k of [e, f])
    for (const l of [e2, f2]) {
      const end = add(c, add(add(scaled(k, n), scaled(l, m)), scaled(Math.sqrt(r * r - k * k - l * l), unit(cross(n, m)))));
      if (k * k + l * l < 0.999 * r * r && e - f > 1e-4 * r && e2 - f2 > 1e-4 * r) assert.ok(pointsOf(mesh).some((p) => length(subtract(p, end)) < 2e-5 * r), what);
    }
  return mesh;
}

test('balls cut by two slabs', () => {
  for (let i = 0; i < 25; ++i) {
    const [n, m] = randomFrame(), r = 10 ** between(-4, 4);
    checkScb2(scaled(r, somewhere()), r, n, between(0, r), between(-r, 0), m, between(0, r), between(-r, 0));
    checkScb2(somewhere(), 1, n, between(0, 0.3), between(-0.3, 0), m, between(0, 1), between(-1, 0));
    checkScb2(somewhere(), 1, n, between(0, 0.01), between(-0.01, 0), m, 1, -1);
    checkScb2(somewhere(), 1, n, 2e-6, 0, m, 10 ** between(-6, 0), -(10 ** between(-6, 0)));
    checkScb2(somewhere(), 1, n, 0, -between(0.01, 1), m, between(0.01, 1), 0);
    checkScb2(somewhere(), 1, n, 1, -between(0.9, 1), m, between(0.9, 1), -1);
  }
  const ball = checkScb2([1, 2, 3], 2, [0, 0, 1], 2, -2, [1, 0, 0], 2, -2);
  assert.ok(ball.indices.length / 3 >= 500);
  // One side is a few rounding errors from the center.
  checkScb2([0, 0, 0], 1, [0, 0, 1], 5e-4, -7e-6, [1, 0, 0], 1, -1);
  // All edges, and all rims, at one point.
  checkScb2([0, 0, 0], 5, [0, 0, 1], 3, -3, [1, 0, 0], 4, -4);
});

test('flat balls of two slabs are seen from both sides', () => {
  const [n, m] = randomFrame(), area = (e, f) => 2 * (segmentArea(2, e) - segmentArea(2, f));
  for (const [e, f] of [[2, -2], [0.5, -1], [0, -2], [1.5, 0]])
    for (const slabs of [[0, 0, m, e, f], [1e-7, 0, m, e, f], [e, f, m, 0, 0]]) {
      const mesh = solid('scb2', [[1, 2, 3], 2, n, slabs[0], m, slabs[3], slabs[1], slabs[4]]);
      assertClosed(mesh);
      assert.ok(Math.abs(areaOf(trianglesOf(mesh)) - area(e, f)) < 0.01 * area(e, f), `${[e, f]}: ${areaOf(trianglesOf(mesh))} for ${area(e, f)}`);
    }
  assert.deepEqual(solid('scb2', [0, 0, 0, 2, n, 0, m, 0, 0, 0]).indices, []);
  assert.deepEqual(solid('scb2', [0, 0, 0, 0, n, 0, m, 0, 0, 0]).indices, []);
});

test('boxes', () => {
  for (let i = 0; i < 100; ++i) {
    const scale = 10 ** between(-4, 4), c = scaled(scale, somewhere()), axes = randomFrame(), half = [between(0.1, 1), between(0.1, 1), 10 ** between(-4, 0)].map((x) => x * scale);
    const mesh = solid('box', [c, half[0], axes[0], half[1], axes[1], half[2]]), from = rounded(c);
    assertSolid(mesh, { volume: 8 * half[0] * half[1] * half[2], size: length(half), beyond: (p) => Math.max(...axes.map((axis, k) => Math.abs(dot(axis, subtract(p, from))) - half[k])) });
    assert.equal(mesh.indices.length, 36);
  }
  const flat = (...half) => solid('box', [[1, 2, 3], half[0], [0.6, 0, 0.8], half[1], [0.8, 0, -0.6], half[2]]);
  for (const half of [[0, 2, 3], [2, 0, 3], [2, 3, 0]]) {
    assertClosed(flat(...half));
    assert.ok(Math.abs(areaOf(trianglesOf(flat(...half))) - 8 * half.reduce((p, x) => p * (x || 1), 1)) < 1e-4);
  }
  for (const half of [[0, 0, 3], [0, 0, 0]]) assert.deepEqual(flat(...half).indices, []);
});

// By points that are spread evenly (Halton's) over a box.
function sampledVolume(planes, low = [-1, -1, -1], high = [1, 1, 1]) {
  const digits = (i, base) => {
    let value = 0;
    for (let share = 1 / base; i > 0; i = Math.floor(i / base), share /= base) value += share * (i % base);
    return value;
  };
  const count = 60000, sides = subtract(high, low);
  let inside = 0;
  for (let i = 1; i <= count; ++i) {
    const p = [2, 3, 5].map((base, k) => low[k] + sides[k] * digits(i, base));
    if (planes.every(({ n, at }) => dot(n, p) <= at)) ++inside;
  }
  return (sides[0] * sides[1] * sides[2] * inside) / count;
}

function checkPolytope(planes, volume, reach, what) {
  const c = rounded(somewhere()), exact = planes.map(({ n, at }) => ({ n: rounded(n), at: Math.fround(at) }));
  const mesh = solid('polytope', [c, reach], exact.map(({ n, at }) => [n, at]));
  assertSolid(mesh, { volume, size: reach, beyond: (p) => Math.max(...exact.map(({ n, at }) => dot(n, subtract(p, c)) - at)), what });
  return mesh;
}
// All directions of these coordinates, with each sign and order.
function planesAlong(kinds) {
  const planes = [];
  for (const [pattern, at] of kinds) {
    const seen = new Set();
    for (const order of [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]])
      for (let signs = 0; signs < 8; ++signs) seen.add(order.map((k, i) => pattern[k] * ((signs >> i) & 1 ? 1 : -1) + 0).join());
    for (const text of seen) planes.push({ n: unit(text.split(',').map(Number)), at });
  }
  return planes;
}

test('polytopes', () => {
  const cube = planesAlong([[[0, 0, 1], 1]]), octahedron = planesAlong([[[1, 1, 1], 1 / Math.sqrt(3)]]);
  assert.equal(new Set(checkPolytope(cube, 8, 2, 'cube').indices).size, 8);
  // More than three faces at a corner.
  assert.equal(new Set(checkPolytope(octahedron, 4 / 3, 2, 'octahedron').indices).size, 6);
  assert.equal(new Set(checkPolytope(planesAlong([[[0, 1, 1], Math.SQRT2]]), 16, 3, 'rhombic dodecahedron').indices).size, 14);
  assert.equal(new Set(checkPolytope(planesAlong([[[0, 0, 1], 1], [[1, 1, 1], 2 / Math.sqrt(3)]]), 20 / 3, 2, 'cuboctahedron').indices).size, 12);
  // Planes that are there twice, that touch edges and corners, and that touch nothing.
  const touching = [...cube, ...planesAlong([[[0, 1, 1], Math.SQRT2], [[1, 1, 1], Math.sqrt(3)], [[0, 1, 2], 5]])];
  assert.equal(new Set(checkPolytope([...touching, ...touching], 8, 2, 'cube with more planes').indices).size, 8);
  for (let i = 0; i < 12; ++i) {
    const planes = [...cube, ...Array.from({ length: 2 + 8 * i }, () => ({ n: randomUnit(), at: between(0.5, 1.2) }))];
    checkPolytope(planes, sampledVolume(planes), 2, `${planes.length} random planes`);
  }
  // As k-DOPs: each plane touches some points.
  for (let i = 0; i < 30; ++i) {
    const points = Array.from({ length: 4 + i }, () => [between(-1, 1), between(-1, 1), between(-0.3, 0.3)]);
    const planes = planesAlong([[[0, 0, 1], 1], [[0, 1, 1], 1], [[1, 1, 1], 1]]).map(({ n }) => ({ n, at: Math.max(...points.map((p) => dot(n, p))) }));
    const [low, high] = [Math.min, Math.max].map((end) => [0, 1, 2].map((k) => end(...points.map((p) => p[k]))));
    checkPolytope(planes, sampledVolume(planes, low, high), 2, `26 planes about ${points.length} points`);
  }
});

test('flat polytopes', () => {
  const along = (...points) => planesAlong([[[0, 0, 1], 1], [[0, 1, 1], 1], [[1, 1, 1], 1]]).map(({ n }) => ({ n, at: Math.max(...points.map((p) => dot(n, p))) }));
  const triangle = checkPolytope(along([1, 0, 0], [-0.5, 1, 0], [-0.5, -1, 0]), 0, 2, 'triangle');
  assert.ok(areaOf(trianglesOf(triangle)) > 3);
  // Its planes' sides are hardly apart.
  checkPolytope(along([1, 0, 1e-8], [-0.5, 1, 0], [-0.5, -1, -1e-8]), 0, 2, 'thin');
  assert.deepEqual(checkPolytope(along([1, 0, 0], [-1, 0, 0]), 0, 1, 'segment').indices, []);
  assert.deepEqual(checkPolytope(along([0, 0, 0]), 0, 0, 'point').indices, []);
});

// `points` from the center. Its farthest point in many directions tells how far a point is outside.
const directions = Array.from({ length: 400 }, randomUnit);
function checkRounded(points, rounding, volume, what) {
  const c = rounded(somewhere()), exact = points.map(rounded), size = rounding + Math.max(...exact.map(length));
  const mesh = solid('rounded', [c, size, rounding], exact.map((p) => [p, 0])), support = directions.map((d) => rounding + Math.max(...exact.map((p) => dot(p, d))));
  assertSolid(mesh, { volume, size, beyond: (p) => Math.max(...directions.map((d, i) => dot(d, subtract(p, c)) - support[i])), what });
  return mesh;
}
const ballVolume = (r) => (4 / 3) * Math.PI * r ** 3;

test('balls, capsules and rounded rectangles', () => {
  assert.ok(checkRounded([[0, 0, 0]], 2, ballVolume(2), 'ball').indices.length / 3 >= 500);
  for (let i = 0; i < 8; ++i) {
    const r = 10 ** between(-2, 1), [n, u] = randomFrame(), [p, q] = [between(0.1, 1), between(0.1, 1)];
    checkRounded([scaled(p, n), scaled(-p, n)], r, ballVolume(r) + 2 * p * Math.PI * r * r, 'capsule');
    const corners = [[1, 1], [-1, 1], [1, -1], [-1, -1]].map(([x, y]) => add(scaled(x * p, n), scaled(y * q, u)));
    checkRounded(corners, r, ballVolume(r) + 2 * (p + q) * Math.PI * r * r + 8 * p * q * r, 'rectangle');
    // Some points of the middle change nothing.
    checkRounded([scaled(p, n), scaled(0.3 * p, n), scaled(-0.1 * p, n), scaled(-p, n)], r, ballVolume(r) + 2 * p * Math.PI * r * r, 'capsule of four points');
  }
});

test('rounded hulls', () => {
  for (let i = 0; i < 5; ++i) {
    const axes = randomFrame(), half = [between(0.1, 1), between(0.1, 1), between(0.1, 1)], [x, y, z] = half, r = between(0.02, 1);
    const box = Array.from({ length: 8 }, (_, k) => times(axes, half.map((h, axis) => ((k >> axis) & 1 ? h : -h))));
    const round = checkRounded(box, r, 8 * x * y * z + 8 * (x * y + y * z + z * x) * r + 2 * Math.PI * (x + y + z) * r * r + ballVolume(r), 'box');
    // Its faces are there wholly.
    const top = trianglesOf(round).filter(([a, b, c]) => dot(unit(cross(subtract(b, a), subtract(c, a))), axes[2]) > 1 - 1e-9);
    assert.ok(Math.abs(areaOf(top) - 4 * x * y) < 1e-3 * x * y);
    checkRounded(box, 0, 8 * x * y * z, 'sharp box');
    // A tetrahedron: each edge adds a part of a cylinder, by the angle between its faces' normals.
    const t = Array.from({ length: 4 }, () => scaled(between(0.5, 1), randomUnit()));
    let volume = Math.abs(dot(subtract(t[1], t[0]), cross(subtract(t[2], t[0]), subtract(t[3], t[0])))) / 6 + ballVolume(r);
    for (const [a, b, c, d] of [[0, 1, 2, 3], [0, 2, 1, 3], [0, 3, 1, 2], [1, 2, 0, 3], [1, 3, 0, 2], [2, 3, 0, 1]]) {
      const edge = unit(subtract(t[b], t[a])), away = (k) => unit(subtract(subtract(t[k], t[a]), scaled(dot(edge, subtract(t[k], t[a])), edge)));
      volume += (length(subtract(t[b], t[a])) * (Math.PI - Math.acos(dot(away(c), away(d)))) * r * r) / 2;
    }
    for (const [a, b, c] of [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]) volume += areaOf([[t[a], t[b], t[c]]]) * r;
    checkRounded(t, r, volume, 'tetrahedron');
  }
  const triangle = [[1, 0, 0], [-0.5, 1, 0], [-0.5, -1, 0]], round = 2 * Math.sqrt(1.5 ** 2 + 1) + 2;
  checkRounded(triangle, 0.3, ballVolume(0.3) + (round / 2) * Math.PI * 0.09 + 2 * 1.5 * 0.3, 'triangle');
  for (let i = 0; i < 20; ++i) {
    const points = Array.from({ length: 5 + 10 * i }, () => scaled(between(0.3, 1), randomUnit()));
    const mesh = solid('rounded', [[0, 0, 0], 1, 0], points.map((p) => [p, 0]));
    assertClosed(mesh);
    // All points are in it.
    for (const [a, b, c] of trianglesOf(mesh)) {
      const n = cross(subtract(b, a), subtract(c, a));
      for (const p of points) assert.ok(dot(unit(n), subtract(p, a)) < 1e-5, `${points.length} points`);
    }
  }
});

test('sharp hulls of few points, or in one plane or line, are what there is', () => {
  const flat = [[1, 1, 0], [-1, 1, 0], [1, -1, 0], [-1, -1, 0]];
  for (const [points, area] of [[flat, 8], [flat.slice(1), 4], [[...flat, [0, 0, 0], [0.2, 0.1, 0], [0, 1, 0]], 8], [[...flat, ...flat], 8]])
    assert.ok(Math.abs(areaOf(trianglesOf(checkRounded(points, 0, 0, `${points.length} points`))) - area) < 1e-5);
  for (const points of [[[0, 0, 0]], [[1, 2, 3], [1, 2, 3]], [[1, 0, 0], [-1, 0, 0]], [[1, 1, 1], [0.1, 0.1, 0.1], [0, 0, 0], [-1, -1, -1], [-0.5, -0.5, -0.5]]])
    assert.deepEqual(checkRounded(points, 0, 0, `${points.length} points`).indices, []);
  assert.deepEqual(solid('rounded', [0, 0, 0, 0, 0], []).indices, []);
  assert.deepEqual(solid('none', []).indices, []);
});

test('fewer corners to a circle', () => {
  const numbers = floats([1, 2, 3], 2, [0, 0.6, 0.8], 1.5, -1);
  const counts = [8, 16, 48].map((corners) => {
    const mesh = solidOf(1, numbers, floats(), corners);
    assertClosed(mesh);
    return mesh.indices.length;
  });
  assert.ok(counts[0] < counts[1] && counts[1] < counts[2]);
});

test('a tree tells the planes and points of its volumes', () => {
  const tree = new Tree(null, null, { counts: [1, 2] });
  // Two parts of levels; texels have where extras begin, counted over all of them.
  const part = (first, extras, begin) => {
    const texels = new Float32Array(16 * extras.length);
    let at = begin;
    extras.forEach((count, i) => texels.set(count ? [(at += count) - count, count] : [0, 0], 16 * i + 12));
    return { first, last: first + extras.length, texels, extrasEnd: at, extraTexels: Float32Array.from({ length: 4 * (at - begin) }, (_, i) => begin + Math.floor(i / 4)) };
  };
  tree.parts = [part(0, [2], 0), part(1, [0, 3], 2)];
  assert.deepEqual([0, 1, 2].map((slot) => [...tree.extrasOf(slot)].filter((_, i) => i % 4 === 0)), [[0, 1], [], [2, 3, 4]]);
});

// Chunks of a binary glTF file.
function parsed(file) {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength), word = (at) => view.getUint32(at, true);
  assert.deepEqual([word(0), word(4), word(8)], [0x46546c67, 2, file.length]);
  const size = word(12);
  assert.deepEqual([size % 4, word(16)], [0, 0x4e4f534a]);
  const json = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(file.subarray(20, 20 + size)));
  assert.deepEqual([word(20 + size) % 4, word(24 + size)], [0, 0x004e4942]);
  assert.equal(28 + size + word(20 + size), file.length);
  assert.equal(json.buffers[0].byteLength, word(20 + size));
  const data = file.slice(28 + size).buffer;
  const read = (index) => {
    const { bufferView, byteOffset, componentType, count, type } = json.accessors[index], { byteOffset: start = 0, byteLength } = json.bufferViews[bufferView];
    const Kind = { 5126: Float32Array, 5125: Uint32Array }[componentType], many = count * { VEC3: 3, SCALAR: 1 }[type];
    assert.ok(byteOffset + 4 * many <= byteLength && start + byteLength <= data.byteLength);
    return new Kind(data, start + byteOffset, many);
  };
  return { json, read };
}

const tilted = { rotation: [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]], translation: [3e7, -2e7, 1e7] };
function someMeshes() {
  const body = { color: [255, 10, 128], opacity: 1, pose: tilted, center: [1000, 2000, 3000] };
  return [
    { ...body, ...solid('scb', [[0.1, 0.2, 0.3], 0.01, [0, 0, 1], 0.004, -0.01]), name: 'A 412', id: 412, depth: 7 },
    { ...body, ...solid('box', [[0, 0, 0], 0, [1, 0, 0], 0, [0, 1, 0], 0]), name: 'a point', id: 1, depth: 7 },
    { ...body, ...solid('box', [[5, 0, 0], 1, [1, 0, 0], 2, [0, 1, 0], 3]), name: '"B" \\ \u00fc </script>\n', opacity: 0.4, id: 3, depth: 2 },
    { ...body, ...solid('box', [[9, 0, 0], 1, [1, 0, 0], 2, [0, 1, 0], 3]), name: 'C', color: Uint8Array.of(255, 10, 128), id: 4, depth: 2 },
  ];
}

test('a file has what it was made of', () => {
  const meshes = someMeshes(), { json, read } = parsed(glbOf(meshes, 'scene')), shown = meshes.filter((mesh) => mesh.indices.length > 0);
  assert.equal(json.asset.version, '2.0');
  assert.deepEqual(json.scenes[json.scene].nodes, [0]);
  assert.deepEqual(json.nodes[0].children, [1, 2, 3]);
  assert.deepEqual(json.nodes.slice(1).map(({ name, extras }) => [name, extras]), shown.map(({ name, id, depth }) => [name, { id, depth }]));
  json.nodes.slice(1).forEach((node, i) => {
    const { attributes, indices, material } = json.meshes[node.mesh].primitives[0], positions = read(attributes.POSITION), { min, max } = json.accessors[attributes.POSITION];
    assert.deepEqual([...read(indices)], [...shown[i].indices]);
    for (let k = 0; k < 3; ++k) {
      const along = positions.filter((_, at) => at % 3 === k);
      assert.deepEqual([min[k], max[k]], [Math.min(...along), Math.max(...along)]);
    }
    // Where it is in the world, from the root's origin: nothing is lost to 32 bits.
    const { center, pose } = shown[i], m = node.matrix, columns = [0, 4, 8].map((at) => m.slice(at, at + 3)), size = length(subtract(max, min));
    assert.deepEqual([m[3], m[7], m[11], m[15]], [0, 0, 0, 1]);
    pointsOf(shown[i]).forEach((p, at) => {
      const here = add(times(columns, [...positions.subarray(3 * at, 3 * at + 3)]), m.slice(12, 15)), there = subtract(times(pose.rotation, p), json.nodes[0].translation);
      const expected = add(there, add(times(pose.rotation, center), pose.translation));
      assert.ok(length(subtract(here, expected)) < 1e-6 * size + 2e-8, `${here} for ${expected}`);
    });
    assert.ok(length(m.slice(12, 15)) < 20);
    const { pbrMetallicRoughness: look, alphaMode, doubleSided } = json.materials[material], opacity = shown[i].opacity;
    assert.deepEqual([alphaMode, doubleSided, look.baseColorFactor[3]], [opacity < 1 ? 'BLEND' : 'OPAQUE', true, opacity]);
    [1, 0.00303527, 0.21586].forEach((c, k) => assert.ok(Math.abs(look.baseColorFactor[k] - c) < 1e-5));
  });
  assert.equal(json.materials.length, 2);
  assert.equal(glbOf(meshes.slice(1, 2), 'nothing'), null);
  assert.equal(glbOf([], 'nothing'), null);
});

test('other programs read the file', (t) => {
  const folder = mkdtempSync(join(tmpdir(), 'solids-')), file = join(folder, 'volumes.glb'), meshes = someMeshes();
  try {
    writeFileSync(file, glbOf(meshes, 'scene'));
    const triangles = meshes.reduce((sum, { indices }) => sum + indices.length / 3, 0);
    const assimp = spawnSync('assimp', ['info', file], { encoding: 'utf8' });
    if (assimp.error) t.diagnostic('assimp is not installed (package assimp-utils)');
    else {
      assert.equal(assimp.status, 0, assimp.stdout + assimp.stderr);
      assert.match(assimp.stdout, new RegExp(`Faces: +${triangles}\\b`));
      assert.match(assimp.stdout, /Meshes: +3\b/);
    }
    if (process.env.SCB) {
      const told = execFileSync(process.env.SCB, ['--quiet', 'stats', file], { encoding: 'utf8' });
      assert.ok(told.replaceAll(/[,\s](?=\d{3}\b)/g, '').includes(String(triangles)), told);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});
