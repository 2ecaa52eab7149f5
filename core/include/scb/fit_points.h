#pragma once

#include <array>
#include <cstddef>

#include "scb/vec.h"

namespace scb {

struct FitInput;

/// The points of a node, to which `fit(result, points)` fits a volume, see convex.h. At least one
/// point, in the order of the mesh for any number of threads.
class FitPoints {
  public:
    /// For the library itself. Refers to `input`, which must outlive it.
    explicit FitPoints(const FitInput& input);

    /// How many points there are, at least 1.
    std::size_t size() const { return sizes_[0] + sizes_[1]; }
    /// The i-th point, in the body's frame.
    Vec3 operator[](std::size_t i) const {
        const std::size_t part = i < sizes_[0] ? 0 : 1, k = i - (part == 0 ? 0 : sizes_[0]);
        return {parts_[part][0][k], parts_[part][1][k], parts_[part][2][k]};
    }

    /// The least of direction.p over the points p, for one of `dop_directions` by its index. They
    /// are not unit vectors. O(1).
    double lower(std::size_t direction) const;
    /// The greatest of direction.p, likewise.
    double upper(std::size_t direction) const;

    /// The principal axes of the surface, as columns, right-handed and the longest direction first,
    /// see Obb (Gottschalk, Lin and Manocha, "OBBTree", 1996).
    Mat3 axes() const;

  private:
    const FitInput& input_;
    std::array<std::array<const double*, 3>, 2> parts_;
    std::array<std::size_t, 2> sizes_;
};

}  // namespace scb
