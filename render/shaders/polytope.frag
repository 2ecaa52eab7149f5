// Ray-casts a polytope exactly: v_a = center and about half its size; its planes, unit normals and distances from the
// center, are v_tag.w of `plane_at` from v_tag.z on. Edges are drawn unless the highest bit of v_tag.w is set.
void main() {
    vec3 origin, ray;
    eye_ray(origin, ray);
    vec3 to_center = v_a.xyz - origin;
    float closest = dot(to_center, ray);
    vec3 q = closest * ray - to_center;
    int first = int(v_tag.z), count = int(v_tag.w & 0x7fffffffu);

    float entry = -1e30, exit = 1e30;
    int entry_face = 0, exit_face = 0;
    for (int i = 0; i < count; ++i) {
        vec4 face = plane_at(first + i);
        float slope = dot(face.xyz, ray), room = face.w - dot(face.xyz, q);
        if (abs(slope) < 1e-9) {
            if (room < 0.0) discard;
            continue;
        }
        float at = room / slope;
        if (slope < 0.0 && at > entry) {
            entry = at;
            entry_face = i;
        }
        if (slope > 0.0 && at < exit) {
            exit = at;
            exit_face = i;
        }
    }
    float depth;
    bool cut;
    float surface = pick_surface(entry, exit, closest, origin, ray, depth, cut);
    int hit = cut ? -1 : (surface == entry ? entry_face : exit_face);
    vec3 p = q + surface * ray, normal = cut ? clip.xyz : plane_at(first + hit).xyz;
    float size_of_pixel = pixel_size(depth);

    // Edges: near another face, along this one, or the cut. Faces that approximate a curve are
    // edges of a cut.
    float line = cut ? 0.0 : cut_cover(origin + (closest + surface) * ray, normal, ray, size_of_pixel);
    for (int i = 0; i < count; ++i) {
        if (i == hit || (!cut && v_tag.w >= 0x80000000u)) continue;
        vec4 face = plane_at(first + i);
        line = max(line, edge_cover(face.w - dot(face.xyz, p), face.xyz, normal, ray, size_of_pixel));
    }
    line *= smoothstep(2.5 * line_scale, 14.0 * line_scale, v_a.w / size_of_pixel);
    shade(normal, ray, cut ? cut_tone : 1.0, 0.85 * line, depth);
}
