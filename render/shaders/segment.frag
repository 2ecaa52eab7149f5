flat in vec4 v_colour;
flat in uint v_id;

layout(location = 0) out vec4 out_colour;
layout(location = 1) out uint out_id;

void main() {
    out_colour = v_colour;
    out_id = v_id;
}
