// Ray-casts a slab cut ball exactly: v_a = c, r; v_b = n, e; v_c = f, the
// radii of the two rims (0 where there is none), 1 / r. A ball has e = r, f = -r.
//
// All distances are measured from the point of the ray that is closest to c, so their rounding errors are of the
// size of the ball, not of the distance to it; and both planes of a disc (e == f) are hit at the same float.
void main() {
    vec3 c = v_a.xyz, n = v_b.xyz;
    float r = v_a.w, e = v_b.w, f = v_c.x;
    vec3 origin, ray;
    eye_ray(origin, ray);

    vec3 to_center = c - origin;
    float closest = dot(to_center, ray);
    vec3 q = closest * ray - to_center;  // from c to the closest point
    float chord = r * r - dot(q, q);
    if (!(chord > 0.0)) discard;
    chord = sqrt(chord);

    float along = dot(n, ray);
    if (abs(along) < 1e-12) along = 1e-12;  // parallel to the planes: both are far away, or hold the whole ray
    float height = dot(n, q);
    float upper = (e - height) / along;
    float lower = (f - height) / along;
    float entry = max(-chord, min(upper, lower));
    float exit = min(chord, max(upper, lower));
    float depth;
    bool cut;
    float surface = pick_surface(entry, exit, closest, origin, ray, depth, cut);

    bool on_cap = surface == upper || surface == lower;
    vec3 p = q + surface * ray;  // from c to the surface
    float size_of_pixel = pixel_size(depth);
    float p_height = dot(n, p);
    vec3 p_radial = p - p_height * n;
    float p_radius = sqrt(dot(p_radial, p_radial));
    vec3 outward = p_radius > 0.0 ? p_radial / p_radius : vec3(0.0);
    vec3 normal = cut ? clip.xyz : (on_cap ? n : p * v_c.w);

    // The nearer rim: the circle in which a plane meets the sphere.
    bool at_upper = on_cap ? surface == upper : 2.0 * p_height > e + f;
    float rim_height = at_upper ? e : f;
    float rim_radius = at_upper ? v_c.y : v_c.z;
    vec2 offset = vec2(p_height - rim_height, p_radius - rim_radius);
    vec3 direction = on_cap ? outward : normal * (p_height * v_c.w) - n;
    direction /= max(sqrt(dot(direction, direction)), 1e-6);
    float from_rim = to_pixels(sqrt(dot(offset, offset)), direction, normal, ray, size_of_pixel);
    float line = rim_radius > 0.0 ? line_cover(from_rim, 2.0) : 0.0;

    // The silhouette of the round part.
    float away = (r - sqrt(dot(q, q))) / size_of_pixel;
    if (!on_cap) line = max(line, 0.8 * line_cover(away, 1.6));

    // Where the cut meets the planes and the sphere.
    if (cut) {
        line = cut_circle_cover(p, r, ray, size_of_pixel);
        if (v_c.y > 0.0) line = max(line, edge_cover(e - p_height, n, normal, ray, size_of_pixel));
        if (v_c.z > 0.0) line = max(line, edge_cover(p_height - f, n, normal, ray, size_of_pixel));
    } else {
        line = max(line, cut_cover(origin + (closest + surface) * ray, normal, ray, size_of_pixel));
    }

    line *= smoothstep(2.5 * line_scale, 14.0 * line_scale, r / size_of_pixel);
    shade(normal, ray, cut ? cut_tone : (on_cap ? 1.12 : 0.94), 0.85 * line, depth);
}
