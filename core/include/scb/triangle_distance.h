#pragma once

#include "scb/triangle_overlap.h"

namespace scb {

/// The distance of two triangles, and the points between which it was measured.
struct TriangleDistance {
    double distance = 0;  ///< 0 if and only if the triangles intersect, see triangles_overlap
    Vec3 point_a,         ///< on A, up to rounding
        point_b;          ///< on B; the same point if the triangles intersect
};

/// The distance of two triangles in one frame. Degenerate triangles are the segments and points
/// that they are. The corners must be finite, with magnitudes up to max_coordinate. Of sides below
/// 1e-70 the squares underflow, and the distance may be too large.
///
/// Whether it is 0 is exact. Otherwise it is the least distance of their features: corners, edges
/// and faces (Ericson, "Real-Time Collision Detection", Section 5.1). Each closest point is refined
/// by one Newton step. Against an oracle in higher precision, tests find errors below 4 x 2^-52 of
/// the largest coordinate; no bound is proven.
///
/// Each feature is measured with its corners in the order of their coordinates. So the result has
/// the same bits for any order of the corners, and for all triangles that share the two closest
/// features. If A and B are exchanged, distances agree up to such errors.
TriangleDistance triangle_distance(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace scb
