// A triangle of a rounded volume's surface, as smooth as the volume is.
in vec3 v_normal;
in vec3 v_eye;

void main() {
    vec3 ray = orthographic != 0 ? vec3(0.0, 0.0, -1.0) : v_eye / sqrt(dot(v_eye, v_eye));
    if (is_clipped(v_eye)) discard;
    if (v_side != 0 && gl_FrontFacing != (v_side == 2)) discard;
    shade(v_normal / sqrt(dot(v_normal, v_normal)), ray, 1.0, 0.0, -v_eye.z);
}
