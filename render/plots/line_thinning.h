#pragma once

#include <span>
#include <vector>

#include "render/overlay/overlay.h"

namespace scb::render {

/// The points of a line (pixels, from left to right) without those that cannot be seen: of points
/// that follow each other within one column of pixels, the first, the highest, the lowest and the
/// last, in their order. So no peak is lost, however many points share a column.
std::vector<ScreenPosition> thinned(std::span<const ScreenPosition> points);

}  // namespace scb::render
