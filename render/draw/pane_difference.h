#pragma once

#include <cstdint>
#include <vector>

#include "render/view/picture.h"

namespace scb::render {

/// The ids, ascending, of what two panes show differently: volumes and triangles of meshes that
/// only one of them has, or that have another color in the other. The same thing must have the same
/// id in both, and a mesh colors of its triangles in both or in neither. Segments are left aside.
std::vector<std::uint32_t> differing_ids(const Pane& a, const Pane& b);

}  // namespace scb::render
