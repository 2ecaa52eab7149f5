// Colors are stored with a gamma of about 2; light adds up linearly. Squares and square roots instead of pow,
// which is not rounded alike everywhere.
vec3 to_linear(vec3 color) { return color * color; }
vec3 to_stored(vec3 light) { return sqrt(clamp(light, 0.0, 1.0)); }

// A surface of this color (linear) whose unit normal faces the viewer, under a key light from the
// viewer's upper left and more light from above than from below. Surfaces that face the key light
// are slightly paler, like matte paint.
vec3 matte(vec3 color, vec3 normal, float tone) {
    const vec3 key = vec3(-0.4364, 0.5455, 0.7155);
    float lit = max(dot(normal, key), 0.0);
    float light = 0.36 + 0.14 * (0.5 + 0.5 * normal.y) + 0.62 * lit;
    return (color * light + 0.03 * lit * lit) * tone;
}

// The light of a hatched surface: two of seven pixels are darker, the others lighter, so that the
// mean color is the same.
vec3 striped(vec3 light) {
    const float dark = 0.45;
    bool in_stripe = mod(floor((gl_FragCoord.x + gl_FragCoord.y) / line_scale), 7.0) < 2.0;
    return light * (in_stripe ? dark : (7.0 - 2.0 * dark) / 5.0);
}

// A color of four bytes, red in the lowest.
vec4 unpack_color(uint word) {
    return vec4(word & 255u, (word >> 8) & 255u, (word >> 16) & 255u, word >> 24) / 255.0;
}
