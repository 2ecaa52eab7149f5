flat in vec4 v_color;
flat in uint v_id;
in float v_depth;
in float v_behind;  // of the middle of the line, the clipping plane; in perspective divided by the distance

layout(location = 0) out vec4 out_color;
layout(location = 1) out uint out_id;

void main() {
    if (v_behind < -clip_slack) discard;
    out_color = v_color;
    out_id = v_id;
    gl_FragDepth = buffer_depth(orthographic != 0 ? v_depth : 1.0 / v_depth, 7e-5);
}
