// The rectangle of a volume on the screen, for the fragment shaders of all volumes but rounded ones. Four texels describe a
// volume in the frame of its tree, see Tree in tree.js; the pictures of `scb render` have them in eye space, see shaders/volume.vert.
uniform sampler2D volumes;
uniform int sides;  // 1: the nearest surface; 2: the back side, then the front, as instances that follow each other
uniform mat3 to_eye;
uniform vec3 origin;
uniform float scale;  // eye units per unit of the tree

in uvec3 instance;  // place in `volumes`, color, id (its highest bit: hatched)

flat out vec4 v_a;
flat out vec4 v_b;
flat out vec4 v_c;
flat out uvec4 v_tag;
flat out int v_side;

vec4 texel(int index) {
    int at = 4 * int(instance.x) + index;
    return texelFetch(volumes, ivec2(at & 2047, at >> 11), 0);
}
vec3 placed(vec3 point) { return origin + scale * (to_eye * point); }

// Left, bottom, right, top in normalised device coordinates.
const vec4 everything = vec4(-1.0, -1.0, 1.0, 1.0);

vec4 both(vec4 a, vec4 b) { return vec4(max(a.xy, b.xy), min(a.zw, b.zw)); }

vec2 touching_slopes(float x, float depth, float r) {
    float root = r * sqrt(max(0.0, x * x + depth * depth - r * r));
    return vec2(x * depth - root, x * depth + root) / (depth * depth - r * r);
}

vec4 around_ball(vec3 c, float r) {
    vec2 x = vec2(c.x - r, c.x + r), y = vec2(c.y - r, c.y + r);
    if (orthographic == 0) {
        if (-c.z - r <= 1e-3 * r) return everything;
        x = touching_slopes(c.x, -c.z, r);
        y = touching_slopes(c.y, -c.z, r);
    }
    return vec4(x.x, y.x, x.y, y.y) / half_view.xyxy;
}

// `a`, `b` and `c` are half axes.
vec4 around_box(vec3 center, vec3 a, vec3 b, vec3 c) {
    vec4 result = vec4(1e30, 1e30, -1e30, -1e30);
    for (int corner = 0; corner < 8; ++corner) {
        vec3 p = center + ((corner & 1) != 0 ? a : -a) + ((corner & 2) != 0 ? b : -b) + ((corner & 4) != 0 ? c : -c);
        float depth = orthographic != 0 ? 1.0 : -p.z;
        if (depth < 0.5 * near_plane) return everything;
        vec2 at = p.xy / depth / half_view;
        result = vec4(min(result.xy, at), max(result.zw, at));
    }
    return result;
}

float rim_radius(float r, float k) {
    float rim = sqrt(max(r * r - k * k, 0.0));
    return rim > 1e-3 * r ? rim : 0.0;
}

void main() {
    vec4 a = texel(0), b = texel(1), c = texel(2), d = texel(3);
    vec3 center = placed(a.xyz);
    float r = scale * a.w, reach = r;
    vec4 rectangle = everything;
    v_a = vec4(center, r);
    v_tag = uvec4(instance.yz, 0u, 0u);
#if SHAPE == SHAPE_SCB
    vec3 n = to_eye * b.xyz;
    float e = scale * b.w, f = scale * c.x;
    v_b = vec4(n, e);
    v_c = vec4(f, rim_radius(r, e), rim_radius(r, f), 1.0 / r);
    rectangle = around_ball(center, r);
    if (e - f < 1.8 * r) {
        float off_center = f > 0.0 ? f : (e < 0.0 ? e : 0.0);
        float rim = sqrt(max(0.0, r * r - off_center * off_center));
        vec3 u = normalize(cross(n, abs(n.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
        rectangle = both(rectangle, around_box(center + 0.5 * (e + f) * n, rim * u, rim * cross(n, u), 0.5 * (e - f) * n));
    }
#elif SHAPE == SHAPE_SCB2
    v_b = vec4(to_eye * b.xyz, scale * b.w);
    v_c = vec4(to_eye * c.xyz, scale * c.w);
    v_tag.zw = floatBitsToUint(scale * d.xy);
    rectangle = around_ball(center, r);
    // The box about the part between the slabs: along both normals, and along the long axis as far as the ball reaches there.
    vec2 e = vec2(v_b.w, v_c.w), f = scale * d.xy, off_center = max(max(f, -e), vec2(0.0));
    float along = sqrt(max(0.0, r * r - dot(off_center, off_center)));
    vec3 middle = center + 0.5 * (e.x + f.x) * v_b.xyz + 0.5 * (e.y + f.y) * v_c.xyz;
    rectangle = both(rectangle, around_box(middle, 0.5 * (e.x - f.x) * v_b.xyz, 0.5 * (e.y - f.y) * v_c.xyz, along * cross(v_b.xyz, v_c.xyz)));
#elif SHAPE == SHAPE_BOX
    vec3 x = to_eye * b.xyz, y = to_eye * c.xyz;
    v_b = vec4(x, scale * b.w);
    v_c = vec4(y, scale * c.w);
    reach = scale * length(vec3(a.w, b.w, c.w));
    rectangle = around_box(center, r * x, v_b.w * y, v_c.w * cross(x, y));
#else
    v_b = v_c = vec4(0.0);
    v_tag.zw = uvec2(uint(d.x), uint(d.y) | (d.z != 0.0 ? 0x80000000u : 0u));
    rectangle = around_ball(center, r);
#endif
    v_side = sides == 1 ? 0 : 1 + (gl_InstanceID & 1);
    if (-center.z + reach < near_plane) rectangle = vec4(2.0);
    rectangle += vec4(-0.1, -0.1, 0.1, 0.1) / target.zwzw;
    bool right = (gl_VertexID & 1) != 0, top = (gl_VertexID & 2) != 0;
    gl_Position = vec4(right ? rectangle.z : rectangle.x, top ? rectangle.w : rectangle.y, 0.0, 1.0);
}
