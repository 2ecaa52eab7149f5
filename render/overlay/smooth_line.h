#pragma once

#include <span>
#include <vector>

#include "render/overlay/overlay.h"

namespace scb::render {

/// A line through the points (pixels), `thickness` pixels wide, with round ends and joints; a
/// single point is a dot. It is smoothed: a pixel's opacity is the share of it that the line
/// covers; crossings of the line with itself count once. The coverage is computed in integers, and
/// pixels are drawn as an overlay's rectangles, so the bytes are the same everywhere, as for all of
/// Overlay. Positions must be finite.
void draw_smooth_line(Overlay& overlay, std::span<const ScreenPosition> points, Rgba8 color,
                      double thickness);

/// The line cut into dashes. The pattern has the lengths of dashes and gaps in turn, beginning with
/// a dash (in pixels, at least 1 each, an even number of lengths).
std::vector<std::vector<ScreenPosition>> dashes(std::span<const ScreenPosition> points,
                                                std::span<const double> pattern);

}  // namespace scb::render
