#pragma once

#include <span>
#include <vector>

#include "core/model/node_volume.h"
#include "scb/triangle_overlap.h"

namespace scb {

/// The volumes on the way to a leaf. A query reaches the leaf only where it hits all of them.
using LeafWay = std::vector<const NodeVolume*>;

struct TriangleCover {
    enum class Kind {
        covered,
        open,       ///< `point` is in none of the leaves
        undecided,  ///< too many pieces, as at curved surfaces that run along each other
    };
    Kind kind = Kind::covered;
    Vec3 point = Vec3::Zero();
    double amount = 0;        ///< a lower bound of the distance of the point from the nearest way
    std::size_t nearest = 0;  ///< index of that way
};

/// Whether each point of a triangle in several leaves is in all volumes on the way to one of them,
/// within `tolerance` (a length). Builders with spatial splits cut a triangle and give each leaf a
/// part (Stich, Friedrich and Dietrich, "Spatial Splits in Bounding Volume Hierarchies", 2009). The
/// triangle is cut along the planes of boxes and polytopes, which decides these up to rounding. It
/// is halved at curved surfaces.
TriangleCover cover_of(const TriangleCorners& triangle, std::span<const LeafWay> ways,
                       double tolerance);

}  // namespace scb
