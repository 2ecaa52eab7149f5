flat in vec4 v_color;
flat in uint v_id;

layout(location = 0) out vec4 out_color;
layout(location = 1) out uint out_id;

void main() {
    out_color = v_color;
    out_id = v_id;
}
