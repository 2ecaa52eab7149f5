// What the fragment shaders of all volumes share: from a hit to a shaded pixel.
flat in vec4 v_a;
flat in vec4 v_b;
flat in vec4 v_c;
flat in uvec4 v_tag;
flat in int v_side;

layout(location = 0) out vec4 out_color;
layout(location = 1) out uint out_id;

// The ray of this fragment: through `origin`, in the unit direction `direction`.
void eye_ray(out vec3 origin, out vec3 direction) {
    vec2 position = (2.0 * (gl_FragCoord.xy - target.xy) / target.zw - 1.0) * half_view;
    if (orthographic != 0) {
        origin = vec3(position, 0.0);
        direction = vec3(0.0, 0.0, -1.0);
    } else {
        vec3 through = vec3(position, -1.0);
        origin = vec3(0.0);
        direction = through / sqrt(dot(through, through));
    }
}

// Which of two coplanar surfaces is in front must not be left to rounding: the ids decide, for all of a surface.
float nearer_by_id(uint id) { return 1.1e-5 + 1e-6 * float(id & 31u); }

// How many pixels a distance on a surface spans on the screen. `along` is the unit direction in the surface in
// which the distance grows, `normal` the unit normal, `ray` the unit direction of sight. A step of one pixel
// across the ray moves the point where it hits by |along - normal (along.ray)/(normal.ray)| times as much.
float to_pixels(float distance, vec3 along, vec3 normal, vec3 ray, float size_of_pixel) {
    float tilt = min(abs(dot(along, ray)) / max(abs(dot(normal, ray)), 1e-4), 12.0);
    return distance / (size_of_pixel * sqrt(1.0 + tilt * tilt));
}

// Coverage of a line of `width` pixels whose middle is `distance` pixels away.
float line_cover(float distance, float width) {
    return clamp(0.5 * width * line_scale + 0.5 - distance, 0.0, 1.0);
}

// Picks the surface to show from the interval of the ray inside the volume, both relative to `closest` along the
// ray; discards the fragment where there is none.
float pick_surface(float entry, float exit, float closest, float direction_z) {
    if (!(entry <= exit)) discard;
    float nearest = near_plane / -direction_z - closest;  // where the ray crosses the near plane
    float surface = v_side == 1 || (v_side == 0 && entry < nearest) ? exit : entry;
    if (surface < nearest) discard;
    return surface;
}

// `tone` scales the light, `line` is how much of the pixel a dark line covers.
void shade(vec3 normal, vec3 ray, float tone, float line, float depth) {
    if (depth > 1.0) discard;  // behind the far plane
    vec3 facing = dot(normal, ray) > 0.0 ? -normal : normal;
    vec4 color = unpack_color(v_tag.x);
    vec3 base = to_linear(color.rgb);
    vec3 lit = matte(base, facing, tone);
    uint id = v_tag.y & 0x7fffffffu;
    if (id != v_tag.y) lit = striped(lit);
    // Darker than the surface, or lighter where that is too dark to tell.
    float luminance = dot(base, vec3(0.2126, 0.7152, 0.0722));
    vec3 ink = luminance < 0.05 ? mix(base, vec3(1.0), 0.3) : base * 0.16;
    out_color = vec4(to_stored(mix(lit, ink, line)), mix(color.a, min(1.0, color.a + 0.35), line));
    out_id = id;
    gl_FragDepth = buffer_depth(depth, nearer_by_id(id));
}
