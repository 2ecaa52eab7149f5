#pragma once

#include "core/analysis/trace.h"
#include "render/overlay/scales.h"
#include "render/plots/ending_colors.h"

namespace scb::render {

/// The color of pairs that were divided: pale, so that the endings stand out.
Rgba8 divided_color(const Theme& theme);

/// Which elements an icicle has, for its caption.
struct DrawnIcicle {
    PixelRect covered;
    bool numbers = false;  ///< at least one
    bool stacks = false;   ///< at least one
};

/// Draws a frame's recursion (see Icicle) as wide as the rectangle, with the depth of a row's pairs
/// at its left. If there is room, rectangles of divided pairs show the number of their tests.
DrawnIcicle draw_icicle(Overlay& overlay, const PixelRect& rect, const Steps& steps,
                        const Outcomes& outcomes, const std::vector<EndingGroup>& groups,
                        const FigureStyle& style);

}  // namespace scb::render
