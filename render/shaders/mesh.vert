uniform mat4 to_eye;         // mesh units to eye units
uniform mat3 normal_to_eye;
uniform int colored;        // whether triangles have colors of their own
uniform vec4 color;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 triangle_color;

flat out vec3 v_normal;
flat out vec4 v_color;
flat out uint v_triangle;  // gl_PrimitiveID counts what is drawn
out vec3 v_corner;  // barycentric coordinates
out vec3 v_eye;

void main() {
    vec3 eye = (to_eye * vec4(position, 1.0)).xyz;
    float depth = -eye.z;
    v_eye = eye;
    v_normal = normal_to_eye * normal;
    v_color = colored != 0 ? triangle_color : color;
    int triangle = gl_VertexID / 3, corner = gl_VertexID - 3 * triangle;
    v_triangle = uint(triangle);
    v_corner = vec3(corner == 0 ? 1.0 : 0.0, corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0);
    // z only clips; the fragment shader writes the depth.
    float w = orthographic != 0 ? 1.0 : depth;
    gl_Position = vec4(eye.xy / half_view, 2.0 * (depth - near_plane) / (1.0 - near_plane) - w, w);
}
