#include "render/draw/segment_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "render/gl/embedded.h"

SCB_DECLARE_EMBEDDED(eye_glsl)
SCB_DECLARE_EMBEDDED(segment_vert)
SCB_DECLARE_EMBEDDED(segment_frag)

namespace scb::render {

namespace {

/// Lines in which surfaces meet are drawn nearer by so many pixels: where two steep surfaces meet,
/// both are in front of the sides of a line.
constexpr double lift_of_meeting_lines = 3;

struct SegmentCorner {
    std::array<float, 3> position;
    Rgba8 color;
    std::uint32_t id;
    float behind;  // the clipping plane, see shaders/segment.frag
};

/// A point on the screen: x, y in pixels of the render target from its middle, the distance from
/// the eye, and how far behind the clipping plane it is, for shaders/segment.frag.
struct ScreenPoint {
    double x, y, depth, behind;
};

ScreenPoint to_screen(const Vec3& eye, const EyeView& view) {
    const double depth = -eye[2], shrunk_by = view.camera.orthographic ? 1 : depth;
    const double divisor = shrunk_by * view.half_height * 2 / view.target.height;
    return {eye[0] / divisor, eye[1] / divisor, depth, behind_clip(view, eye) / shrunk_by};
}

void append(std::vector<SegmentCorner>& corners, const Segment& segment, const EyeView& view) {
    Vec3 a = to_eye_units(view, segment.from), b = to_eye_units(view, segment.to);
    if (a[2] > b[2]) std::swap(a, b);  // a is the farther end
    const double limit = -view.near_plane;
    if (a[2] > limit) return;
    if (b[2] > limit) b = a + (limit - a[2]) / (b[2] - a[2]) * (b - a);

    ScreenPoint p = to_screen(a, view), q = to_screen(b, view);
    if (segment.hidden_color)
        for (ScreenPoint* end : {&p, &q})
            end->depth -= lift_of_meeting_lines * view.scale * view.half_height * 2 /
                          view.target.height * (view.camera.orthographic ? 1 : end->depth);
    const double half = segment.width * view.scale / 2;
    double dx = q.x - p.x, dy = q.y - p.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    // A segment along the view is a dot. The ends extend by half the width, so that joints close.
    dx = length > 0 ? dx / length * half : half;
    dy = length > 0 ? dy / length * half : 0;
    const auto corner = [&](const ScreenPoint& at, double along, double across) {
        const double x = at.x + along * dx - across * dy, y = at.y + along * dy + across * dx;
        corners.push_back(
            {{static_cast<float>(2 * x / view.target.width),
              static_cast<float>(2 * y / view.target.height), static_cast<float>(at.depth)},
             segment.color,
             segment.id,
             static_cast<float>(at.behind)});
    };
    corner(p, -1, -1), corner(q, 1, -1), corner(q, 1, 1);
    corner(p, -1, -1), corner(q, 1, 1), corner(p, -1, 1);
}

}  // namespace

SegmentPainter::SegmentPainter(const Gl& gl)
    : gl_(gl),
      program_(gl, {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(segment_vert)},
               {SCB_EMBEDDED(eye_glsl), SCB_EMBEDDED(segment_frag)}),
      attributes_(gl),
      buffer_(gl) {
    gl_.BindVertexArray(attributes_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    gl_.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(SegmentCorner),
                            buffer_offset(offsetof(SegmentCorner, position)));
    gl_.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(SegmentCorner),
                            buffer_offset(offsetof(SegmentCorner, color)));
    gl_.VertexAttribIPointer(2, 1, GL_UNSIGNED_INT, sizeof(SegmentCorner),
                             buffer_offset(offsetof(SegmentCorner, id)));
    gl_.VertexAttribPointer(3, 1, GL_FLOAT, GL_FALSE, sizeof(SegmentCorner),
                            buffer_offset(offsetof(SegmentCorner, behind)));
    for (GLuint i = 0; i < 4; ++i) gl_.EnableVertexAttribArray(i);
}

void SegmentPainter::draw(const std::vector<Segment>& segments, const EyeView& view) {
    std::vector<SegmentCorner> corners;
    for (const Segment& segment : segments) append(corners, segment, view);
    if (corners.empty()) return;
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(SegmentCorner)),
                   corners.data(), GL_STREAM_DRAW);
    program_.use();
    set_eye_uniforms(program_, view);
    gl_.BindVertexArray(attributes_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}

void SegmentPainter::draw_opaque(const std::vector<Segment>& segments, const EyeView& view) {
    std::vector<Segment> plain;
    for (const Segment& segment : segments)
        if (!segment.on_top && !segment.hidden_color) plain.push_back(segment);
    draw(plain, view);
}

void SegmentPainter::draw_over(const std::vector<Segment>& segments, const EyeView& view) {
    std::vector<Segment> seen, hidden, on_top;
    for (const Segment& segment : segments) {
        if (segment.on_top) {
            on_top.push_back(segment);
        } else if (segment.hidden_color) {
            seen.push_back(segment);
            hidden.push_back(segment);
            hidden.back().color = *segment.hidden_color;
            hidden.back().width = std::min(segment.width, 2.0);
        }
    }
    // Hidden parts are drawn first and do not write depths, so they cover nothing visible.
    gl_.DepthMask(GL_FALSE);
    gl_.DepthFunc(GL_GREATER);
    draw(hidden, view);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_TRUE);
    draw(seen, view);
    gl_.Disable(GL_DEPTH_TEST);
    draw(on_top, view);
    gl_.Enable(GL_DEPTH_TEST);
}

}  // namespace scb::render
