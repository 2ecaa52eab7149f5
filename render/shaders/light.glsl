// Colours are stored with a gamma of about 2; light adds up linearly. Squares and square roots instead of pow,
// which is not rounded alike everywhere.
vec3 to_linear(vec3 colour) { return colour * colour; }
vec3 to_stored(vec3 light) { return sqrt(clamp(light, 0.0, 1.0)); }

// Matte light of a surface whose unit normal faces the viewer: a key light from the viewer's upper left, and more
// from above than from below. About 0.35 to 1.05.
float matte_light(vec3 normal) {
    const vec3 key = vec3(-0.4364, 0.5455, 0.7155);
    float lit = max(dot(normal, key), 0.0);
    return 0.34 + 0.12 * (0.5 + 0.5 * normal.y) + 0.60 * lit;
}

// A colour of four bytes, red in the lowest.
vec4 unpack_colour(uint word) {
    return vec4(word & 255u, (word >> 8) & 255u, (word >> 16) & 255u, word >> 24) / 255.0;
}
