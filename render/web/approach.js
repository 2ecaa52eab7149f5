import { add, subtract, scaled, dot, cross, length, unit, times } from './linear.js';
import { radiusOf } from './tree.js';

/** @typedef {{ column: number, balls: Ball[], has: (id: number) => boolean, room: number, across?: Vector }} Goal */

// `across`: a direction in the world that the view should not look along.
// What one goes to: the node, the triangle or the pair that is chosen, else what the query marks; its place, and the ids of its pixels.
/** @type {(app: App) => Goal} */
function goalOf(app) {
  const { selected, pair, column: shown } = app.state, column = selected?.column ?? shown, { bodies } = app.columns[column], { whole, marked } = app.triangleIds[column], { nodes, contacts, parts } = app.scenes[column];
  const place = (/** @type {number} */ b, /** @type {Vector} */ center) => add(times(app.poseOf(column, b).rotation, center), app.poseOf(column, b).translation);
  const ballOf = (/** @type {number} */ b, /** @type {number} */ slot) => {
    const tree = app.treeOf(column, b), volume = tree.volume(slot);
    return { center: place(b, add(tree.stored.center, volume.numbers)), radius: radiusOf(volume) };
  };
  const idOf = (/** @type {number} */ b, /** @type {number} */ slot) => bodies[b].first_id + bodies[b].tree.order[slot];
  // Of a triangle in its mesh, and where it is drawn by itself.
  const idsOf = (/** @type {number} */ b, /** @type {number} */ triangle) => {
    const own = (parts ?? []).filter(({ side }) => side === b).flatMap(({ triangles }) => triangles).indexOf(triangle);
    return [whole[b] + triangle, ...(own >= 0 ? [marked[b] + own] : [])];
  };
  const among = (/** @type {number[]} */ ids) => {
    const all = new Set(ids);
    return (/** @type {number} */ id) => all.has(id);
  };
  if (selected) {
    const { body, slot, triangle } = selected;
    return { column, balls: [ballOf(body, slot)], has: among(triangle === null ? [idOf(body, slot)] : idsOf(body, triangle)), room: 1.2 };
  }
  if (nodes?.length && !pair) {
    const drawn = among(nodes.map(({ side, slot }) => idOf(side, slot)));
    return { column, balls: nodes.map(({ side, slot }) => ballOf(side, slot)), has: (id) => drawn(id) || id >= marked[0], room: 1.2 };
  }
  const lines = (contacts ?? []).filter(({ pair: [a, b] }) => !pair || (a === pair[0] && b === pair[1])).flatMap(({ line }) => [line.slice(0, 3), line.slice(3)]);
  const balls = lines.map((point) => ({ center: place(0, add(app.treeOf(column, 0).stored.center, point)), radius: 0 }));
  // The line between closest points, which is to be seen in its length, with what is about it.
  const line = app.measures && balls.length === 2 ? subtract(balls[1].center, balls[0].center) : [0, 0, 0];
  if (length(line) > 0) return { column, balls, has: (id) => id >= marked[0], room: 3, across: unit(line) };
  return { column, balls, has: pair ? among([0, 1].flatMap((side) => idsOf(side, pair[side]))) : (id) => id >= marked[0], room: pair ? 20 : 1.2 };
}

// From the middle of a cube to its faces, edges and corners, about `up`.
/** @type {(up: Vector) => Vector[]} */
export function directions(up) {
  const ahead = unit(cross(up, Math.abs(up[0]) < 0.9 * Math.hypot(...up) ? [1, 0, 0] : [0, 1, 0])), right = cross(ahead, unit(up)), round = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => (i * Math.PI) / 4);
  const level = (/** @type {number} */ elevation) => round.map((azimuth) => add(scaled(Math.cos(elevation), add(scaled(Math.cos(azimuth), right), scaled(Math.sin(azimuth), ahead))), scaled(Math.sin(elevation), unit(up))));
  return [...level(0), ...level(Math.PI / 4), ...level(-Math.PI / 4), unit(up), scaled(-1, unit(up))];
}

// Goes there, and turns to where most of it is seen: the present direction if none shows more.
/** @param {App} app */
export function approach(app) {
  const { view, canvas } = app, { column, balls, has, room, across } = goalOf(app), finite = balls.filter(({ center, radius }) => [...center, radius].every(Number.isFinite));
  if (finite.length === 0) return;
  app.fit(finite, room);
  if (!app.unpacked) return;
  const shrunk = 240 / Math.max(canvas.width, canvas.height), size = [canvas.width, canvas.height].map((n) => Math.max(1, Math.round(n * shrunk)));
  let best = view.axes, most = -1;
  for (const direction of [null, ...directions(view.up)]) {
    if (direction) view.along(direction);
    const axes = view.axes;
    if (across && Math.abs(dot(axes[2], across)) > 0.5) continue;
    app.drawAt(size[0], size[1], 1);
    const count = app.painter.idsIn(app.panes[column].rectangle).reduce((sum, id) => sum + (has(id) ? 1 : 0), 0);
    if (count > most) [best, most] = [axes, count];
  }
  view.axes = best;
  app.draw();
  app.moved();
}
