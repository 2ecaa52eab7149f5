#pragma once

#include "scb/scb.h"

namespace scb {

/// A slab cut ball as 9 floats, 36 bytes: the points x with |x - c| <= r and |n.(x - c) - m| <= h.
/// Overlap tests use the slab's middle, m, and half its thickness, h. `n` is a unit vector to the
/// precision of floats.
struct PackedScb {
    /// Center, relative to an origin that is known elsewhere.
    float c[3] = {0, 0, 0};
    /// Radius.
    float r = 0;
    /// Unit normal of the slab.
    float n[3] = {0, 0, 1};
    /// The middle of the slab from the center, along n.
    float m = 0;
    /// Half the thickness of the slab.
    float h = 0;
};

/// The center, exactly.
inline Vec3 center(const PackedScb& scb) {
    return {static_cast<double>(scb.c[0]), static_cast<double>(scb.c[1]),
            static_cast<double>(scb.c[2])};
}

/// The SCB in floats, its center relative to `origin`. Contains all of `scb` (Section 1.1; the slab
/// is refitted to the rounded normal).
PackedScb packed(const Scb& scb, const Vec3& origin);

/// Whether the point, relative to the origin, is inside or on the surface.
bool contains(const PackedScb& scb, const Vec3& point);

}  // namespace scb
