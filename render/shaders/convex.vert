// The triangles of each side of each rounded volume: a grid of directions, each at the volume's
// farthest point. Five texels describe a volume; the first four have its frame.
uniform usamplerBuffer volumes;
uniform usamplerBuffer corners;  // of the grid's triangles: numbers of directions
uniform samplerBuffer directions;
uniform samplerBuffer points;    // in eye space
uniform int corners_per_volume;
uniform int points_per_volume;
uniform int sides;  // 1: the nearest surface; 2: the back side, then the front

flat out uvec4 v_tag;
flat out int v_side;
out vec3 v_normal;
out vec3 v_eye;

vec4 texel(int index) { return uintBitsToFloat(texelFetch(volumes, index)); }

void main() {
    int pass = gl_VertexID / corners_per_volume;
    int corner = int(texelFetch(corners, gl_VertexID - corners_per_volume * pass).x);
    int volume = pass / sides;
    v_side = sides == 1 ? 0 : 1 + pass - sides * volume;

    mat3 frame = mat3(texel(5 * volume + 1).xyz, texel(5 * volume + 2).xyz, texel(5 * volume + 3).xyz);
    v_tag = texelFetch(volumes, 5 * volume + 4);
    v_normal = frame * texelFetch(directions, corner).xyz;
    v_eye = texelFetch(points, points_per_volume * int(v_tag.z) + corner).xyz;
    float depth = -v_eye.z;
    float w = orthographic != 0 ? 1.0 : depth;
    gl_Position = vec4(v_eye.xy / half_view, 2.0 * (depth - near_plane) / (1.0 - near_plane) - w, w);
}
