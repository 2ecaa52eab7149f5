uniform vec2 picture_size;

layout(location = 0) in vec2 position;  // pixels from the top left corner
layout(location = 1) in vec2 at;
layout(location = 2) in vec4 color;

out vec2 v_at;
flat out vec4 v_color;

void main() {
    v_at = at;
    v_color = color;
    gl_Position = vec4(2.0 * position / picture_size - 1.0, 0.0, 1.0);
}
