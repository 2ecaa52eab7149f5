#pragma once

#include <span>
#include <vector>

#include "core/model/node_volume.h"
#include "scb/triangle_overlap.h"

namespace scb {

/// The volumes on the way to a leaf: a query comes to the leaf where it comes to all of them.
using LeafWay = std::vector<const NodeVolume*>;

struct TriangleCover {
    enum class Kind {
        covered,
        open,       ///< `point` is in none of the leaves
        undecided,  ///< curved volumes whose surfaces run along each other
    };
    Kind kind = Kind::covered;
    Vec3 point = Vec3::Zero();
    double amount = 0;        ///< how far the point is outside of the nearest way, at least
    std::size_t nearest = 0;  ///< which way that is
};

/// Whether each point of a triangle that is in several leaves is in all volumes on the way to one
/// of them, but for `tolerance`, a length: builders with spatial splits cut a triangle and give
/// each leaf a part (Stich, Friedrich and Dietrich, "Spatial Splits in Bounding Volume
/// Hierarchies", 2009). The triangle is cut along the planes of boxes and polytopes, which decides
/// these but for rounding, and halved at curved surfaces.
TriangleCover cover_of(const TriangleCorners& triangle, std::span<const LeafWay> ways,
                       double tolerance);

}  // namespace scb
