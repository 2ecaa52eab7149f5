#pragma once

#include <span>
#include <vector>

#include "render/overlay/overlay.h"

namespace scb::render {

/// The points of a line (pixels, from left to right) without invisible ones: among consecutive
/// points in one column of pixels, the first, the highest, the lowest and the last stay, in their
/// order. So no peak is lost.
std::vector<ScreenPosition> thinned(std::span<const ScreenPosition> points);

}  // namespace scb::render
