#include "render/overlay/overlay_shape.h"

#include <array>
#include <string_view>

#include "core/base/text_format.h"
#include "core/platform/base64.h"
#include "render/files/image_file.h"
#include "render/overlay/font_face.h"

namespace scb::render {
namespace {

// The extents of Roboto above and below the base line, in units of its size.
constexpr double ascent = 0.927734375, descent = 0.244140625;

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        constexpr std::string_view special = "&<>\"";
        constexpr std::array names = {"&amp;", "&lt;", "&gt;", "&quot;"};
        const std::size_t i = special.find(c);
        if (i != std::string_view::npos) result += names[i];
        // XML allows no other control characters.
        if (i == std::string_view::npos && static_cast<unsigned char>(c) >= 0x20) result += c;
    }
    return result;
}

/// `use`: "fill" or "stroke".
std::string paint(const char* use, Rgba8 color) {
    std::string text = format(" %s=\"#%02x%02x%02x\"", use, static_cast<unsigned>(color.r),
                              static_cast<unsigned>(color.g), static_cast<unsigned>(color.b));
    if (color.a < 255) text += format(" %s-opacity=\"%.3g\"", use, color.a / 255.0);
    return text;
}

std::string points_text(const std::vector<ScreenPosition>& points) {
    std::string text;
    for (const ScreenPosition& p : points)
        text += (text.empty() ? "" : " ") + format("%.2f,%.2f", p.x, p.y);
    return text;
}

std::string element(const TextShape& shape) {
    static constexpr const char* weights[] = {"400", "500", "700"};
    const double size = shape.style.size / (ascent + descent);
    std::string text;
    int y = shape.y;
    for (std::size_t begin = 0; begin <= shape.text.size(); y += shape.style.size) {
        const std::size_t end = std::min(shape.text.find('\n', begin), shape.text.size());
        const std::string line = shape.text.substr(begin, end - begin);
        const bool only = begin == 0 && end == shape.text.size();
        if (!line.empty())
            text +=
                format("<text x=\"%d\" y=\"%.2f\" font-size=\"%.2f\" font-weight=\"%s\"", shape.x,
                       y + ascent * size, size,
                       weights[static_cast<std::size_t>(shape.style.weight)]) +
                (only ? format(" textLength=\"%d\" lengthAdjust=\"spacingAndGlyphs\"", shape.width)
                      : "") +
                paint("fill", shape.style.color) + ">" + escaped(line) + "</text>\n";
        begin = end + 1;
    }
    return text;
}

std::string element(const RectangleShape& shape) {
    const PixelRect& r = shape.rect;
    return format("<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\"", r.x, r.y, r.width,
                  r.height) +
           paint("fill", shape.color) + "/>\n";
}

std::string element(const LineShape& shape) {
    if (shape.points.size() == 1)
        return format("<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\"", shape.points[0].x,
                      shape.points[0].y, shape.thickness / 2) +
               paint("fill", shape.color) + "/>\n";
    return "<polyline points=\"" + points_text(shape.points) + "\" fill=\"none\"" +
           paint("stroke", shape.color) + format(" stroke-width=\"%.2f\"", shape.thickness) +
           (shape.round ? " stroke-linecap=\"round\" stroke-linejoin=\"round\"/>\n" : "/>\n");
}

std::string element(const PolygonShape& shape) {
    return "<polygon points=\"" + points_text(shape.corners) + "\"" + paint("fill", shape.color) +
           "/>\n";
}

}  // namespace

std::string svg_text(const OverlayShapes& shapes, const Picture& picture, const Image* views) {
    std::string text = format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\" width=\"%d\" "
        "height=\"%d\" viewBox=\"0 0 %d %d\" font-family=\"Roboto, Arial, sans-serif\" "
        "xml:space=\"preserve\">\n",
        picture.width, picture.height, picture.width, picture.height);
    text += element(RectangleShape{{0, 0, picture.width, picture.height}, picture.background});
    if (views != nullptr)
        text += format("<image width=\"%d\" height=\"%d\" ", picture.width, picture.height) +
                "xlink:href=\"data:image/png;base64," + base64(encode_png(*views)) + "\"/>\n";
    for (const OverlayShape& shape : shapes.list)
        text += std::visit([](const auto& one) { return element(one); }, shape);
    return text + "</svg>\n";
}

}  // namespace scb::render
