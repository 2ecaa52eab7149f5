#pragma once

#include <cstdint>
#include <map>

#include "render/gl/gl_program.h"
#include "render/overlay/overlay.h"

namespace scb::render {

/// Draws an overlay into the bound framebuffer, whose first row is the top row of the picture.
/// Replaces ImGui's own OpenGL back end, which asks GLX for its functions.
class OverlayPainter {
  public:
    explicit OverlayPainter(const Gl& gl);

    void paint(const Overlay& overlay, int width, int height);
    /// Releases the textures of fonts.
    void forget();

  private:
    GlTexture upload(const unsigned char* coverage, int width, int height) const;

    const Gl& gl_;
    GlProgram program_;
    GlVertexArray attributes_;
    GlBuffer vertices_;
    GlBuffer indices_;
    std::map<std::uintptr_t, GlTexture>
        textures_;  // by the number of the face; 0 is one white pixel
};

}  // namespace scb::render
