#pragma once

#include <array>

#include "scb/scb2.h"

namespace scb {

/// The slabs of an Scb2 as PackedScb2 has them, not rounded yet: the narrower one first, their
/// normals turned around where that makes the scalar part of the quaternion the largest.
struct TurnedSlabs {
    std::array<Slab, 2> slabs;
    Vec3 q;  ///< the vector part; no component is larger than the scalar one

    explicit TurnedSlabs(const Scb2& scb);
};

}  // namespace scb
