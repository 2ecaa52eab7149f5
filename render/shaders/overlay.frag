uniform sampler2D coverage;

in vec2 v_at;
flat in vec4 v_color;

layout(location = 0) out vec4 out_color;
layout(location = 1) out uint out_id;

void main() {
    out_color = vec4(v_color.rgb, v_color.a * texture(coverage, v_at).r);
    out_id = 0u;
}
