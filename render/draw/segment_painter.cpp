#include "render/draw/segment_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "render/gl/embedded.h"
#include "render/view/palette.h"

SCB_DECLARE_EMBEDDED(eye_glsl)
SCB_DECLARE_EMBEDDED(segment_vert)
SCB_DECLARE_EMBEDDED(segment_frag)

namespace scb::render {

namespace {

/// Lines in which surfaces meet are drawn nearer by so many pixels: where two steep surfaces meet,
/// both are in front of the sides of a line.
constexpr double lift_of_meeting_lines = 3;
/// The shader draws segments nearer by 70 millionths of their distance, and areas by half of that;
/// hidden areas by enough to be in front of all surfaces that coincide with them.
constexpr double area_is_farther = 3.5e-5, hidden_area_is_farther = -1.3e-4;

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

SegmentCorner corner_of(const ScreenPoint& at, Rgba8 color, std::uint32_t id, const EyeView& view) {
    return {{static_cast<float>(2 * at.x / view.target.width),
             static_cast<float>(2 * at.y / view.target.height), static_cast<float>(at.depth)},
            color,
            id,
            static_cast<float>(at.behind)};
}

/// The ends on the screen, without the part behind the near plane; none if nothing is left.
std::optional<std::array<ScreenPoint, 2>> ends_on_screen(const Segment& segment,
                                                         const EyeView& view) {
    Vec3 a = to_eye_units(view, segment.from), b = to_eye_units(view, segment.to);
    if (a[2] > b[2]) std::swap(a, b);  // a is the farther end
    const double limit = -view.near_plane;
    if (a[2] > limit) return std::nullopt;
    if (b[2] > limit) b = a + (limit - a[2]) / (b[2] - a[2]) * (b - a);

    return std::array{to_screen(a, view), to_screen(b, view)};
}

void append(std::vector<SegmentCorner>& corners, const Segment& segment, const EyeView& view) {
    const auto ends = ends_on_screen(segment, view);
    if (!ends) return;
    auto [p, q] = *ends;
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
        ScreenPoint moved = at;
        moved.x += along * dx - across * dy;
        moved.y += along * dy + across * dx;
        corners.push_back(corner_of(moved, segment.color, segment.id, view));
    };
    corner(p, -1, -1), corner(q, 1, -1), corner(q, 1, 1);
    corner(p, -1, -1), corner(q, 1, 1), corner(p, -1, 1);
}

/// The part of a polygon in eye units that is not behind the near plane.
std::vector<Vec3> in_front(const std::vector<Vec3>& polygon, double limit) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        if (p[2] <= limit) kept.push_back(p);
        if ((p[2] <= limit) != (q[2] <= limit))
            kept.emplace_back(p + (limit - p[2]) / (q[2] - p[2]) * (q - p));
    }
    return kept;
}

void append(std::vector<SegmentCorner>& corners, const Area& area, const EyeView& view, Rgba8 color,
            double farther) {
    std::vector<Vec3> polygon;
    for (const Vec3& corner : area.corners) polygon.push_back(to_eye_units(view, corner));
    polygon = in_front(polygon, -view.near_plane);
    std::vector<SegmentCorner> on_screen;
    for (const Vec3& corner : polygon) {
        ScreenPoint at = to_screen(corner, view);
        at.depth *= 1 + farther;
        on_screen.push_back(corner_of(at, color, area.id, view));
    }
    for (std::size_t i = 2; i < on_screen.size(); ++i)
        corners.insert(corners.end(), {on_screen[0], on_screen[i - 1], on_screen[i]});
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

void SegmentPainter::draw_corners(const EyeView& view, Dashes dashes) {
    if (corners_.empty()) return;
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    gl_.BufferData(GL_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(corners_.size() * sizeof(SegmentCorner)),
                   corners_.data(), GL_STREAM_DRAW);
    program_.use();
    set_eye_uniforms(program_, view);
    program_.set("dashed", static_cast<int>(dashes));
    gl_.BindVertexArray(attributes_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
    corners_.clear();
}

void SegmentPainter::draw(const std::vector<Segment>& segments, const EyeView& view) {
    for (const Segment& segment : segments) append(corners_, segment, view);
    draw_corners(view, Dashes::none);
}

void SegmentPainter::draw_dashed(const std::vector<Segment>& segments, const EyeView& view) {
    // Dashes follow the steeper axis of the screen, so that they continue from segment to segment.
    for (const Dashes dashes : {Dashes::along_x, Dashes::along_y}) {
        for (const Segment& segment : segments) {
            const auto ends = ends_on_screen(segment, view);
            if (!ends) continue;
            const bool along_x =
                std::abs((*ends)[1].x - (*ends)[0].x) >= std::abs((*ends)[1].y - (*ends)[0].y);
            if (along_x == (dashes == Dashes::along_x)) append(corners_, segment, view);
        }
        draw_corners(view, dashes);
    }
}

void SegmentPainter::draw_areas(const std::vector<Area>& areas, const EyeView& view) {
    for (const Area& area : areas) append(corners_, area, view, area.color, area_is_farther);
    draw_corners(view, Dashes::none);
}

void SegmentPainter::draw_hidden_areas(const std::vector<Area>& areas, const EyeView& view) {
    for (const Area& area : areas)
        if (area.shine_through > 0)
            append(corners_, area, view, with_opacity(area.color, area.shine_through),
                   hidden_area_is_farther);
    draw_corners(view, Dashes::none);
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
            hidden.back().width = std::min(segment.width, 1.5);
        }
    }
    // Hidden parts are drawn first and do not write depths, so they cover nothing visible.
    gl_.DepthMask(GL_FALSE);
    gl_.DepthFunc(GL_GREATER);
    draw_dashed(hidden, view);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_TRUE);
    draw(seen, view);
    gl_.Disable(GL_DEPTH_TEST);
    draw(on_top, view);
    gl_.Enable(GL_DEPTH_TEST);
}

}  // namespace scb::render
