// Ray-casts an oriented box exactly: v_a = center, half length 0; v_b = axis 0, half length 1; v_c = axis 1, half
// length 2. Distances are measured from the point of the ray that is closest to the center, as for slab cut balls.
void main() {
    mat3 axes = mat3(v_b.xyz, v_c.xyz, cross(v_b.xyz, v_c.xyz));
    vec3 h = vec3(v_a.w, v_b.w, v_c.w);
    vec3 origin, ray;
    eye_ray(origin, ray);

    vec3 to_center = v_a.xyz - origin;
    float closest = dot(to_center, ray);
    vec3 q = (closest * ray - to_center) * axes;  // in the box's frame
    vec3 d = ray * axes;
    vec3 along = vec3(abs(d.x) < 1e-12 ? 1e-12 : d.x, abs(d.y) < 1e-12 ? 1e-12 : d.y, abs(d.z) < 1e-12 ? 1e-12 : d.z);
    vec3 upper = (h - q) / along;
    vec3 lower = (-h - q) / along;
    vec3 near_faces = min(upper, lower), far_faces = max(upper, lower);
    float entry = max(near_faces.x, max(near_faces.y, near_faces.z));
    float exit = min(far_faces.x, min(far_faces.y, far_faces.z));
    float depth;
    bool cut;
    float surface = pick_surface(entry, exit, closest, origin, ray, depth, cut);

    vec3 p = q + surface * d;
    float size_of_pixel = pixel_size(depth);
    vec3 faces = surface == entry ? near_faces : far_faces;
    int face = cut ? -1 : (faces.x == surface ? 0 : (faces.y == surface ? 1 : 2));
    vec3 normal = vec3(face == 0 ? 1.0 : 0.0, face == 1 ? 1.0 : 0.0, face == 2 ? 1.0 : 0.0);
    if (cut) normal = clip.xyz * axes;

    // Edges: near another pair of faces, or the cut.
    float line = cut ? 0.0 : cut_cover(origin + (closest + surface) * ray, axes * normal, ray, size_of_pixel);
    for (int i = 0; i < 3; ++i) {
        if (i == face) continue;
        vec3 direction = vec3(i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0);
        line = max(line, edge_cover(h[i] - abs(p[i]), direction, normal, d, size_of_pixel));
    }
    float radius_in_pixels = sqrt(dot(h, h)) / size_of_pixel;
    line *= smoothstep(2.5 * line_scale, 14.0 * line_scale, radius_in_pixels);
    shade(cut ? clip.xyz : axes * normal, ray, cut ? cut_tone : 1.0, 0.85 * line, depth);
}
