#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/draw/eye_view.h"
#include "render/gl/gl_program.h"
#include "render/view/picture.h"

namespace scb::render {

/// A corner of a triangle on the screen, for shaders/segment.vert.
struct SegmentCorner {
    std::array<float, 3> position;
    Rgba8 color;
    std::uint32_t id;
    float behind;  ///< the clipping plane, see shaders/segment.frag
};

/// Draws areas, and segments as rectangles that face the viewer (OpenGL's own lines are drawn
/// differently on different CPUs).
class SegmentPainter {
  public:
    explicit SegmentPainter(const Gl& gl);

    /// Draws the segments among opaque things, by depth.
    void draw_opaque(const std::vector<Segment>& segments, const EyeView& view);
    void draw_areas(const std::vector<Area>& areas, const EyeView& view);
    /// Draws the parts of areas that shine through what was drawn, see MeshPainter::draw_hidden.
    void draw_hidden_areas(const std::vector<Area>& areas, const EyeView& view);
    /// Draws the segments that come after translucent things: see Segment::hidden_color,
    /// Segment::on_top.
    void draw_over(const std::vector<Segment>& segments, const EyeView& view);

  private:
    enum class Dashes { none = 0, along_x = 1, along_y = 2 };

    void draw(const std::vector<Segment>& segments, const EyeView& view);
    void draw_dashed(const std::vector<Segment>& segments, const EyeView& view);
    void draw_corners(const EyeView& view, Dashes dashes);

    const Gl& gl_;
    GlProgram program_;
    GlVertexArray attributes_;
    GlBuffer buffer_;
    std::vector<SegmentCorner> corners_;  // for the next call of OpenGL
};

}  // namespace scb::render
