#include "render/draw/overlay_painter.h"

#include <cstddef>

#include "render/gl/embedded.h"
#include "render/overlay/font_face.h"

SCB_DECLARE_EMBEDDED(overlay_vert)
SCB_DECLARE_EMBEDDED(overlay_frag)

namespace scb::render {

namespace {}  // namespace

OverlayPainter::OverlayPainter(const Gl& gl)
    : gl_(gl),
      program_(gl, {SCB_EMBEDDED(overlay_vert)}, {SCB_EMBEDDED(overlay_frag)}),
      attributes_(gl),
      vertices_(gl),
      indices_(gl) {
    gl_.BindVertexArray(attributes_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert),
                            buffer_offset(offsetof(ImDrawVert, pos)));
    gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert),
                            buffer_offset(offsetof(ImDrawVert, uv)));
    gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert),
                            buffer_offset(offsetof(ImDrawVert, col)));
    for (GLuint i = 0; i < 3; ++i) gl_.EnableVertexAttribArray(i);
    const unsigned char white = 255;
    textures_.emplace(0, upload(&white, 1, 1));
}

void OverlayPainter::forget() {
    std::erase_if(textures_, [](const auto& texture) { return texture.first != 0; });
}

GlTexture OverlayPainter::upload(const unsigned char* coverage, int width, int height) const {
    GlTexture texture(gl_);
    gl_.BindTexture(GL_TEXTURE_2D, texture.name());
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, coverage);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

void OverlayPainter::paint(const Overlay& overlay, int width, int height) {
    gl_.ActiveTexture(GL_TEXTURE0);
    for (const FontFace& face : overlay.faces()) {
        if (textures_.contains(face.number)) continue;
        unsigned char* coverage = nullptr;
        int atlas_width = 0, atlas_height = 0;
        face.atlas->GetTexDataAsAlpha8(&coverage, &atlas_width, &atlas_height);
        textures_.emplace(face.number, upload(coverage, atlas_width, atlas_height));
    }

    const ImDrawList& list = overlay.draw_list();
    gl_.BindVertexArray(attributes_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
                   GL_STREAM_DRAW);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                   GL_STREAM_DRAW);
    program_.use();
    program_.set("picture_size", static_cast<float>(width), static_cast<float>(height));
    program_.set("coverage", 0);

    gl_.Viewport(0, 0, width, height);
    gl_.ColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const ImDrawCmd& command : list.CmdBuffer) {
        gl_.BindTexture(GL_TEXTURE_2D,
                        textures_.at(reinterpret_cast<std::uintptr_t>(command.TextureId)).name());
        gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                                   sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                                   buffer_offset(command.IdxOffset * sizeof(ImDrawIdx)),
                                   static_cast<GLint>(command.VtxOffset));
    }
    gl_.Disable(GL_BLEND);
    gl_.ColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace scb::render
