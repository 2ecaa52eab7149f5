// The view of one pane. Eye space: x right, y up, z backward; the far plane is at depth 1.
uniform int orthographic;
uniform vec2 half_view;    // half the view's width and height: at depth 1, or anywhere when orthographic
uniform float near_plane;  // depth of the near plane
uniform vec4 target;       // x, y, width, height of the pane in the render target
uniform float pixel;       // height of a pixel, as half_view
uniform float line_scale;  // render target pixels per pixel of the picture
uniform vec4 clip;         // points p with dot(clip.xyz, p) + clip.w >= 0 are drawn; all zero: all points

// How far a point is behind the clipping plane, on the drawn side.
float behind_clip(vec3 p) { return dot(clip.xyz, p) + clip.w; }

// Points in the clipping plane are drawn, so rounding must not exclude them: the plane is moved
// forward by this part of the distance from the eye, or of the far distance where one value must
// serve for all points.
const float clip_slack = 4e-6;

bool is_clipped(vec3 p) { return behind_clip(p) < -clip_slack * (orthographic != 0 ? 1.0 : -p.z); }

// The value in the depth buffer for a point at distance `depth` in front of the eye, moved nearer
// by the fraction `nearer` of the distance. The buffer is linear, with floats, so a step of
// `nearer` has the same effect at every distance: meshes have 0, volumes 1.1e-5 to 4.2e-5, segments
// 7e-5.
float buffer_depth(float depth, float nearer) { return depth - nearer * depth; }

// Size of a pixel at that distance.
float pixel_size(float depth) { return orthographic != 0 ? pixel : pixel * depth; }
