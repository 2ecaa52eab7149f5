#pragma once

#include "scb/mesh.h"

namespace scb::scenes {

/// A closed tube around a torus knot, or around a companion curve that winds about the knot.
///
/// The knot is the curve
///     k(t) = ((R + r cos qt) cos pt, (R + r cos qt) sin pt, r sin qt),   0 <= t < 1 turn,
/// on the torus with the z axis. The tube's axis is k itself if `offset` is 0, and otherwise
///     a(t) = k(t) + offset (cos(wt) N + sin(wt) (T x N)),   w = offset_turns,
/// with N the outward normal of the torus at k(t) and T the unit tangent of k. As k lies on the
/// torus, N is perpendicular to T, so a(t) is `offset` away from k(t), starts along the torus
/// normal and turns `offset_turns` times about k in one period (a negative number turns the other
/// way).
struct TorusKnot {
    int p = 2;                  ///< turns about the z axis, 1 to 1000
    int q = 3;                  ///< turns about the core circle of the torus, 1 to 1000
    double major_radius = 2.5;  ///< R
    double minor_radius = 1.1;  ///< r
    double tube_radius = 0.4;
    int sides = 12;   ///< corners of a cross-section, at least 3
    int rings = 147;  ///< cross-sections, at least 3, at equal steps of t
    double offset = 0;
    int offset_turns = 1;
};

/// A point of the tube's axis and the cross-section frame there: `tangent`, `normal`, `binormal`
/// are orthonormal and right-handed.
struct KnotFrame {
    Vec3 point, tangent, normal, binormal;
};

/// The frame at `turns` of the parameter t (0 to 1 is the whole curve). The tangent is the analytic
/// derivative; the normal is the torus normal N, or for a companion curve the direction a(t) - k(t)
/// away from the knot, made perpendicular to it. Both are functions of t alone, so the frame closes
/// up after a period without any twist left over. Throws InputError if the curve has a cusp or runs
/// along that direction, which is only possible with a large offset.
KnotFrame knot_frame(const TorusKnot& knot, double turns);

/// The tube: `rings * sides` shared vertices, `2 * rings * sides` triangles, closed. Corner j of
/// ring i is vertex `i * sides + j`, at angle (j + 1/2) / sides turns from the frame's normal. The
/// quad between corners j, j + 1 and two rings is cut from corner j + 1 of the first ring to corner
/// j of the next. A wide tube may cross itself. Throws InputError, naming the parameter, if one is
/// out of range.
Mesh torus_knot_mesh(const TorusKnot& knot);

}  // namespace scb::scenes
