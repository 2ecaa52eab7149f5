#pragma once

#include <array>

#include "scb/scb2.h"

namespace scb {

/// A ball cut by two slabs as 11 floats, 44 bytes: the points x with |x - c| <= r and
/// |n_i.(x - c) - m_i| <= h_i, see PackedScb. The first slab is the narrower one.
struct PackedScb2 {
    /// Center, relative to an origin that is known elsewhere.
    float c[3] = {0, 0, 0};
    /// Radius.
    float r = 0;
    /// The vector part of a unit quaternion that turns x, y and z into the first normal, the second
    /// one and the long axis. Its scalar part is not negative, so it follows from these. It is at
    /// least 1/2, since a normal may be turned around together with another axis.
    float q[3] = {0, 0, 0};
    /// The middles of the slabs from the center, along their normals.
    float m[2] = {0, 0};
    /// Half the thicknesses of the slabs.
    float h[2] = {0, 0};
};

/// The center, exactly.
inline Vec3 center(const PackedScb2& scb) {
    return {static_cast<double>(scb.c[0]), static_cast<double>(scb.c[1]),
            static_cast<double>(scb.c[2])};
}

/// The two normals as queries compute them in floats, exactly; unit vectors at right angles, up to
/// some units in the last place of floats.
std::array<Vec3, 2> normals(const PackedScb2& scb);

/// The volume in floats, its center relative to `origin`. Contains all of `scb`.
PackedScb2 packed(const Scb2& scb, const Vec3& origin);

/// Whether the point, relative to the origin, is inside or on the surface.
bool contains(const PackedScb2& scb, const Vec3& point);

}  // namespace scb
