#include "render/overlay/overlay.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "render/overlay/font_face.h"
#include "render/overlay/overlay_shape.h"

namespace scb::render {

namespace {

ImU32 packed(Rgba8 color) { return IM_COL32(color.r, color.g, color.b, color.a); }

ImVec2 corner(int x, int y) { return {static_cast<float>(x), static_cast<float>(y)}; }

std::vector<ImVec2> converted(std::span<const ScreenPosition> points) {
    std::vector<ImVec2> result;
    for (const ScreenPosition& p : points)
        result.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    return result;
}

/// The texture of plain figures is one white pixel, with a number that no face has.
constexpr ImTextureID white = nullptr;

ImDrawListSharedData plain_drawing() {
    ImDrawListSharedData data;
    data.TexUvWhitePixel = {0.5f, 0.5f};
    data.ClipRectFullscreen = {0, 0, 65536, 65536};
    // No antialiasing by fringes of triangles.
    data.InitialFlags = ImDrawListFlags_AllowVtxOffset;
    return data;
}

}  // namespace

struct Overlay::Parts {
    ImDrawListSharedData shared = plain_drawing();
    ImDrawList list{&shared};
    std::vector<FontFace> faces;
    OverlayShapes* noted = nullptr;

    void note(OverlayShape shape) {
        if (noted != nullptr) noted->list.push_back(std::move(shape));
    }
};

int text_unit(int width, int height) {
    const double reference = std::min<double>(height, width * 9.0 / 16);
    return std::max(13, static_cast<int>(std::lround(20 * reference / 720)));
}

Overlay::Overlay() : parts_(std::make_unique<Parts>()) { begin(); }

Overlay::~Overlay() = default;

void Overlay::begin() {
    parts_->list._ResetForNewFrame();
    parts_->list.PushTextureID(white);
    parts_->list.PushClipRectFullScreen();
    if (parts_->noted != nullptr) parts_->noted->list.clear();
}

OverlayShapes* Overlay::note_in(OverlayShapes* shapes) {
    return std::exchange(parts_->noted, shapes);
}

const FontFace& Overlay::face(const TextStyle& style) {
    for (const FontFace& face : parts_->faces)
        if (face.weight == style.weight && face.size == style.size) return face;
    return parts_->faces.emplace_back(make_font_face(style.weight, style.size));
}

void Overlay::text(int x, int y, std::string_view text, const TextStyle& style) {
    if (text.empty()) return;
    const FontFace& face = this->face(style);
    if (style.align != Align::left) {
        const int width = measure(text, style).width;
        x -= style.align == Align::center ? width / 2 : width;
    }
    if (parts_->noted != nullptr)
        parts_->note(TextShape{x, y, measure(text, style).width, std::string(text), style});
    ImDrawList& list = parts_->list;
    list.PushTextureID(face.atlas->TexID);
    list.AddText(face.font, face.font->FontSize, corner(x, y), packed(style.color), text.data(),
                 text.data() + text.size());
    list.PopTextureID();
}

TextSize Overlay::measure(std::string_view text, const TextStyle& style) {
    const FontFace& face = this->face(style);
    const ImVec2 size =
        face.font->CalcTextSizeA(face.font->FontSize, std::numeric_limits<float>::max(), 0,
                                 text.data(), text.data() + text.size());
    // Descenders of some sizes are rounded into one more row.
    return {static_cast<int>(std::ceil(size.x)), static_cast<int>(std::ceil(size.y)) + 1};
}

void Overlay::rectangle(const PixelRect& r, Rgba8 color) {
    if (r.width <= 0 || r.height <= 0) return;
    parts_->note(RectangleShape{r, color});
    parts_->list.AddRectFilled(corner(r.x, r.y), corner(r.x + r.width, r.y + r.height),
                               packed(color));
}

void Overlay::frame(const PixelRect& r, Rgba8 color, int thickness) {
    rectangle({r.x, r.y, r.width, thickness}, color);
    rectangle({r.x, r.y + r.height - thickness, r.width, thickness}, color);
    rectangle({r.x, r.y + thickness, thickness, r.height - 2 * thickness}, color);
    rectangle({r.x + r.width - thickness, r.y + thickness, thickness, r.height - 2 * thickness},
              color);
}

void Overlay::polyline(std::span<const ScreenPosition> points, Rgba8 color, double thickness) {
    parts_->note(LineShape{{points.begin(), points.end()}, color, thickness});
    const std::vector<ImVec2> line = converted(points);
    parts_->list.AddPolyline(line.data(), static_cast<int>(line.size()), packed(color),
                             ImDrawFlags_None, static_cast<float>(thickness));
}

void Overlay::polygon(std::span<const ScreenPosition> corners, Rgba8 color) {
    parts_->note(PolygonShape{{corners.begin(), corners.end()}, color});
    const std::vector<ImVec2> outline = converted(corners);
    parts_->list.AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()),
                                     packed(color));
}

const ImDrawList& Overlay::draw_list() const { return parts_->list; }

std::span<const FontFace> Overlay::faces() const { return parts_->faces; }

}  // namespace scb::render
