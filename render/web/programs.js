// What the sources of the pictures' shaders need in front of them here.
const preamble = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
#define SHAPE_SCB 1
#define SHAPE_SCB2 2
#define SHAPE_BOX 3
#define SHAPE_POLYTOPE 4
`;
// All of the canvas; each pixel is the mean of the target's pixels. An object with bit 30 in its id is outlined by itself, an object with
// bit 29 together with the objects that it touches.
/** @type {Record<string, string>} */
const resolve = {
  'resolve.vert': `void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`,
  'resolve.frag': `
uniform sampler2D picture;
uniform highp usampler2D ids;
uniform int per_pixel;
uniform vec3 outline;
layout(location = 0) out vec4 out_color;
bool is_edge(ivec2 at) {
    uint id = texelFetch(ids, at, 0).r;
    if ((id & 0x60000000u) == 0u) return false;
    ivec2 last = textureSize(ids, 0) - 1;
    for (int i = 0; i < 8; ++i) {
        ivec2 step = ivec2(i < 3 ? -1 : i < 5 ? 0 : 1, i == 0 || i == 3 || i == 5 ? -1 : i == 1 || i == 6 ? 0 : 1);
        uint other = texelFetch(ids, clamp(at + step * per_pixel, ivec2(0), last), 0).r;
        if ((id & 0x40000000u) != 0u ? other != id : (other & 0x20000000u) == 0u) return true;
    }
    return false;
}
void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * per_pixel;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < per_pixel; ++y)
        for (int x = 0; x < per_pixel; ++x) {
            ivec2 at = first + ivec2(x, y);
            sum += is_edge(at) ? vec4(outline, 1.0) : texelFetch(picture, at, 0);
        }
    out_color = sum / float(per_pixel * per_pixel);
}`,
  // Around segment.frag. Dashes are places of the picture, so that they go on from segment to segment.
  'before_dashes': '#define main draw_segment',
  'dashes': `
#undef main
flat in int v_steep;
void main() {
    if (fract((v_steep != 0 ? gl_FragCoord.y : gl_FragCoord.x) / (8.0 * line_scale)) > 0.625) discard;
    draw_segment();
}`,
};
// Planes of polytopes are in the frame of their tree here.
const planes = `
uniform sampler2D extras;
uniform mat3 to_eye;
uniform float scale;
vec4 plane_at(int index) {
    vec4 plane = texelFetch(extras, ivec2(index & 2047, index >> 11), 0);
    return vec4(to_eye * plane.xyz, scale * plane.w);
}
`;

/** @typedef {number | number[]} Uniform */
export class Program {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {string[]} vertex parts of the vertex shader
   * @param {string[]} fragment parts of the fragment shader
   * @param {string[]} attributes
   */
  constructor(gl, vertex, fragment, attributes, define = '') {
    this.gl = gl;
    this.name = /** @type {WebGLProgram} */ (gl.createProgram());
    const text = (/** @type {string} */ part) => (part === 'planes' ? planes : resolve[part] ?? /** @type {HTMLScriptElement} */ (document.getElementById(part)).text);
    for (const { stage, parts } of [{ stage: gl.VERTEX_SHADER, parts: vertex }, { stage: gl.FRAGMENT_SHADER, parts: fragment }]) {
      const shader = /** @type {WebGLShader} */ (gl.createShader(stage));
      gl.shaderSource(shader, preamble + define + parts.map(text).join('\n'));
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(String(gl.getShaderInfoLog(shader)));
      gl.attachShader(this.name, shader);
    }
    attributes.forEach((name, i) => gl.bindAttribLocation(this.name, i, name));
    gl.linkProgram(this.name);
    if (!gl.getProgramParameter(this.name, gl.LINK_STATUS)) throw new Error(String(gl.getProgramInfoLog(this.name)));
    /** @type {Map<string, { type: number, at: WebGLUniformLocation | null }>} */
    this.places = new Map();
    const count = gl.getProgramParameter(this.name, gl.ACTIVE_UNIFORMS);
    for (let i = 0; i < count; ++i) {
      const { name, type } = /** @type {WebGLActiveInfo} */ (gl.getActiveUniform(this.name, i));
      this.places.set(name, { type, at: gl.getUniformLocation(this.name, name) });
    }
  }

  /** @param {Record<string, Uniform>} values */
  use(values) {
    this.gl.useProgram(this.name);
    for (const [name, value] of Object.entries(values)) this.set(name, value);
  }

  // Uniforms that a shader has no use for are not there.
  /**
   * @param {string} name
   * @param {Uniform} value
   */
  set(name, value) {
    const { gl } = this, place = this.places.get(name);
    if (!place) return;
    const number = /** @type {number} */ (value), numbers = /** @type {number[]} */ (value);
    switch (place.type) {
      case gl.INT: case gl.SAMPLER_2D: case gl.UNSIGNED_INT_SAMPLER_2D: return gl.uniform1i(place.at, number);
      case gl.UNSIGNED_INT: return gl.uniform1ui(place.at, number);
      case gl.FLOAT: return gl.uniform1f(place.at, number);
      case gl.FLOAT_VEC2: return gl.uniform2fv(place.at, numbers);
      case gl.FLOAT_VEC3: return gl.uniform3fv(place.at, numbers);
      case gl.FLOAT_VEC4: return gl.uniform4fv(place.at, numbers);
      case gl.FLOAT_MAT3: return gl.uniformMatrix3fv(place.at, false, numbers);
      case gl.FLOAT_MAT4: return gl.uniformMatrix4fv(place.at, false, numbers);
      default: throw new Error(`uniform ${name}`);
    }
  }
}
