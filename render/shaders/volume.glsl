// The common part of the fragment shaders of all volumes: from a hit to a shaded pixel.
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

// Rounding must not decide which of two coplanar surfaces is in front: the ids decide, for a whole
// surface.
float nearer_by_id(uint id) { return 1.1e-5 + 1e-6 * float(id & 31u); }

// The pixels that a distance on a surface spans on the screen. `along` is the unit direction in the
// surface in which the distance grows, `normal` the unit normal, `ray` the unit direction of sight.
// A step of one pixel across the ray moves the point where it hits by |along - normal
// (along.ray)/(normal.ray)| times as much.
float to_pixels(float distance, vec3 along, vec3 normal, vec3 ray, float size_of_pixel) {
    float tilt = min(abs(dot(along, ray)) / max(abs(dot(normal, ray)), 1e-4), 12.0);
    return distance / (size_of_pixel * sqrt(1.0 + tilt * tilt));
}

// Coverage of a line of `width` pixels whose middle is `distance` pixels away.
float line_cover(float distance, float width) {
    return clamp(0.5 * width * line_scale + 0.5 - distance, 0.0, 1.0);
}

// The share of the pixel that is covered by the line in which a surface ends at a plane. The
// surface is `away` from the plane here; both normals are unit vectors.
float edge_cover(float away, vec3 plane, vec3 normal, vec3 ray, float size_of_pixel) {
    float cosine = dot(plane, normal), sine_squared = 1.0 - cosine * cosine;
    if (sine_squared < 1e-4) return 0.0;
    float sine = sqrt(sine_squared);
    float distance = to_pixels(max(away, 0.0) / sine, (plane - cosine * normal) / sine, normal, ray, size_of_pixel);
    return line_cover(distance, 2.0);
}

// The same for the plane that cuts a volume, at a point of the volume's own surface; 0 for the cut
// itself.
float cut_cover(vec3 point, vec3 normal, vec3 ray, float size_of_pixel) {
    return clip.xyz == vec3(0.0) ? 0.0 : edge_cover(behind_clip(point), clip.xyz, normal, ray, size_of_pixel);
}

// The same for the circle in which the cut meets a sphere of radius r; `p` is from its center.
float cut_circle_cover(vec3 p, float r, vec3 ray, float size_of_pixel) {
    float height = dot(clip.xyz, p);
    vec3 radial = p - height * clip.xyz;
    float radius = sqrt(dot(radial, radial));
    float away = max(sqrt(max(r * r - height * height, 0.0)) - radius, 0.0);
    return line_cover(to_pixels(away, radial / max(radius, 1e-30), clip.xyz, ray, size_of_pixel), 2.0);
}

// The tone of a cut: darker than other surfaces with the same light, as in section drawings.
const float cut_tone = 0.86;

// Picks the surface to show from the interval of the ray inside the volume, both relative to
// `closest` along the ray; discards the fragment if there is none. The clipping plane keeps the
// part of the interval behind it; `cut`: the surface is the plane, where the volume was cut open.
// `depth` is the depth of the surface. The depth of the plane is the same for all volumes, as a ray
// has one point in common with it, so that ids alone decide between cuts.
float pick_surface(float entry, float exit, float closest, vec3 origin, vec3 ray, out float depth, out bool cut) {
    if (!(entry <= exit)) discard;
    float slope = dot(clip.xyz, ray), behind = behind_clip(origin), crossing = 0.0;
    bool cut_entry = false, cut_exit = false;
    if (abs(slope) < 1e-9) {
        if (behind < -clip_slack) discard;
        slope = 0.0;
    } else {
        crossing = -behind / slope;
        float at = crossing - closest;
        float slack = clip_slack * (orthographic != 0 ? 1.0 : min(abs(crossing), 1.0));
        cut_entry = slope > 0.0 && (at - entry) * slope > slack;
        cut_exit = slope < 0.0 && (at - exit) * slope > slack;
        if (cut_entry) entry = at;
        if (cut_exit) exit = at;
        if (entry > exit) discard;
    }
    float nearest = near_plane / -ray.z - closest;  // where the ray crosses the near plane
    bool at_exit = v_side == 1 || (v_side == 0 && entry < nearest);
    float surface = at_exit ? exit : entry;
    if (surface < nearest) discard;
    cut = at_exit ? cut_exit : cut_entry;
    float along = closest + surface;
    // Not in front of the plane, where points within the slack would be.
    if (cut || (slope > 0.0 && along < crossing) || (slope < 0.0 && along > crossing)) along = crossing;
    depth = -(origin.z + along * ray.z);
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
