uniform sampler2D coverage;

in vec2 v_at;
flat in vec4 v_colour;

layout(location = 0) out vec4 out_colour;
layout(location = 1) out uint out_id;

void main() {
    out_colour = vec4(v_colour.rgb, v_colour.a * texture(coverage, v_at).r);
    out_id = 0u;
}
