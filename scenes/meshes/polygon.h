#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "scb/mesh.h"

namespace scb::scenes {

/// Cuts the polygons of a file into triangles.
class PolygonCutter {
  public:
    /// Cuts a polygon, given by the indices of its corners in order, into `corners.size() - 2`
    /// triangles of the same orientation and appends them to `triangles`; fewer than three corners
    /// give none.
    ///
    /// If a fan from the first corner covers the polygon (as for every convex polygon), the
    /// triangles are this fan. Else ears are cut off one by one. A hole may be bridged by an edge
    /// that is used in both directions. A polygon that crosses itself, or that has no area, has no
    /// right answer and gets the fan. The polygon may be slightly out of plane. Throws InputError
    /// if all concave polygons so far take some seconds to cut: ears take time up to the cube of
    /// the corners. `name` is the name of the polygon in messages.
    void append(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices,
                std::string_view name, std::vector<Triangle>& triangles);

  private:
    std::uint64_t steps_ = std::uint64_t{1} << 30;  ///< the number of corners that may still be
                                                    ///< visited
};

}  // namespace scb::scenes
