import { add, subtract, scaled, dot, cross, length, unit, times, clamp } from './linear.js';
import { shapeNames } from './tree.js';

// Volumes as triangle meshes, { positions, indices }: closed, counterclockwise from outside, with all corners in or on the volume. What is flat is seen from both
// sides, and what has no area has no triangles.
const cornersOfCircle = 48;
const roundingShare = 1e-6;  // of a volume's size: shorter lengths are rounding errors of 32-bit numbers
/** @param {number[]} flat */
const triples = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => [...flat.slice(3 * i, 3 * i + 3)]);
/** @type {(p: Numbers, q: Numbers, least: number) => boolean} */
const isNear = (p, q, least) => length(subtract(p, q)) <= least;

// Belts of triangles between rings of equally many points, counterclockwise seen from the last ring; a ring of one point closes the mesh. Points that follow each other
// in one place are one corner.
/** @type {(rings: Vector[][], least: number) => Solid} */
function stacked(rings, least) {
  /** @type {number[]} */
  const positions = [];
  /** @type {number[]} */
  const indices = [];
  const count = Math.max(...rings.map((ring) => ring.length));
  const triangle = (/** @type {number} */ a, /** @type {number} */ b, /** @type {number} */ c) => {
    if (a !== b && b !== c && c !== a) indices.push(a, b, c);
  };
  /** @type {number[]} */
  let below = [];
  for (const ring of rings) {
    /** @type {number[]} */
    const row = [];
    let last = ring[0], at = -1;
    for (let i = 0; i < count; ++i) {
      const p = ring[i % ring.length];
      if (i > 0 && isNear(p, ring[0], least)) row.push(row[0]);
      else if (i > 0 && isNear(p, last, least)) row.push(at);
      else {
        at = positions.push(...p) / 3 - 1;
        last = p;
        row.push(at);
      }
    }
    row.forEach((corner, i) => {
      const before = (i || count) - 1;
      if (below.length === 0) return;
      triangle(below[before], below[i], corner);
      triangle(below[before], corner, row[before]);
    });
    below = row;
  }
  return { positions, indices };
}

// Two unit vectors that make a right-handed frame with n.
/** @param {Vector} n */
function across(n) {
  const size = n.map(Math.abs), least = size.indexOf(Math.min(...size)), u = unit(cross(n, [0, 1, 2].map((i) => (i === least ? 1 : 0))));
  return [u, cross(n, u)];
}

// Circles of latitude, among them the rims.
/** @type {(c: Vector, r: number, n: Vector, e: number, f: number, corners: number) => Solid} */
function slabCutBall(c, r, n, e, f, corners) {
  const top = Math.min(e, r), bottom = Math.max(f, -r), least = roundingShare * r, [u, v] = across(n);
  if (!(r > 0) || !(bottom - top <= least)) return { positions: [], indices: [] };
  const from = Math.asin(bottom / r), to = Math.asin(top / r), angle = to - from, widest = Math.PI / 2 - (from * to > 0 ? Math.min(Math.abs(from), Math.abs(to)) : 0);
  // Near a pole the steps are smaller, so that a small cap is round, too.
  const steps = top - bottom <= least ? 0 : Math.ceil(corners * angle * Math.max(1 / (2 * Math.PI), 1 / (6 * widest)) - roundingShare);
  const heights = Array.from({ length: steps + 1 }, (_, i) => (i === 0 ? bottom : i === steps ? top : r * Math.sin(from + (angle * i) / steps)));
  const at = (/** @type {number} */ height) => add(c, scaled(height, n));
  const rings = heights.map((height) => Array.from({ length: corners }, (_, k) => {
    const turn = (2 * Math.PI * k) / corners, radius = Math.sqrt((r - height) * (r + height));
    return add(at(height), add(scaled(radius * Math.cos(turn), u), scaled(radius * Math.sin(turn), v)));
  }));
  return stacked([[at(bottom)], ...rings, [at(heights[steps])]], least);
}

// An outline of four arcs, one in each quadrant: the k-th has its center, radius and angles in axes that are turned by k right angles.
/** @type {(corners: number, arcOf: (k: number) => number[], place: (x: number, y: number) => Vector) => Vector[]} */
function fourArcs(corners, arcOf, place) {
  return [0, 1, 2, 3].flatMap((k) => {
    const [x, y, radius, from, to] = arcOf(k), steps = corners / 4;
    return Array.from({ length: steps + 1 }, (_, i) => {
      const angle = from + ((to - from) * i) / steps;
      let p = [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
      for (let turn = 0; turn < k; ++turn) p = [-p[1], p[0]];
      return place(p[0], p[1]);
    });
  });
}

// Slices across both slabs: what is left of a disc is a rectangle with round corners, which holds the disc's center.
/** @type {(c: Vector, r: number, slabs: { n: Vector, e: number, f: number }[], corners: number) => Solid} */
function twiceCutBall(c, r, slabs, corners) {
  const least = roundingShare * r, close = 10 * roundingShare, [n, m] = slabs.map((slab) => slab.n), axis = unit(cross(n, m));
  const flat = slabs.map(({ e, f }) => e - f <= close * r);
  if (!(r > 0) || (flat[0] && flat[1])) return { positions: [], indices: [] };
  /** @type {(height: number) => (x: number, y: number) => Vector} */
  const place = (height) => (x, y) => add(c, add(scaled(height, axis), add(scaled(x, n), scaled(y, m))));
  // Latitudes at which rims end or meet, and steps between, which are smaller where a rim ends. Those that are close have the same corners.
  const cuts = slabs.map(({ e, f }) => [e * e, f * f]), squares = [...cuts.flat(), ...cuts[0].flatMap((a) => cuts[1].map((b) => a + b))];
  const turns = squares.filter((square) => square < r * r).map((square) => Math.acos(Math.sqrt(square) / r)), pole = Math.PI / 2;
  const angles = [0];
  for (const end of [...turns, pole].sort((a, b) => a - b)) {
    const start = angles[angles.length - 1], gap = end - start, steps = Math.ceil(corners * Math.max(gap / (2 * Math.PI), 0.14 * Math.cbrt(gap)) - roundingShare);
    if (gap > close) for (let i = 1; i <= steps; ++i) angles.push(start + gap * (end === pole ? i / steps : Math.sin((pole * i) / steps)));
  }
  const upper = angles.filter((angle) => pole - angle > close), inner = [...upper.slice(1).map((angle) => -angle).reverse(), ...upper];
  const bottom = place(-r)(0, 0), top = place(r)(0, 0);
  if (flat[0] || flat[1]) {
    // Up one side of the outline and down the other.
    const { e, f } = slabs[flat[0] ? 1 : 0], at = (/** @type {number} */ height, /** @type {number} */ x) => (flat[0] ? place(height)(0, x) : place(height)(x, 0)), middle = [at(0, (e + f) / 2)];
    const side = (/** @type {number} */ limit, /** @type {number} */ sign) => inner.map((angle) => at(r * Math.sin(angle), sign * Math.min(limit, r * Math.cos(angle))));
    return stacked([middle, [bottom, ...side(e, 1), top, ...side(-f, -1).reverse()], middle], least);
  }
  const limits = [slabs[0].e, slabs[1].e, -slabs[0].f, -slabs[1].f];
  const rings = inner.map((angle) => fourArcs(corners, (k) => {
    const radius = r * Math.cos(angle), [x, y] = [limits[k], limits[(k + 1) % 4]].map((limit) => Math.min(1, limit / radius)), from = Math.acos(x), to = Math.asin(y);
    return from < to ? [0, 0, radius, from, to] : [radius * x, radius * y, 0, 0, 0];
  }, place(r * Math.sin(angle))));
  return stacked([[bottom], ...rings, [top]], least);
}

// The convex hull, point after point, each time of the one that is farthest out (Barber, Dobkin and Huhdanpaa, "The Quickhull Algorithm for Convex Hulls"). Neighbors
// are found of points that are moved a little, by less than rounding errors: then no four are in one plane, and flat hulls are as the others.
/** @type {(points: Vector[], size: number) => Solid} */
function hullOf(points, size) {
  const least = roundingShare * size;
  /** @type {Vector[]} */
  const kept = [];
  for (const point of [...points].sort((a, b) => a[0] - b[0])) {
    let i = kept.length - 1;
    while (i >= 0 && point[0] - kept[i][0] <= least && !isNear(point, kept[i], least)) --i;
    if (i < 0 || point[0] - kept[i][0] > least) kept.push(point);
  }
  /** @type {Solid} */
  const mesh = { positions: kept.flat(), indices: [] };
  const count = kept.length;
  if (count < 3) return mesh;
  let seed = 1;
  const moved = kept.map((point) => point.map((x) => x + least * ((seed = (1664525 * seed + 1013904223) % 2 ** 32) / 2 ** 32 - 0.5)));
  /** @type {(numbers: number[], far: (i: number) => number) => number} */
  const farthest = (numbers, far) => numbers.reduce((best, i) => (far(i) > far(best) ? i : best));
  const all = kept.map((_, i) => i), a = 0, from_a = (/** @type {number} */ i) => subtract(moved[i], moved[a]), b = farthest(all, (i) => length(from_a(i)));
  const fromLine = (/** @type {number} */ i) => length(cross(unit(from_a(b)), from_a(i))), c = farthest(all, fromLine);
  if (fromLine(c) <= 2 * least) return mesh;
  /** @typedef {{ corners: number[], n: Vector, above: number[], gone: boolean }} Face */
  /** @type {Face[]} */
  const faces = [];
  /** @type {Map<number, Face>} */
  const behind = new Map();  // whose edge it is, from corner to corner
  const height = (/** @type {Face} */ { corners, n }, /** @type {number} */ i) => dot(n, subtract(moved[i], moved[corners[0]]));
  const face = (/** @type {number[]} */ ...corners) => {
    const [p, q, s] = corners.map((i) => moved[i]);
    /** @type {Face} */
    const made = { corners, n: cross(subtract(q, p), subtract(s, p)), above: [], gone: false };
    corners.forEach((i, k) => behind.set(count * i + corners[(k + 1) % 3], made));
    faces.push(made);
    return made;
  };
  const deal = (/** @type {number[]} */ numbers, /** @type {Face[]} */ among) => numbers.forEach((i) => among.find((f) => height(f, i) > 0)?.above.push(i));
  deal(all.filter((i) => i !== a && i !== b && i !== c), [face(a, b, c), face(c, b, a)]);
  for (const next of faces) {
    if (next.gone || next.above.length === 0) continue;
    const tip = farthest(next.above, (i) => height(next, i)), seen = [next];
    /** @type {number[][]} */
    const rim = [];
    next.gone = true;
    for (const { corners } of seen)
      corners.forEach((i, k) => {
        const j = corners[(k + 1) % 3], other = /** @type {Face} */ (behind.get(count * j + i));
        if (other.gone) return;
        if (height(other, tip) <= 0) return rim.push([i, j]);
        other.gone = true;
        seen.push(other);
      });
    deal(seen.flatMap((f) => f.above).filter((i) => i !== tip), rim.map(([i, j]) => face(i, j, tip)));
  }
  mesh.indices = faces.filter((f) => !f.gone).flatMap((f) => f.corners);
  return mesh;
}

// The corners of each face: of a square in its plane, what the other planes leave.
/** @type {(center: Vector, size: number, extras: Float32Array) => Vector[]} */
function polytopeCorners(center, size, extras) {
  const planes = Array.from({ length: extras.length / 4 }, (_, i) => ({ n: [...extras.subarray(4 * i, 4 * i + 3)], at: extras[4 * i + 3] }));
  const least = 0.1 * roundingShare * size;
  return planes.flatMap((own) => {
    const [u, v] = across(own.n);
    let face = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([x, y]) => add(scaled(own.at, own.n), scaled(2 * size, add(scaled(x, u), scaled(y, v)))));
    for (const { n, at } of planes) {
      const above = face.map((p) => dot(n, p) - at);
      if (above.some((height) => height > least))
        face = face.flatMap((p, i) => {
          const next = (i + 1) % face.length, [h, k] = [above[i], above[next]], inside = h <= least ? [p] : [];
          return h <= least === k <= least ? inside : [...inside, add(p, scaled(clamp(h / (h - k), 0, 1), subtract(face[next], p)))];
        });
    }
    return face.map((p) => add(center, p));
  });
}

// All within a distance of the hull of points.
/** @type {(points: Vector[], size: number, rounding: number, corners: number) => Solid} */
function roundedHull(points, size, rounding, corners) {
  const core = hullOf(points, size), least = roundingShare * size, places = triples(core.positions);
  if (!(rounding > least)) return core;
  const farthest = (/** @type {Vector} */ from) => places.reduce((best, p) => (length(subtract(p, from)) > length(subtract(best, from)) ? p : best));
  const a = farthest(places[0]), b = farthest(a), others = places.filter((p) => p !== a && p !== b), half = (/** @type {Vector} */ p) => scaled(0.5, subtract(p, a));
  // A rectangle's diagonals are equal and meet in their middles.
  const isRectangle = others.length === 2 && isNear(add(others[0], others[1]), add(a, b), 4 * least) && Math.abs(length(subtract(others[0], others[1])) - length(subtract(a, b))) <= 4 * least;
  if (isRectangle || core.indices.length === 0) {
    // Rings about a rectangle. A segment is a rectangle with one side, a point has none.
    const sides = isRectangle ? others.map(half) : [half(b), [0, 0, 0]], halves = sides.map(length), middle = add(a, half(b));
    const u = halves[0] > 0 ? unit(sides[0]) : [1, 0, 0], v = halves[1] > 0 ? unit(sides[1]) : across(u)[0], n = cross(u, v);
    const rings = Array.from({ length: corners / 2 + 1 }, (_, i) => {
      const angle = (2 * Math.PI * i) / corners - Math.PI / 2, radius = i % (corners / 2) === 0 ? 0 : rounding * Math.cos(angle);
      const place = (/** @type {number} */ x, /** @type {number} */ y) => add(middle, add(scaled(rounding * Math.sin(angle), n), add(scaled(x, u), scaled(y, v))));
      return fourArcs(corners, (k) => [halves[k % 2], halves[(k + 1) % 2], radius, 0, Math.PI / 2], place);
    });
    const tip = (/** @type {number} */ sign) => (isRectangle ? [[add(middle, scaled(sign * rounding, n))]] : []);
    return stacked([...tip(-1), ...rings, ...tip(1)], least);
  }
  // The farthest points all around, and of each face of the core.
  const normals = triples(core.indices).map((face) => face.map((i) => places[i])).map(([p, q, s]) => cross(subtract(q, p), subtract(s, p)));
  const directions = [...triples(slabCutBall([0, 0, 0], 1, [0, 0, 1], 1, -1, corners).positions), ...normals.filter((n) => length(n) > least * size).map(unit)];
  return hullOf(directions.flatMap((d) => {
    const far = places.map((p) => dot(p, d)), most = Math.max(...far);
    return places.filter((_, i) => far[i] >= most - least).map((p) => add(p, scaled(rounding, d)));
  }), size);
}

// A volume in its tree's frame, relative to the tree's center. `numbers` describe its shape, see WebShape; `extras` are its planes or points, four numbers each.
// `corners`: of a whole circle, a multiple of four.
/**
 * @param {number} shape
 * @param {Float32Array} numbers
 * @param {Float32Array} extras
 * @returns {Solid}
 */
export function solidOf(shape, numbers, extras, corners = cornersOfCircle) {
  const v = (/** @type {number} */ i) => [...numbers.subarray(i, i + 3)], c = v(0), size = numbers[3];
  switch (shapeNames[shape]) {
    case 'scb': return slabCutBall(c, size, unit(v(4)), numbers[7], numbers[8], corners);
    case 'scb2': return twiceCutBall(c, size, [{ n: v(4), e: numbers[7], f: numbers[12] }, { n: v(8), e: numbers[11], f: numbers[13] }], corners);
    case 'box': {
      const half = [size, numbers[7], numbers[11]], axes = [v(4), v(8), cross(v(4), v(8))].map((axis, i) => scaled(half[i], axis));
      return hullOf([0, 1, 2, 3, 4, 5, 6, 7].map((i) => add(c, times(axes, [0, 1, 2].map((k) => (i >> k & 1 ? 1 : -1))))), length(half));
    }
    case 'polytope': return hullOf(polytopeCorners(c, size, extras), size);
    case 'rounded': return roundedHull(Array.from({ length: extras.length / 4 }, (_, i) => add(c, extras.subarray(4 * i, 4 * i + 3))), size, numbers[4], corners);
    default: return { positions: [], indices: [] };
  }
}
