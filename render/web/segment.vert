// A segment as a rectangle that faces the viewer, as shaders/segment.vert has it, from points in the frame of a tree.
uniform mat3 to_eye;
uniform vec3 origin;
uniform float scale;
uniform vec4 color;
uniform float width;  // pixels of the target
uniform float lift;   // pixels of the picture by which it is drawn nearer

in vec3 from;
in vec3 to;

flat out vec4 v_color;
flat out uint v_id;
flat out int v_steep;
out float v_depth;
out float v_behind;

void main() {
    vec3 a = origin + scale * (to_eye * from), b = origin + scale * (to_eye * to);
    v_color = color;
    v_id = 0u;
    // What is behind the near plane is cut off.
    if (-a.z < near_plane && -b.z > near_plane) a = mix(a, b, (near_plane + a.z) / (a.z - b.z));
    if (-b.z < near_plane && -a.z > near_plane) b = mix(b, a, (near_plane + b.z) / (b.z - a.z));
    vec2 half_size = 0.5 * target.zw;
    vec2 on_a = a.xy / half_view / (orthographic != 0 ? 1.0 : -a.z), on_b = b.xy / half_view / (orthographic != 0 ? 1.0 : -b.z);
    vec2 along = (on_b - on_a) * half_size;
    float size = length(along);
    v_steep = abs(along.y) > abs(along.x) ? 1 : 0;
    vec2 beside = size > 1e-6 ? vec2(-along.y, along.x) / size : vec2(0.0, 1.0), ahead = vec2(beside.y, -beside.x);
    bool second = (gl_VertexID & 1) != 0;
    float side = (gl_VertexID & 2) != 0 ? 0.5 : -0.5, depth = max(second ? -b.z : -a.z, near_plane);
    vec2 at = (second ? on_b : on_a) + width * (side * beside + (second ? 0.5 : -0.5) * ahead) / half_size;
    v_behind = behind_clip(second ? b : a) / (orthographic != 0 ? 1.0 : depth);
    depth = max(depth - lift * line_scale * pixel_size(depth), near_plane);
    v_depth = orthographic != 0 ? depth : 1.0 / depth;
    float window = (orthographic != 0 ? depth - near_plane : 1.0 - near_plane / depth) / (1.0 - near_plane);
    gl_Position = -a.z < near_plane && -b.z < near_plane ? vec4(2.0, 2.0, 0.0, 1.0) : vec4(at, 2.0 * window - 1.0, 1.0);
}
