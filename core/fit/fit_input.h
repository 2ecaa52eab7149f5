#pragma once

#include <array>
#include <cstddef>

#include "core/fit/dop26.h"
#include "core/fit/extremal_points.h"
#include "core/geometry/points.h"
#include "core/geometry/surface.h"
#include "scb/vec.h"

namespace scb {

/// A set of points to fit a volume to, with facts that are already known.
struct FitInput {
    /// All points, in ascending order of their ids; either part may be empty.
    std::array<PointsView, 2> parts;
    /// All points if they are at most 26. Else the extremal points of the DOP (the set E of
    /// Figure 3) in the order of the directions, upper before lower.
    const FewPoints* few = nullptr;
    const ExtremalPairs* pairs = nullptr;  ///< the extremal points, as indices of `few`
    const Dop26* dop = nullptr;
    const SurfaceMoments* moments = nullptr;  ///< of the triangles, if any

    std::size_t size() const { return parts[0].size + parts[1].size; }
    bool is_few() const { return size() <= FewPoints::capacity; }
};

/// The axes of an Obb, as columns, right-handed and the longest direction first: eigenvectors of
/// the scatter of the surface, or of the points if there are no triangles or they have no area; the
/// coordinate axes if the points' scatter has no direction (Gottschalk, Lin, Manocha, "OBBTree",
/// 1996).
Mat3 box_axes(const FitInput& input);

}  // namespace scb
