// A segment as a rectangle that faces the viewer; the corners are computed in double precision by the caller.
layout(location = 0) in vec3 position;  // x, y: of clip space after division; z: distance from the eye
layout(location = 1) in vec4 color;
layout(location = 2) in uint id;

flat out vec4 v_color;
flat out uint v_id;

// In front of coplanar volumes and meshes.
const float bias = 6e-5;

void main() {
    v_color = color;
    v_id = id;
    float depth = max(position.z, near_plane);
    float window = window_depth(depth) - bias;
    gl_Position = vec4(position.xy, 2.0 * window - 1.0, 1.0);
}
