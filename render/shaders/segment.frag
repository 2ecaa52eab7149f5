flat in vec4 v_color;
flat in uint v_id;
in float v_depth;
uniform int dashed;  // 0: not; 1: along x; 2: along y

in float v_behind;  // of the middle of the line, the clipping plane; in perspective divided by the distance

layout(location = 0) out vec4 out_color;
layout(location = 1) out uint out_id;

void main() {
    if (v_behind < -clip_slack) discard;
    if (dashed != 0 && fract((dashed == 1 ? gl_FragCoord.x : gl_FragCoord.y) / (8.0 * line_scale)) > 0.625) discard;
    out_color = v_color;
    out_id = v_id;
    gl_FragDepth = buffer_depth(orthographic != 0 ? v_depth : 1.0 / v_depth, 7e-5);
}
