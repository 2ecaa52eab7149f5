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
    /// triangles of the same orientation and appends them to `triangles`; none of fewer than three.
    ///
    /// The triangles are a fan from the first corner wherever such a fan covers the polygon (every
    /// convex polygon), and ears cut off one by one where it is concave; a hole may be bridged, by
    /// an edge that is gone along both ways. A polygon that crosses itself, or that has no area,
    /// has no right answer and gets the fan. The polygon may be a little out of plane. Throws
    /// InputError where all concave polygons so far take some seconds to cut: ears take time up to
    /// the cube of the corners. `name` says which polygon it is.
    void append(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices,
                std::string_view name, std::vector<Triangle>& triangles);

  private:
    std::uint64_t steps_ = std::uint64_t{1} << 30;  ///< how many more corners may be looked at
};

}  // namespace scb::scenes
