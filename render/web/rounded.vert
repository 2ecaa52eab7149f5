// The triangles of each side of each rounded volume, as shaders/convex.vert has them: here a volume is the hull of a few points,
// rounded, and each corner is at its farthest point along a direction.
uniform sampler2D volumes;
uniform sampler2D extras;  // points from the volume's center
uniform int sides;
uniform mat3 to_eye;
uniform vec3 origin;
uniform float scale;

in uvec3 instance;
in vec3 direction;

flat out uvec4 v_tag;
flat out int v_side;
out vec3 v_normal;
out vec3 v_eye;

vec4 texel(int index) {
    int at = 4 * int(instance.x) + index;
    return texelFetch(volumes, ivec2(at & 2047, at >> 11), 0);
}

void main() {
    vec4 a = texel(0), d = texel(3);
    vec3 farthest = vec3(0.0);
    float most = -1e30;
    for (int i = 0; i < int(d.y); ++i) {
        int at = int(d.x) + i;
        vec3 point = texelFetch(extras, ivec2(at & 2047, at >> 11), 0).xyz;
        if (dot(point, direction) > most) {
            most = dot(point, direction);
            farthest = point;
        }
    }
    v_tag = uvec4(instance.yz, 0u, 0u);
    v_side = sides == 1 ? 0 : 1 + (gl_InstanceID & 1);
    v_normal = to_eye * direction;
    v_eye = origin + scale * (to_eye * (a.xyz + farthest + texel(1).x * direction));
    float depth = -v_eye.z, w = orthographic != 0 ? 1.0 : depth;
    gl_Position = vec4(v_eye.xy / half_view, 2.0 * (depth - near_plane) / (1.0 - near_plane) - w, w);
}
