// Two triangles for each side of each volume: its rectangle on the screen. Five texels describe a volume.
uniform usamplerBuffer volumes;
uniform int sides;  // 1: the nearest surface; 2: the back side, then the front, as separate rectangles

flat out vec4 v_a;
flat out vec4 v_b;
flat out vec4 v_c;
flat out uvec4 v_tag;  // color, id; of two slabs also their lower planes
flat out int v_side;   // 0: the nearest surface; 1: the back side; 2: the front side

vec4 texel(int index) { return uintBitsToFloat(texelFetch(volumes, index)); }

void main() {
    int quad = gl_VertexID / 6;
    int corner = gl_VertexID - 6 * quad;
    int base = 5 * (quad / sides);
    v_side = sides == 1 ? 0 : 1 + quad - sides * (quad / sides);

    vec4 rectangle = texel(base);
    v_a = texel(base + 1);
    v_b = texel(base + 2);
    v_c = texel(base + 3);
    v_tag = texelFetch(volumes, base + 4);

    bool right = corner == 1 || corner == 2 || corner == 4;
    bool top = corner == 2 || corner == 4 || corner == 5;
    gl_Position = vec4(right ? rectangle.z : rectangle.x, top ? rectangle.w : rectangle.y, 0.0, 1.0);
}
