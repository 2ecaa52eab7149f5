import { add, subtract, scaled, dot, cross, length, unit, times, transposedTimes, turned, clamp } from './linear.js';

// A ball about balls. Its center is the center of a box about the balls.
/**
 * @param {Ball[]} balls
 * @returns {Ball}
 */
export function ballAbout(balls) {
  const ends = [0, 1, 2].map((i) => [Math.min(...balls.map(({ center, radius }) => center[i] - radius)), Math.max(...balls.map(({ center, radius }) => center[i] + radius))]);
  const center = ends.map(([least, most]) => (least + most) / 2);
  return { center, radius: Math.max(...balls.map((ball) => length(subtract(ball.center, center)) + ball.radius)) };
}

// Where one looks from. Axes are right, up and backward; `up` is the world's.
export class View {
  standBack = 0;

  /**
   * @param {ManifestCamera} stored
   * @param {Vector} up
   */
  constructor(stored, up) {
    this.up = up;
    this.fov = stored.fov;
    this.aspect = stored.aspect;
    this.widen = 1;
    this.axes = stored.axes;
    this.orthographic = stored.orthographic;
    const away = dot(subtract(stored.center, stored.position), scaled(-1, stored.axes[2]));
    this.distance = stored.orthographic ? stored.view_height / (2 * this.slope) : Math.max(away, 1e-300);
    this.target = subtract(stored.position, scaled(stored.orthographic ? away : this.distance, stored.axes[2]));
    this.fitted = { distance: this.distance, target: this.target };
    // A plane of the world { normal, offset }, or null: only points p with normal.p <= offset are drawn. The normal has any length but 0.
    this.clip = stored.clip ?? null;
  }

  // Half the height of the view at distance 1: a narrow pane still shows the width that was fitted.
  get slope() {
    return Math.tan((this.fov * Math.PI) / 360) * this.widen;
  }
  /** @type {(width: number, height: number) => void} */
  holdIn(width, height) {
    this.widen = Math.max(1, (this.aspect * height) / width);
  }
  get position() {
    return add(this.target, scaled(this.distance, this.axes[2]));
  }
  // World units per pixel at the target.
  /** @param {number} height */
  pixel(height) {
    return (2 * this.distance * this.slope) / height;
  }

  /** @type {(x: number, y: number) => void} */
  orbit(x, y) {
    let axes = this.axes.map((axis) => turned(axis, this.up, -x));
    const tilted = axes.map((axis) => turned(axis, axes[0], -y));
    // Not over the pole.
    if (dot(tilted[1], this.up) > 0.01 || dot(tilted[1], this.up) > dot(axes[1], this.up)) axes = tilted;
    this.axes = axes;
  }
  /** @type {(x: number, y: number, height: number) => void} */
  pan(x, y, height) {
    const step = this.pixel(height);
    this.target = add(this.target, add(scaled(-x * step, this.axes[0]), scaled(y * step, this.axes[1])));
  }
  /** @param {number} factor */
  zoom(factor) {
    this.distance *= factor;
  }
  // Looks along a direction of the world.
  /** @param {Vector} direction */
  along(direction) {
    const backward = scaled(-1, direction);
    const upright = Math.abs(dot(direction, this.up)) < 0.9 ? this.up : unit([this.up[1], this.up[2], this.up[0]]);
    const right = unit(cross(upright, backward));
    this.axes = [right, cross(backward, right), backward];
  }
  // Holds a ball.
  /** @type {(ball: Ball, aspect: number) => void} */
  fit(ball, aspect) {
    this.target = ball.center;
    const narrow = Math.atan(this.slope * Math.min(1, aspect));
    this.distance = ball.radius / Math.sin(narrow);
  }

  // What shaders/eye.glsl wants, for a rectangle of the target, and how world points get into eye space.
  /** @type {(rectangle: number[], lineScale: number, balls: Ball[]) => Eye} */
  eye(rectangle, lineScale, balls) {
    const depths = balls.map((ball) => [dot(subtract(this.eyePoint, ball.center), this.axes[2]), ball.radius]);
    const far = Math.max(...depths.map(([depth, radius]) => depth + radius), 1e-300) * 1.02;
    const near = Math.max(Math.min(...depths.map(([depth, radius]) => depth - radius)) * 0.98, far * 1e-4);
    const halfHeight = this.orthographic ? (this.distance * this.slope) / far : this.slope;
    const [x, y, width, height] = rectangle;
    return {
      far,
      uniforms: {
        orthographic: this.orthographic ? 1 : 0,
        half_view: [(halfHeight * width) / height, halfHeight],
        near_plane: near / far,
        target: [x, y, width, height],
        pixel: (2 * halfHeight) / height,
        line_scale: lineScale,
        clip: this.clipInEye(far),
      },
    };
  }
  // The points that are drawn are those p of eye space, where `far` is 1, with dot(xyz, p) + w >= 0; all, if all four are 0.
  /** @param {number} far */
  clipInEye(far) {
    if (!this.clip) return [0, 0, 0, 0];
    const size = length(this.clip.normal), normal = scaled(1 / size, this.clip.normal);
    const offset = this.clip.offset / size - dot(normal, this.eyePoint);
    return [...transposedTimes(this.axes, scaled(-1, normal)), clamp(offset / far, -1e6, 1e6)];
  }
  // An orthographic camera stands back far enough to see all.
  get eyePoint() {
    return this.orthographic ? add(this.target, scaled(this.standBack, this.axes[2])) : this.position;
  }

  // The rigid transformation of a body's frame into eye space, for points that count from `center`.
  /** @type {(pose: Pose, center: Vector, far: number) => Placement} */
  placement(pose, center, far) {
    const rows = this.axes;
    const columns = [0, 1, 2].map((i) => transposedTimes(rows, pose.rotation[i]));
    const world = add(times(pose.rotation, center), pose.translation);
    const origin = scaled(1 / far, transposedTimes(rows, subtract(world, this.eyePoint)));
    return { to_eye: columns.flat(), origin, scale: 1 / far, columns };
  }

  // As `--camera orbit` has it, where z is up: degrees, and what is no longer as the pictures fit it, distance and target.
  orbitWords() {
    const [x, y, z] = this.axes[2], degrees = (/** @type {number} */ radians) => +((radians * 180) / Math.PI).toFixed(2), { distance, target } = this.fitted;
    const moved = distance !== this.distance || target.some((at, i) => at !== this.target[i]);
    return [degrees(Math.atan2(x, -y)), degrees(Math.asin(clamp(z, -1, 1))), ...(moved ? [this.distance, ...this.target].map((n) => +n.toPrecision(6)) : [])];
  }
}
