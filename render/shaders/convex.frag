// A triangle of a convex volume's surface: flat, or as smooth as the volume is.
flat in int v_rounded;
in vec3 v_normal;
in vec3 v_eye;

void main() {
    vec3 ray = orthographic != 0 ? vec3(0.0, 0.0, -1.0) : v_eye / sqrt(dot(v_eye, v_eye));
    if (v_side != 0 && gl_FrontFacing != (v_side == 2)) discard;
    vec3 flat_normal = cross(dFdx(v_eye), dFdy(v_eye));
    vec3 normal = v_rounded != 0 ? v_normal : flat_normal;
    float length_squared = dot(normal, normal);
    if (!(length_squared > 0.0)) discard;
    shade(normal / sqrt(length_squared), ray, 1.0, 0.0, -v_eye.z);
}
