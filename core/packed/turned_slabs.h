#pragma once

#include <array>

#include "scb/scb2.h"

namespace scb {

/// The slabs of an Scb2 for PackedScb2, not rounded yet: the narrower slab first, the normals
/// turned around such that the scalar part of the quaternion is the largest.
struct TurnedSlabs {
    std::array<Slab, 2> slabs;
    Vec3 q;  ///< the vector part; no component is larger than the scalar part

    explicit TurnedSlabs(const Scb2& scb);
};

}  // namespace scb
