uniform int edges;
uniform int hatched;
uniform uint first_id;
uniform float shading;  // 0: no light and shade
uniform vec4 fade;  // a color, and how far to fade into it
uniform float transparency;
uniform float nearer;  // see buffer_depth

flat in vec3 v_normal;
flat in vec4 v_color;
flat in uint v_triangle;
in vec3 v_corner;
in vec3 v_eye;

layout(location = 0) out vec4 out_color;
layout(location = 1) out uint out_id;

void main() {
    vec3 ray = orthographic != 0 ? vec3(0.0, 0.0, -1.0) : v_eye;
    vec3 facing = dot(v_normal, ray) > 0.0 ? -v_normal : v_normal;
    vec3 base = to_linear(v_color.rgb);
    vec3 lit = mix(base, matte(base, facing, 1.0), shading);
    if (edges != 0) {
        vec3 per_pixel = max(fwidth(v_corner), vec3(1e-9));
        vec3 away = v_corner / per_pixel;
        vec3 cover = clamp(0.45 * line_scale + 0.5 - away, 0.0, 1.0);
        // The triangle's heights in pixels are 1 / per_pixel: a mesh finer than the lines would only turn black.
        float finest = 1.0 / max(per_pixel.x, max(per_pixel.y, per_pixel.z));
        float strength = smoothstep(2.0 * line_scale, 10.0 * line_scale, finest);
        lit = mix(lit, base * 0.2, 0.7 * strength * max(cover.x, max(cover.y, cover.z)));
    }
    if (is_clipped(v_eye)) discard;  // not before the derivatives
    if (hatched != 0) lit = striped(lit);
    out_color = vec4(mix(to_stored(lit), fade.rgb, fade.a), 1.0 - transparency);
    gl_FragDepth = buffer_depth(-v_eye.z, nearer);
    out_id = first_id == 0u ? 0u : first_id + v_triangle;
}
