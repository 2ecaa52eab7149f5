#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "render/files/image.h"
#include "render/view/palette.h"
#include "render/view/picture.h"

struct ImDrawList;

namespace scb::render {

enum class FontWeight;
struct OverlayShapes;
struct FontFace;

enum class Align { left, center, right };

struct TextStyle {
    int size = 20;  ///< pixels from ascender to descender
    FontWeight weight{};
    Rgba8 color{28, 32, 38};
    Align align = Align::left;
};

struct TextSize {
    int width = 0;
    int height = 0;
};

struct ScreenPosition {
    double x = 0;
    double y = 0;
};

/// The size of body text in a picture or pane of this size: 20 pixels at 1280x720. It grows with
/// the smaller of height and width, and is never below 13. Titles are 1.4 times as large.
int text_unit(int width, int height);
constexpr int title_size(int unit) { return unit * 7 / 5; }
inline int small_size(int unit) { return unit * 17 / 20 < 12 ? 12 : unit * 17 / 20; }

/// Text and plain figures on top of a picture, in pixels from its top left corner, later ones over
/// earlier ones. Everything lies on whole pixels, and only letters are smoothed, so the bytes are
/// the same everywhere. Make one overlay and call begin() for every picture: it keeps the faces
/// that it has rasterised.
class Overlay {
  public:
    Overlay();
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Forgets what was drawn.
    void begin();

    /// One line of UTF-8 (or several, parted by '\n'): its left end, middle or right end at x,
    /// depending on its alignment, and its top at y. Characters that the face does not have appear
    /// as '?'.
    void text(int x, int y, std::string_view text, const TextStyle& style);

    /// The largest box that text() fills.
    TextSize measure(std::string_view text, const TextStyle& style);

    void rectangle(const PixelRect& rect, Rgba8 color);

    /// The border of a rectangle, inside it.
    void frame(const PixelRect& rect, Rgba8 color, int thickness = 1);

    /// A line through the points; ends and joints are square. For a smoothed one see
    /// draw_smooth_line.
    void polyline(std::span<const ScreenPosition> points, Rgba8 color, double thickness);

    /// A filled convex polygon.
    void polygon(std::span<const ScreenPosition> corners, Rgba8 color);

    /// Records all drawn shapes in this list, until begin() empties it; nullptr: no recording.
    /// Returns the list before.
    OverlayShapes* note_in(OverlayShapes* shapes);

    /// The drawn shapes, for the painter.
    const ImDrawList& draw_list() const;
    /// The faces in use, for the painter.
    std::span<const FontFace> faces() const;

  private:
    const FontFace& face(const TextStyle& style);

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace scb::render
