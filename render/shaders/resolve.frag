// Averages blocks of scale x scale pixels and turns the picture upside down, so that its first row is the top one.
uniform sampler2D colors;
uniform usampler2D ids;
uniform int scale;
uniform int last_row;  // of the render target

layout(location = 0) out vec4 out_color;
layout(location = 1) out uint out_id;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 top_left = ivec2(scale * pixel.x, last_row - scale * pixel.y);
    ivec3 sum = ivec3(0);
    for (int y = 0; y < scale; ++y)
        for (int x = 0; x < scale; ++x)
            sum += ivec3(texelFetch(colors, top_left + ivec2(x, -y), 0).rgb * 255.0 + 0.5);
    // Whole numbers, so that the rounding is the same everywhere.
    int count = scale * scale;
    ivec3 mean = (sum + count / 2) / count;
    out_color = vec4(vec3(mean) / 255.0, 1.0);
    out_id = texelFetch(ids, top_left, 0).x;
}
