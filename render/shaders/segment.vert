// A segment as a rectangle that faces the viewer; the corners are computed in double precision by the caller.
layout(location = 0) in vec3 position;  // x, y: of clip space after division; z: distance from the eye
layout(location = 1) in vec4 color;
layout(location = 2) in uint id;
layout(location = 3) in float behind;

flat out vec4 v_color;
flat out uint v_id;
out float v_depth;  // its inverse in perspective: what is linear on the screen
out float v_behind;

void main() {
    v_color = color;
    v_id = id;
    v_behind = behind;
    float depth = max(position.z, near_plane);
    v_depth = orthographic != 0 ? depth : 1.0 / depth;
    // z only clips; the fragment shader writes the depth.
    float window = (orthographic != 0 ? depth - near_plane : 1.0 - near_plane / depth) / (1.0 - near_plane);
    gl_Position = vec4(position.xy, 2.0 * window - 1.0, 1.0);
}
