#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "render/overlay/overlay.h"

namespace scb::render {

/// Figures made of an overlay's text and rectangles. Each returns the pixels that it covers, panel
/// included.

/// The style of figures: `unit` is the size of body text in pixels (see text_unit).
struct FigureStyle {
    Theme theme = light_theme;
    int unit = 20;
};

struct Tick {
    double at = 0;  ///< 0 (left or bottom end) to 1
    std::string label;
};

/// A scale of colors, `color(0)` at the left or bottom end to `color(1)`: the bar fills `bar`; tick
/// labels stand below a horizontal bar and right of a vertical one (taller than wide). `title`
/// stands above. Labels of a horizontal bar stay within its ends, and a label that would touch the
/// one before is left out.
PixelRect draw_color_bar(Overlay& overlay, const PixelRect& bar,
                         const std::function<Rgba8(double)>& color, std::string_view title,
                         std::span<const Tick> ticks, const FigureStyle& style);

struct BarPart {
    Rgba8 color;
    double amount = 0;
};

/// A bar of parts whose lengths are proportional to their amounts, filled to `amount sum / full`:
/// from the left, or from the bottom if `rect` is taller than wide. Every part with a pixel or more
/// of length is drawn. Rounding errors do not add up, since the running sum gives the end of each
/// part.
PixelRect draw_stacked_bar(Overlay& overlay, const PixelRect& rect, std::span<const BarPart> parts,
                           double full);

/// A bar as long as a round number (1, 2 or 5 times a power of ten) of world units, at most
/// `largest_width` pixels, with that number above it; (x, y) is its lower left corner. For
/// orthographic views, or at a stated depth.
PixelRect draw_scale_bar(Overlay& overlay, int x, int y, int largest_width, double pixels_per_unit,
                         const FigureStyle& style);

}  // namespace scb::render
