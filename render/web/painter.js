import { add, subtract, scaled, dot, cross, length, times, transposedTimes } from './linear.js';
import { Program } from './programs.js';
import { shapeNames } from './tree.js';

// Bits of ids, see resolve.
export const outlined = { alone: 1 << 30, together: 1 << 29 };

// Draws panes: meshes and volumes by one camera, with the id of the object in each pixel.
export class Painter {
  samples = 1;
  /** @type {WebGLFramebuffer | null} */
  target = null;
  // Of the target.
  /** @type {WebGLTexture | null} */
  color = null;
  /** @type {WebGLTexture | null} */
  ids = null;
  /** @type {WebGLRenderbuffer | null} */
  depth = null;
  /** @type {Size} */
  size = [0, 0];

  // `grids`: corners of triangles all over a sphere, of few to many volumes.
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Float32Array[]} grids
   */
  constructor(canvas, grids) {
    const gl = canvas.getContext('webgl2', { alpha: false, antialias: false, depth: false, powerPreference: 'high-performance' });
    if (!gl) throw new Error('no WebGL2');
    this.canvas = canvas;
    this.gl = gl;
    const volume = ['eye.glsl', 'light.glsl', 'volume.glsl'];
    /** @type {Record<string, Program>} */
    this.programs = {};
    for (const shape of ['scb', 'scb2', 'box', 'polytope']) {
      const fragment = [...volume, ...(shape === 'polytope' ? ['planes'] : []), `${shape}.frag`];
      const define = `#define SHAPE SHAPE_${shape.toUpperCase()}\n`;
      this.programs[shape] = new Program(gl, ['eye.glsl', 'volume.vert'], fragment, ['instance'], define);
    }
    this.programs.rounded = new Program(gl, ['eye.glsl', 'rounded.vert'], [...volume, 'rounded.frag'], ['instance', 'direction']);
    this.meshProgram = new Program(gl, ['eye.glsl', 'mesh.vert'], ['eye.glsl', 'light.glsl', 'mesh.frag'], []);
    this.segmentProgram = new Program(gl, ['eye.glsl', 'segment.vert'], ['eye.glsl', 'segment.frag'], ['from', 'to']);
    this.dashedProgram = new Program(gl, ['eye.glsl', 'segment.vert'], ['eye.glsl', 'before_dashes', 'segment.frag', 'dashes'], ['from', 'to']);
    this.resolveProgram = new Program(gl, ['resolve.vert'], ['resolve.frag'], []);
    this.instances = gl.createBuffer();
    this.array = gl.createVertexArray();
    this.grids = grids.map((corners) => {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, corners, gl.STATIC_DRAW);
      return { buffer, count: corners.length / 3 };
    });
  }

  // `samples`: target pixels per pixel of the canvas, in x and y.
  /** @type {(width: number, height: number, samples: number) => void} */
  resize(width, height, samples) {
    const { gl } = this;
    this.samples = samples;
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    /** @type {Size} */
    const size = [width * samples, height * samples];
    if (size[0] === this.size[0] && size[1] === this.size[1]) return;
    this.size = size;
    for (const texture of [this.color, this.ids]) if (texture) gl.deleteTexture(texture);
    if (this.depth) gl.deleteRenderbuffer(this.depth);
    this.target ??= gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    const attach = (/** @type {number} */ format, /** @type {number} */ place) => {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, ...size);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, place, gl.TEXTURE_2D, texture, 0);
      return texture;
    };
    this.color = attach(gl.RGBA8, gl.COLOR_ATTACHMENT0);
    this.ids = attach(gl.R32UI, gl.COLOR_ATTACHMENT1);
    this.depth = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, this.depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, ...size);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, this.depth);
  }

  // `outline`: the color of outlines.
  /** @type {(panes: Pane[], outline: Color) => void} */
  draw(panes, outline) {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.enable(gl.SCISSOR_TEST);
    gl.depthFunc(gl.LESS);
    for (const pane of panes) {
      gl.viewport(...pane.rectangle);
      gl.scissor(...pane.rectangle);
      gl.enable(gl.DEPTH_TEST);
      gl.depthMask(true);
      gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
      gl.clearBufferfv(gl.COLOR, 0, [...pane.background.map((c) => c / 255), 1]);
      gl.clearBufferuiv(gl.COLOR, 1, [0, 0, 0, 0]);
      gl.clearBufferfv(gl.DEPTH, 0, [1]);
      for (const mesh of pane.meshes) if (mesh.backdrop) this.drawMesh(pane, mesh);
      if (pane.meshes.some((mesh) => mesh.backdrop)) gl.clearBufferfv(gl.DEPTH, 0, [1]);
      for (const mesh of pane.meshes) if (!mesh.backdrop) this.drawMesh(pane, mesh);
      this.drawVolumes(pane, pane.opaque, 1);
      this.drawHidden(pane);
      if (pane.translucent.count > 0) this.drawTranslucent(pane);
      for (const segments of pane.segments) this.drawSegments(pane, segments);
    }
    gl.disable(gl.SCISSOR_TEST);
    // Not by blitFramebuffer, which some browsers no longer do once the canvas has another size.
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.disable(gl.DEPTH_TEST);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.color);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.ids);
    this.resolveProgram.use({ picture: 0, ids: 1, per_pixel: this.samples, outline: outline.map((c) => c / 255) });
    gl.bindVertexArray(this.array);
    gl.disableVertexAttribArray(0);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  // What something hides is drawn over it, which so looks translucent; then the visible parts once more. Ids do not change, so a click finds what is in front.
  /** @param {Pane} pane */
  drawHidden(pane) {
    const { gl } = this, meshes = pane.meshes.filter(({ shine_through }) => shine_through);
    if (meshes.length === 0 && pane.shining.count === 0) return;
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.NONE]);
    gl.depthMask(false);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA, gl.ZERO, gl.ONE);
    gl.depthFunc(gl.GREATER);
    for (const mesh of meshes) {
      gl.blendColor(0, 0, 0, mesh.shine_through ?? 0);
      this.drawMesh(pane, { ...mesh, placement: nearer(mesh.placement, pane.eye.uniforms.orthographic !== 0) });
    }
    gl.disable(gl.BLEND);
    gl.depthFunc(gl.LEQUAL);
    for (const mesh of meshes) this.drawMesh(pane, mesh);
    gl.enable(gl.BLEND);
    gl.depthFunc(gl.GREATER);
    gl.blendColor(0, 0, 0, 0.45);
    this.drawVolumes(pane, pane.shining, 1);
    gl.disable(gl.BLEND);
    gl.depthFunc(gl.LESS);
    gl.depthMask(true);
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
  }

  /** @param {Pane} pane */
  drawTranslucent(pane) {
    const { gl } = this;
    this.sort(pane, pane.translucent);
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.NONE]);
    gl.depthMask(false);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.drawVolumes(pane, pane.translucent, 2);
    gl.disable(gl.BLEND);
    gl.depthMask(true);
    gl.drawBuffers([gl.NONE, gl.COLOR_ATTACHMENT1]);
    this.drawVolumes(pane, pane.translucent, 1);
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
  }

  // The ids in a rectangle of the target.
  /** @type {(rectangle: Rectangle) => Uint32Array} */
  idsIn([x, y, width, height]) {
    const { gl } = this, ids = new Uint32Array(width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.readBuffer(gl.COLOR_ATTACHMENT1);
    gl.readPixels(x, y, width, height, gl.RED_INTEGER, gl.UNSIGNED_INT, ids);
    return ids.map((id) => id & ~(outlined.alone | outlined.together));
  }

  // The id at a pixel of the canvas, from the top left.
  /** @type {(x: number, y: number) => number} */
  idAt(x, y) {
    const { samples } = this;
    return this.idsIn([x * samples, this.size[1] - 1 - y * samples, 1, 1])[0];
  }

  // Triangles of their own, so that each is flat; of a mesh all, or some, which have colors then.
  /**
   * @param {Float32Array} positions
   * @param {Uint32Array} indices
   * @param {number[] | null} colors
   * @returns {Upload}
   */
  uploadMesh(positions, indices, colors = null) {
    const { gl } = this, count = indices.length, data = new Float32Array(6 * count);
    for (let t = 0; t < count; t += 3) {
      const p = [0, 1, 2].map((k) => [...positions.subarray(3 * indices[t + k], 3 * indices[t + k] + 3)]);
      const n = cross(subtract(p[1], p[0]), subtract(p[2], p[0])), size = length(n);
      for (let k = 0; k < 3; ++k) {
        data.set(p[k], 6 * (t + k));
        if (size > 0) data.set(scaled(1 / size, n), 6 * (t + k) + 3);
      }
    }
    const array = gl.createVertexArray(), buffer = gl.createBuffer();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    this.pairOfVectors(0);
    const buffers = [buffer];
    if (colors) {
      buffers.push(gl.createBuffer());
      gl.bindBuffer(gl.ARRAY_BUFFER, buffers[1]);
      gl.bufferData(gl.ARRAY_BUFFER, Uint8Array.from({ length: 4 * count }, (_, i) => (i % 4 === 3 ? 255 : colors[3 * Math.floor(i / 12) + (i % 4)])), gl.STATIC_DRAW);
      gl.enableVertexAttribArray(2);
      gl.vertexAttribPointer(2, 4, gl.UNSIGNED_BYTE, true, 4, 0);
    }
    return { array, count, buffers, colored: colors !== null };
  }

  // The first two attributes, of the buffer that is bound: two vectors one after the other, per vertex or per instance.
  /** @param {number} divisor */
  pairOfVectors(divisor) {
    const { gl } = this;
    for (const i of [0, 1]) {
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, 3, gl.FLOAT, false, 24, 12 * i);
      gl.vertexAttribDivisor(i, divisor);
    }
  }

  /** @param {Upload} upload */
  release({ array, buffers }) {
    this.gl.deleteVertexArray(array);
    for (const buffer of buffers) this.gl.deleteBuffer(buffer);
  }

  /**
   * @param {Float32Array} points
   * @returns {Upload}
   */
  uploadSegments(points) {
    const { gl } = this, array = gl.createVertexArray(), buffer = gl.createBuffer();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, points, gl.STATIC_DRAW);
    this.pairOfVectors(1);
    return { array, count: points.length / 6, buffers: [buffer] };
  }

  /** @type {(pane: Pane, drawn: DrawnSegments) => void} */
  drawSegments(pane, { segments, placement, color, width, on_top, dashed = false, lift = 0 }) {
    const { gl } = this;
    (dashed ? this.dashedProgram : this.segmentProgram).use({ ...pane.eye.uniforms, to_eye: placement.to_eye, origin: placement.origin, scale: placement.scale, color: [...color.map((c) => c / 255), 1], width: width * this.samples, lift });
    if (on_top) gl.disable(gl.DEPTH_TEST);
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.NONE]);
    gl.bindVertexArray(segments.array);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, segments.count);
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
    gl.enable(gl.DEPTH_TEST);
  }

  /** @type {(pane: Pane, drawn: DrawnMesh) => void} */
  drawMesh(pane, { mesh, placement, color, edges = false, fade = 0, hatched = false, shading = 1, first_id = 0 }) {
    const { gl } = this, { columns: m, origin, scale } = placement;
    this.meshProgram.use({
      ...pane.eye.uniforms,
      to_eye: [...m.map((column) => [...scaled(scale, column), 0]).flat(), ...origin, 1],
      normal_to_eye: m.flat(),
      colored: mesh.colored ? 1 : 0,
      color: [...color.map((c) => c / 255), 1],
      edges: edges ? 1 : 0,
      hatched: hatched ? 1 : 0,
      first_id,
      shading,
      fade: [...pane.background.map((c) => c / 255), fade],
    });
    gl.bindVertexArray(mesh.array);
    gl.drawArrays(gl.TRIANGLES, 0, mesh.count);
  }

  // Far to near, of equal distances by id: `list` is in runs of one tree and shape.
  /** @type {(pane: Pane, list: VolumeList) => void} */
  sort(pane, list) {
    const depth = new Float64Array(list.count), backward = pane.view.axes[2];
    let next = 0;
    const of = new Uint32Array(list.count), words = list.words;
    list.groups.forEach((group, g) => {
      const axis = transposedTimes(group.pose.rotation, backward), at = dot(add(times(group.pose.rotation, group.tree.stored.center), group.pose.translation), backward);
      for (let i = 0; i < group.count; ++i, ++next) {
        const [x, y, z] = axis, k = 3 * i;
        depth[next] = at + x * group.centers[k] + y * group.centers[k + 1] + z * group.centers[k + 2];
        of[next] = g;
      }
    });
    const order = Uint32Array.from({ length: list.count }, (_, i) => i);
    order.sort((a, b) => depth[a] - depth[b] || words[3 * a + 2] - words[3 * b + 2]);
    const sorted = new Uint32Array(words.length);
    /** @type {NonNullable<VolumeList['runs']>} */
    const runs = [];
    order.forEach((from, to) => {
      sorted.set(words.subarray(3 * from, 3 * from + 3), 3 * to);
      const group = list.groups[of[from]], last = runs.at(-1);
      if (last?.group === group) ++last.count;
      else runs.push({ group, first: to, count: 1 });
    });
    Object.assign(list, { drawn: sorted, runs });
  }

  // `sides`: 1, the front; 2, the back too.
  /** @type {(pane: Pane, list: VolumeList, sides: number) => void} */
  drawVolumes(pane, list, sides) {
    const { gl } = this;
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
    gl.bufferData(gl.ARRAY_BUFFER, list.drawn ?? list.words, gl.STREAM_DRAW);
    let first = 0;
    const runs = list.runs ?? list.groups.map((group) => ({ group, first: (first += group.count) - group.count, count: group.count }));
    for (const { group, first: at, count } of runs) {
      const shape = shapeNames[group.shape], { placement } = group;
      this.programs[shape].use({ ...pane.eye.uniforms, to_eye: placement.to_eye, origin: placement.origin, scale: placement.scale, volumes: 0, extras: 1, sides });
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, group.tree.volumeTexture);
      gl.activeTexture(gl.TEXTURE1);
      gl.bindTexture(gl.TEXTURE_2D, group.tree.extraTexture);
      gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
      gl.enableVertexAttribArray(0);
      gl.vertexAttribIPointer(0, 3, gl.UNSIGNED_INT, 12, 12 * at);
      gl.vertexAttribDivisor(0, sides);
      if (shape === 'rounded') {
        const grid = this.grids[list.count <= 100 ? 0 : list.count <= 4000 ? 1 : 2];  // as pictures do
        gl.bindBuffer(gl.ARRAY_BUFFER, grid.buffer);
        gl.enableVertexAttribArray(1);
        gl.vertexAttribPointer(1, 3, gl.FLOAT, false, 0, 0);
        gl.drawArraysInstanced(gl.TRIANGLES, 0, grid.count, count * sides);
        gl.disableVertexAttribArray(1);
      } else {
        gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count * sides);
      }
    }
  }
}

// So much nearer to the eye, at the same place of the picture, that surfaces that coincide do not hide each other.
/** @type {(placement: Placement, orthographic: boolean) => Placement} */
function nearer({ origin: [x, y, z], scale, ...rest }, orthographic) {
  const by = 1 - 2e-4;
  return orthographic ? { ...rest, origin: [x, y, by * z], scale } : { ...rest, origin: [by * x, by * y, by * z], scale: by * scale };
}
