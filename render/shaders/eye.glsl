// The view of one pane. Eye space: x right, y up, z backward; the far plane is at depth 1.
uniform int orthographic;
uniform vec2 half_view;    // half the view's width and height: at depth 1, or anywhere when orthographic
uniform float near_plane;  // depth of the near plane
uniform vec4 target;       // x, y, width, height of the pane in the render target
uniform float pixel;       // height of a pixel, as half_view
uniform float line_scale;  // render target pixels per pixel of the picture

// Window depth of a point at distance `depth` (> 0) in front of the eye.
float window_depth(float depth) {
    float linear = orthographic != 0 ? depth - near_plane : 1.0 - near_plane / depth;
    return linear / (1.0 - near_plane);
}

// Size of a pixel at that distance.
float pixel_size(float depth) { return orthographic != 0 ? pixel : pixel * depth; }
