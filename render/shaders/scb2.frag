// Ray-casts a ball cut by two slabs exactly: v_a = c, r; v_b = first normal, e; v_c = second normal, e; v_tag.zw = the
// two f, as bits. Distances are measured from the point of the ray that is closest to c, as for slab cut balls.
float rim_radius(float r, float k) {
    float rim = sqrt(max(r * r - k * k, 0.0));
    return rim > 1e-3 * r ? rim : 0.0;
}

void main() {
    vec3 c = v_a.xyz;
    float r = v_a.w;
    vec3 n[2] = vec3[2](v_b.xyz, v_c.xyz);
    float e[2] = float[2](v_b.w, v_c.w);
    float f[2] = float[2](uintBitsToFloat(v_tag.z), uintBitsToFloat(v_tag.w));
    vec3 origin, ray;
    eye_ray(origin, ray);

    vec3 to_center = c - origin;
    float closest = dot(to_center, ray);
    vec3 q = closest * ray - to_center;  // from c to the closest point
    float chord = r * r - dot(q, q);
    if (!(chord > 0.0)) discard;
    chord = sqrt(chord);

    float entry = -chord, exit = chord;
    float upper[2], lower[2];
    for (int i = 0; i < 2; ++i) {
        float along = dot(n[i], ray);
        if (abs(along) < 1e-12) along = 1e-12;  // parallel: both planes are far away, or hold the whole ray
        float height = dot(n[i], q);
        upper[i] = (e[i] - height) / along;
        lower[i] = (f[i] - height) / along;
        entry = max(entry, min(upper[i], lower[i]));
        exit = min(exit, max(upper[i], lower[i]));
    }
    float depth;
    bool cut;
    float surface = pick_surface(entry, exit, closest, origin, ray, depth, cut);

    vec3 p = q + surface * ray;  // from c to the surface
    float size_of_pixel = pixel_size(depth);
    int face = surface == upper[0] || surface == lower[0] ? 0 : (surface == upper[1] || surface == lower[1] ? 1 : 2);
    vec3 normal = cut ? clip.xyz : (face == 2 ? p / r : n[face]);

    // The nearer plane of each slab: its rim on the sphere, and where it meets a plane of the other slab.
    float line = 0.0;
    for (int i = 0; i < 2 && !cut; ++i) {
        float height = dot(n[i], p);
        bool at_upper = face == i ? surface == upper[i] : 2.0 * height > e[i] + f[i];
        float plane = at_upper ? e[i] : f[i];
        vec3 radial = p - height * n[i];
        float radius = sqrt(dot(radial, radial));
        if (face == 1 - i) {
            float away = abs(height - plane);
            float edge = line_cover(to_pixels(away, n[i], normal, ray, size_of_pixel), 2.0);
            line = max(line, abs(plane) < r ? edge : 0.0);
            continue;
        }
        float rim = rim_radius(r, plane);
        vec2 offset = vec2(height - plane, radius - rim);
        vec3 direction = face == i ? (radius > 0.0 ? radial / radius : vec3(0.0)) : normal * (height / r) - n[i];
        direction /= max(sqrt(dot(direction, direction)), 1e-6);
        float from_rim = to_pixels(sqrt(dot(offset, offset)), direction, normal, ray, size_of_pixel);
        line = max(line, rim > 0.0 ? line_cover(from_rim, 2.0) : 0.0);
    }

    // The silhouette of the round part.
    float away = (r - sqrt(dot(q, q))) / size_of_pixel;
    if (face == 2) line = max(line, 0.8 * line_cover(away, 1.6));

    // Where the cut meets the planes and the sphere.
    if (cut) {
        line = cut_circle_cover(p, r, ray, size_of_pixel);
        for (int i = 0; i < 2; ++i) {
            float height = dot(n[i], p);
            if (rim_radius(r, e[i]) > 0.0) line = max(line, edge_cover(e[i] - height, n[i], normal, ray, size_of_pixel));
            if (rim_radius(r, f[i]) > 0.0) line = max(line, edge_cover(height - f[i], n[i], normal, ray, size_of_pixel));
        }
    } else {
        line = max(line, cut_cover(origin + (closest + surface) * ray, normal, ray, size_of_pixel));
    }

    line *= smoothstep(2.5 * line_scale, 14.0 * line_scale, r / size_of_pixel);
    shade(normal, ray, cut ? cut_tone : (face == 2 ? 0.94 : 1.12), 0.85 * line, depth);
}
