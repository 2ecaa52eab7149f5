#include "render/draw/renderer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <string>
#include <utility>

#include "render/draw/eye_view.h"
#include "render/draw/image_operations.h"
#include "render/draw/mesh_painter.h"
#include "render/draw/overlay_painter.h"
#include "render/draw/segment_painter.h"
#include "render/draw/volume_painter.h"
#include "render/gl/context_platform.h"
#include "render/gl/render_target.h"
#include "scb/error.h"

namespace scb::render {

namespace {

// Rows of a picture read back at a time: few enough that their samples stay in the cache.
constexpr int rows_at_a_time = 16;

// Panes of pictures with more samples are drawn one by one. A picture of 1280x720 pixels with 4
// samples has fewer.
constexpr std::int64_t most_samples_at_once = 4'000'000;

/// The largest side of a render target.
int largest_side(const Gl& gl) {
    std::array<GLint, 2> viewport{};
    GLint texture = 0;
    gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    return std::min({viewport[0], viewport[1], texture});
}

/// Render target pixels per pixel of the picture, in x and y.
int scale_of(int samples) { return samples == 4 ? 2 : 1; }

std::string size_text(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

void check(const Picture& picture, int limit) {
    const int w = picture.width, h = picture.height;
    if (picture.samples != 1 && picture.samples != 4)
        throw InputError("A picture has 1 or 4 samples a pixel, not " +
                         std::to_string(picture.samples) + ".");
    if (w < 1 || h < 1)
        throw InputError("A picture of " + size_text(w, h) + " pixels is empty; give it a size.");
    if (w > limit || h > limit)
        throw InputError("A picture of " + size_text(w, h) + " pixels is too large; with " +
                         std::to_string(picture.samples) +
                         " samples a pixel no side may be longer than " + std::to_string(limit) +
                         " pixels.");
    for (const Pane& pane : picture.panes) {
        const PixelRect& v = pane.viewport;
        // Subtracted, not added: the sum of two large numbers would overflow.
        if (v.x < 0 || v.y < 0 || v.width < 1 || v.height < 1 || v.width > w - v.x ||
            v.height > h - v.y)
            throw InputError("A pane of " + size_text(v.width, v.height) + " pixels at (" +
                             std::to_string(v.x) + ", " + std::to_string(v.y) +
                             ") does not lie inside the picture of " + size_text(w, h) + ".");
    }
}

void clear(const Gl& gl, Rgba8 background) {
    const auto channel = [](std::uint8_t value) { return static_cast<float>(value) / 255; };
    const std::array<float, 4> color{channel(background.r), channel(background.g),
                                     channel(background.b), 1};
    const std::array<GLuint, 4> no_id{};
    const float far_depth = 1;
    gl.ClearBufferfv(GL_COLOR, 0, color.data());
    gl.ClearBufferuiv(GL_COLOR, 1, no_id.data());
    gl.ClearBufferfv(GL_DEPTH, 0, &far_depth);
}

void fill(Image& image, Rgba8 color) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        std::memcpy(&image.rgba[i],
                    std::array<std::uint8_t, 4>{color.r, color.g, color.b, 255}.data(), 4);
}

bool has_translucent(const Pane& pane) {
    return std::any_of(pane.volumes.begin(), pane.volumes.end(),
                       [](const VolumeInstance& v) { return v.color.a > 0 && v.color.a < 255; });
}

bool has_meeting_lines(const Pane& pane) {
    return std::any_of(pane.segments.begin(), pane.segments.end(),
                       [](const Segment& segment) { return segment.hidden_color.has_value(); });
}

}  // namespace

struct Renderer::Parts {
    ContextPlatform& platform;
    const Gl& gl;
    int exceptions = 0;  // in flight when the renderer was made
    int limit;
    MeshPainter meshes;
    VolumePainter volumes;
    SegmentPainter segments;
    OverlayPainter overlay;
    std::optional<RenderTarget> drawn;     // at the resolution of the samples
    std::optional<RenderTarget> overlaid;  // at the resolution of the picture, top row first: for
                                           // the overlay
    std::vector<std::uint32_t> samples;    // this and `row` are kept to reuse their memory
    std::vector<std::uint32_t> row;

    explicit Parts(ContextPlatform& context)
        : platform(context),
          gl(platform.gl),
          limit(largest_side(gl)),
          meshes(gl),
          volumes(gl),
          segments(gl),
          overlay(gl) {}

    /// Forgets everything except the shaders.
    void forget() {
        meshes.forget();
        overlay.forget();
        drawn.reset();
        overlaid.reset();
    }

    void fit_target(std::optional<RenderTarget>& target, int width, int height,
                    RenderTarget::Use use) {
        if (target && target->width() == width && target->height() == height) return;
        target.reset();
        target.emplace(gl, width, height, use);
    }

    void clear_depth() {
        const float far_depth = 1;
        gl.ClearBufferfv(GL_DEPTH, 0, &far_depth);
    }

    void draw_meshes(const Pane& pane, const EyeView& view, Rgba8 background, bool backdrop) {
        for (const MeshDraw& mesh : pane.meshes)
            if (mesh.backdrop == backdrop) meshes.draw(mesh, view, background);
    }

    void draw_backdrop(const Pane& pane, const EyeView& view, Rgba8 background) {
        if (std::none_of(pane.meshes.begin(), pane.meshes.end(),
                         [](const MeshDraw& mesh) { return mesh.backdrop; }))
            return;
        gl.ColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        draw_meshes(pane, view, background, true);
        gl.ColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        clear_depth();
    }

    /// Draws the hidden parts of things that shine through, then their visible parts over these.
    void draw_hidden(const Pane& pane, const EyeView& view, Rgba8 background) {
        std::vector<const MeshDraw*> shining;
        for (const MeshDraw& mesh : pane.meshes)
            if (mesh.shine_through > 0 && !mesh.backdrop) shining.push_back(&mesh);
        if (shining.empty() && pane.areas.empty()) return;
        gl.DepthMask(GL_FALSE);
        gl.ColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        gl.Enable(GL_BLEND);
        gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        gl.DepthFunc(GL_GREATER);
        for (const MeshDraw* mesh : shining) meshes.draw_hidden(*mesh, view, background);
        segments.draw_hidden_areas(pane.areas, view);
        gl.Disable(GL_BLEND);
        gl.DepthFunc(GL_LEQUAL);
        for (const MeshDraw* mesh : shining) meshes.draw(*mesh, view, background);
        segments.draw_areas(pane.areas, view);
        gl.DepthFunc(GL_LESS);
        gl.ColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl.DepthMask(GL_TRUE);
    }

    void draw_pane(const Pane& pane, const PixelRect& part, bool first, Rgba8 of_picture,
                   int scale) {
        const EyeView view = make_eye_view(pane, part, scale);
        const Rgba8 background = pane.background.value_or(of_picture);
        gl.Viewport(view.target.x, view.target.y, view.target.width, view.target.height);
        gl.Scissor(view.target.x, view.target.y, view.target.width, view.target.height);
        // The first pane is clear already if it has the picture's background. (A clear with a
        // scissor is not free: it draws quads.)
        if (!first || background != of_picture) clear(gl, background);
        draw_backdrop(pane, view, background);
        draw_meshes(pane, view, background, false);
        volumes.draw_opaque(pane.volumes, view);
        segments.draw_areas(pane.areas, view);
        segments.draw_opaque(pane.segments, view);
        draw_hidden(pane, view, background);
        volumes.draw_translucent(pane.volumes, view);
        // Only opaque surfaces hide lines in which surfaces meet.
        if (has_translucent(pane) && has_meeting_lines(pane)) {
            clear_depth();
            for (const GLuint buffer : {0u, 1u})
                gl.ColorMaski(buffer, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
            draw_meshes(pane, view, background, false);
            volumes.draw_opaque(pane.volumes, view);
            segments.draw_areas(pane.areas, view);
            for (const GLuint buffer : {0u, 1u})
                gl.ColorMaski(buffer, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        }
        segments.draw_over(pane.segments, view);
    }

    /// Resolves an attachment of `drawn` row by row, from the top, into the rectangle `part` of
    /// `pixels`, 4 bytes each, in rows of `width` pixels. A shader would take a fifth of the
    /// processor time of a whole picture on llvmpipe.
    template <typename Resolve>
    void read_resolved(GLenum attachment, GLenum format, GLenum type, int scale,
                       const PixelRect& part, int width, void* pixels, Resolve resolve) {
        const std::size_t words = static_cast<std::size_t>(scale) *
                                  static_cast<std::size_t>(scale * part.width);  // per row
        samples.resize(rows_at_a_time * words);
        row.resize(static_cast<std::size_t>(part.width));
        gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
        gl.ReadBuffer(attachment);
        for (int top = 0; top < part.height; top += rows_at_a_time) {
            const int rows = std::min(rows_at_a_time, part.height - top);
            gl.ReadPixels(0, scale * (part.height - top - rows), scale * part.width, scale * rows,
                          format, type, samples.data());
            for (int i = 0; i < rows; ++i) {
                resolve(samples.data() + static_cast<std::size_t>(rows - 1 - i) * words, scale,
                        row);
                const std::size_t at =
                    static_cast<std::size_t>(part.y + top + i) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(part.x);
                std::memcpy(static_cast<std::uint8_t*>(pixels) + 4 * at, row.data(),
                            4 * row.size());
            }
        }
    }

    /// Draws the panes, and reads them back into the part of the picture.
    void draw_part(const PixelRect& part, std::span<const Pane> panes, Rgba8 background, int scale,
                   Rendering& result) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, drawn->framebuffer());
        gl.Disable(GL_SCISSOR_TEST);
        clear(gl, background);
        gl.Enable(GL_SCISSOR_TEST);
        gl.Enable(GL_DEPTH_TEST);
        gl.DepthFunc(GL_LESS);
        for (const Pane& pane : panes) {
            const bool first = &pane == panes.data();
            if (!pane.add_contents) {
                draw_pane(pane, part, first, background, scale);
                continue;
            }
            Pane whole = pane;
            pane.add_contents(whole);
            draw_pane(whole, part, first, background, scale);
        }
        gl.Disable(GL_DEPTH_TEST);
        gl.Disable(GL_SCISSOR_TEST);
        read_resolved(GL_COLOR_ATTACHMENT0, GL_RGBA, GL_UNSIGNED_BYTE, scale, part,
                      result.image.width, result.image.rgba.data(), resolve_colors);
        if (result.ids)
            read_resolved(GL_COLOR_ATTACHMENT1, GL_RED_INTEGER, GL_UNSIGNED_INT, scale, part,
                          result.image.width, result.ids->ids.data(), resolve_ids);
    }

    /// Draws all panes at once, or, of large pictures of several panes, each by itself: a sheet of
    /// 3840x2160 pixels with 4 samples would take 400 MB.
    void draw_panes(const Picture& picture, int scale, Rendering& result) {
        const std::vector<Pane>& panes = picture.panes;
        const PixelRect whole{0, 0, picture.width, picture.height};
        const bool each = panes.size() > 1 && static_cast<std::int64_t>(scale * picture.width) *
                                                      (scale * picture.height) >
                                                  most_samples_at_once;
        PixelRect largest = whole;
        if (each) {
            largest = {};
            for (const Pane& pane : panes) {
                largest.width = std::max(largest.width, pane.viewport.width);
                largest.height = std::max(largest.height, pane.viewport.height);
            }
        }
        fit_target(drawn, scale * largest.width, scale * largest.height, RenderTarget::Use::views);
        if (!each) return draw_part(whole, panes, picture.background, scale, result);
        fill(result.image, picture.background);
        for (const Pane& pane : panes)
            draw_part(pane.viewport, {&pane, 1}, picture.background, scale, result);
    }

    void paint_over(Image& image, const Overlay& figures) {
        fit_target(overlaid, image.width, image.height, RenderTarget::Use::overlay);
        gl.BindTexture(GL_TEXTURE_2D, overlaid->colors());
        gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA,
                         GL_UNSIGNED_BYTE, image.rgba.data());
        gl.BindFramebuffer(GL_FRAMEBUFFER, overlaid->framebuffer());
        overlay.paint(figures, image.width, image.height);
        gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
        gl.ReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      image.rgba.data());
    }
};

Renderer::Renderer(const Context& context) {
    ContextPlatform& platform = context.platform();
    if (platform.kept_for_renderer != nullptr)
        parts_.reset(static_cast<Parts*>(std::exchange(platform.kept_for_renderer, nullptr)));
    else
        parts_ = std::make_unique<Parts>(platform);
    parts_->exceptions = std::uncaught_exceptions();
}

Renderer::~Renderer() {
    ContextPlatform& platform = parts_->platform;
    // The exception may come from OpenGL.
    platform.failed |= std::uncaught_exceptions() > parts_->exceptions;
    if (platform.failed || platform.kept_for_renderer != nullptr) return;
    parts_->forget();
    platform.kept_for_renderer = parts_.release();
}

MeshHandle Renderer::upload(const Mesh& mesh) { return parts_->meshes.upload(mesh); }

void Renderer::release(MeshHandle handle) { parts_->meshes.release(handle); }

int Renderer::largest_size(int samples) const { return parts_->limit / scale_of(samples); }

Rendering Renderer::draw(const Picture& picture, const Overlay* overlay, bool with_ids) {
    const Gl& gl = parts_->gl;
    const int scale = scale_of(picture.samples);
    check(picture, largest_size(picture.samples));
    const bool outlined = std::any_of(picture.panes.begin(), picture.panes.end(),
                                      [](const Pane& pane) { return !pane.outline.ids.empty(); });
    const std::size_t pixels =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    Rendering result{{picture.width, picture.height, std::vector<std::uint8_t>(4 * pixels)}, {}};
    if (with_ids || outlined)
        result.ids = IdImage{picture.width, picture.height, std::vector<std::uint32_t>(pixels)};
    parts_->draw_panes(picture, scale, result);
    for (const Pane& pane : picture.panes)
        if (!pane.outline.ids.empty())
            draw_outline(result.image, *result.ids, pane.viewport, pane.outline);
    if (!with_ids) result.ids.reset();
    if (overlay) parts_->paint_over(result.image, *overlay);
    if (gl.GetError() != GL_NO_ERROR)
        throw DrawError("The OpenGL library could not draw a picture of " +
                        size_text(picture.width, picture.height) +
                        " pixels; it may be out of memory.");
    return result;
}

}  // namespace scb::render
