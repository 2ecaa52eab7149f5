// Vectors are arrays of three, matrices arrays of three columns.
/** @type {(a: Numbers, b: Numbers) => Vector} */
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
/** @type {(a: Numbers, b: Numbers) => Vector} */
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** @type {(s: number, a: Numbers) => Vector} */
export const scaled = (s, a) => [s * a[0], s * a[1], s * a[2]];
/** @type {(a: Numbers, b: Numbers) => number} */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @type {(a: Numbers, b: Numbers) => Vector} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @type {(a: Numbers) => number} */
export const length = (a) => Math.sqrt(dot(a, a));
/** @type {(a: Numbers) => Vector} */
export const unit = (a) => scaled(1 / length(a), a);
/** @type {(m: Vector[], v: Numbers) => Vector} */
export const times = (m, v) => add(add(scaled(v[0], m[0]), scaled(v[1], m[1])), scaled(v[2], m[2]));
/** @type {(m: Vector[], v: Numbers) => Vector} */
export const transposedTimes = (m, v) => m.map((column) => dot(column, v));
// Turns v about a unit axis.
/** @type {(v: Numbers, axis: Numbers, angle: number) => Vector} */
export const turned = (v, axis, angle) => {
  const c = Math.cos(angle), s = Math.sin(angle);
  return add(add(scaled(c, v), scaled(s, cross(axis, v))), scaled(dot(axis, v) * (1 - c), axis));
};
/** @type {(x: number, least: number, most: number) => number} */
export const clamp = (x, least, most) => Math.min(most, Math.max(least, x));
