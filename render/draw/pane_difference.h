#pragma once

#include <cstdint>
#include <vector>

#include "render/view/picture.h"

namespace scb::render {

/// The ids, ascending, of volumes and triangles of meshes that only one of two panes has, or that
/// differ in color. The same thing must have the same id in both panes, and a mesh must have colors
/// of its triangles in both or in neither. Segments are ignored.
std::vector<std::uint32_t> differing_ids(const Pane& a, const Pane& b);

}  // namespace scb::render
