#pragma once

#include <span>
#include <vector>

#include "scb/mesh.h"

namespace scb::scenes {

/// Cuts a polygon, given by the indices of its corners in order (at least 3), into `corners.size()
/// - 2` triangles of the same orientation and appends them to `triangles`.
///
/// The triangles are a fan from the first corner wherever such a fan covers the polygon (every
/// convex polygon), and ears cut off one by one where it is concave. A polygon that crosses itself,
/// or that has no area, has no right answer and gets the fan. The polygon may be a little out of
/// plane. Throws InputError for a concave polygon too large for ear cutting; `name` says which
/// polygon it is.
void append_polygon(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices,
                    std::string_view name, std::vector<Triangle>& triangles);

}  // namespace scb::scenes
