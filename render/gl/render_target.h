#pragma once

#include "render/gl/gl_object.h"

namespace scb::render {

/// A framebuffer of its own: colors (RGBA8), and, for views of a scene, ids (R32UI) and depth (32
/// bits, float).
class RenderTarget {
  public:
    enum class Use { views, overlay };

    /// Throws DrawError if the OpenGL library cannot draw into such a framebuffer.
    RenderTarget(const Gl& gl, int width, int height, Use use);

    int width() const { return width_; }
    int height() const { return height_; }
    GLuint framebuffer() const { return framebuffer_.name(); }
    GLuint colors() const { return colors_.name(); }

  private:
    int width_;
    int height_;
    GlTexture colors_;
    GlTexture ids_;
    GlTexture depth_;
    GlFramebuffer framebuffer_;
};

}  // namespace scb::render
