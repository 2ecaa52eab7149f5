// Vectors are arrays of three, matrices arrays of three columns.
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (s, a) => [s * a[0], s * a[1], s * a[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.sqrt(dot(a, a));
export const unit = (a) => scaled(1 / length(a), a);
export const times = (m, v) => add(add(scaled(v[0], m[0]), scaled(v[1], m[1])), scaled(v[2], m[2]));
export const transposedTimes = (m, v) => m.map((column) => dot(column, v));
// Turns v about a unit axis.
export const turned = (v, axis, angle) => {
  const c = Math.cos(angle), s = Math.sin(angle);
  return add(add(scaled(c, v), scaled(s, cross(axis, v))), scaled(dot(axis, v) * (1 - c), axis));
};
export const clamp = (x, least, most) => Math.min(most, Math.max(least, x));
