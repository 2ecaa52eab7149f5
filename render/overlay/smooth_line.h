#pragma once

#include <span>
#include <vector>

#include "render/overlay/overlay.h"

namespace scb::render {

/// A line through the points (pixels), `thickness` pixels wide, with round ends and joints; a
/// single point is a dot. It is smoothed: each pixel is as opaque as the share of it that the line
/// covers, crossings with itself counted once. The coverage is found in whole numbers, and pixels
/// are drawn as an overlay's rectangles, so the bytes are the same everywhere, as Overlay promises.
/// Positions must be finite.
void draw_smooth_line(Overlay& overlay, std::span<const ScreenPosition> points, Rgba8 color,
                      double thickness);

/// The line cut into dashes. The pattern has the lengths of dashes and gaps by turns, beginning
/// with a dash (pixels, at least 1 each, an even number of them).
std::vector<std::vector<ScreenPosition>> dashes(std::span<const ScreenPosition> points,
                                                std::span<const double> pattern);

}  // namespace scb::render
