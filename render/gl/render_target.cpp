#include "render/gl/render_target.h"

#include <cstdint>
#include <string>

#include "render/gl/context.h"

namespace scb::render {

namespace {

void attach(const Gl& gl, GLuint texture, GLenum attachment, GLint internal, GLenum format,
            GLenum type, int width, int height) {
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
}

}  // namespace

RenderTarget::RenderTarget(const Gl& gl, int width, int height, Use use)
    : width_(width), height_(height), colors_(gl), ids_(gl), depth_(gl), framebuffer_(gl) {
    // Twelve for drawing, and twelve for reading back and encoding.
    constexpr std::uint64_t bytes_per_pixel = 24;
    require_address_space(bytes_per_pixel * static_cast<std::uint64_t>(width) *
                          static_cast<std::uint64_t>(height));
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    attach(gl, colors_.name(), GL_COLOR_ATTACHMENT0, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width,
           height);
    const GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl.DrawBuffers(use == Use::views ? 2 : 1, attachments);
    if (use == Use::views) {
        attach(gl, ids_.name(), GL_COLOR_ATTACHMENT1, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT,
               width, height);
        attach(gl, depth_.name(), GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT,
               GL_FLOAT, width, height);
    }
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw DrawError("The OpenGL library cannot draw colors and ids into a framebuffer of " +
                        std::to_string(width) + " x " + std::to_string(height) +
                        " pixels; choose a smaller --size.");
}

}  // namespace scb::render
