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

    /// Those whose on_top is as given, in their order.
    void draw(const std::vector<Segment>& segments, const EyeView& view, bool on_top);

  private:
    const Gl& gl_;
    GlProgram program_;
    GlVertexArray attributes_;
    GlBuffer buffer_;
};

}  // namespace scb::render
