#pragma once

#include "render/draw/eye_view.h"
#include "render/gl/gl_program.h"
#include "render/view/picture.h"

namespace scb::render {

/// Draws segments as rectangles that face the viewer (OpenGL's own lines are drawn differently on
/// different CPUs).
class SegmentPainter {
  public:
    explicit SegmentPainter(const Gl& gl);

    /// Draws the segments among opaque things, by depth.
    void draw_opaque(const std::vector<Segment>& segments, const EyeView& view);
    /// Draws the segments that come after translucent things: see Segment::hidden_color,
    /// Segment::on_top.
    void draw_over(const std::vector<Segment>& segments, const EyeView& view);

  private:
    void draw(const std::vector<Segment>& segments, const EyeView& view);

    const Gl& gl_;
    GlProgram program_;
    GlVertexArray attributes_;
    GlBuffer buffer_;
};

}  // namespace scb::render
