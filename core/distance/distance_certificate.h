#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/distance/placed_corners.h"
#include "scb/distance.h"

namespace scb {

/// The mesh and the tree of one side of a query.
template <Volume V>
MeshTree mesh_tree(const Collider<V>& side) {
    return {side.mesh, *side.hierarchy.topology};
}

/// A point of a triangle: the corner, and shares of the edges from it to the two others. The corner
/// is the one with the largest weight. Shares of at most a half, however rounded, put the point
/// into the triangle.
struct SurfacePoint {
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;  ///< 0, 1 or 2: k
    double to_next = 0;        ///< share of the edge to corner k + 1 modulo 3, 0 to 1/2
    double to_after = 0;       ///< share of the edge to corner k + 2 modulo 3, 0 to 1/2
};

/// What becomes of a pair of nodes.
enum class CutStep : std::uint8_t {
    divide_a,  ///< the pairs of A's left child and of its right child with B's node follow
    divide_b,  ///< the pairs of A's node with B's left child and its right child follow
    end,       ///< the pair ends here, with the next direction
};

/// A proof of the distance of two meshes, for check_distance. Two points prove that it is not
/// larger. A cut of the product of the trees proves that it is not smaller: each pair of triangles
/// is below one of its pairs of nodes. The corners below its two nodes are apart along a direction.
struct DistanceCertificate {
    SurfacePoint on_a, on_b;
    /// From the pair of the roots on, in preorder. Empty: no lower bound. The distance is then 0 if
    /// the triangles of the two points intersect.
    std::vector<CutStep> cut;
    /// One for each CutStep::end, from A to B, in A's frame; of any length.
    std::vector<Vec3> directions;
};

/// What a certificate proves.
struct ProvenDistance {
    /// Why the certificate proves nothing; empty if it proves the two bounds.
    std::string fault;
    double lower = 0, upper = HUGE_VAL;
    double largest_coordinate = 0;  ///< of any corner of A and B, in A's frame
};

/// The bounds that a certificate proves, in spite of rounding, for the triangles that distance()
/// measures: A's corners as stored, B's as transform_point rounds them. The certificate, the trees
/// and the pose may be anything: wrong ones have a fault, or bounds that are true but wide.
///
/// O(n) for the meshes, and O(corners below the two nodes) for each end of the cut. Throws
/// std::bad_alloc only.
ProvenDistance check_distance(const MeshTree& a, const MeshTree& b, const Pose& b_to_a,
                              const DistanceCertificate& certificate);

/// The width that the bounds of a distance may have: 1e-9 of it, and 4 x 2^-52 of the largest
/// coordinate.
double allowed_width(double distance, double largest_coordinate);

/// The error that a distance of these bodies may have by rounding: 4 x 2^-52 of the largest
/// coordinate in A's frame, with B moved by `b_to_a`.
double distance_rounding(const MeshTree& a, const MeshTree& b, const Pose& b_to_a);

/// Whether two distances of the same triangles are equal up to `rounding`, see
/// distance_rounding. Numbers that are not finite are equal to nothing.
inline bool equal_distances(double x, double y, double rounding) {
    return std::abs(x - y) <= rounding;
}

/// Whether the proof is as narrow as allowed_width, and holds the distance up to the error that
/// triangle_distance states. A distance of 0 needs the bounds 0 and 0, another distance others.
bool certifies(const ProvenDistance& proven, double distance);

/// A proven lower bound of the gap between two sets of points along a direction from A to B; 0 if
/// none was found. Of the largest magnitudes of all sums |x| + |y| + |z| in A and in B, `magnitude`
/// is the sum, or more. If rounding matters for whether the gap is `enough`, it is exact to 1e-14.
double proven_gap(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& direction,
                  double magnitude, double enough);

/// A certificate of the distance, given the closest triangles that distance() found without limits.
/// With other triangles, the bounds are true and wide. The meshes must satisfy check_mesh; each
/// leaf has one triangle.
///
/// From the roots on, pairs of nodes are divided until a direction shows that the hulls of their
/// corners are as far apart as the triangles. No volume is needed: hulls are tighter than volumes,
/// so the cut is small. O(corners below the two nodes) for each pair of nodes.
DistanceCertificate make_certificate(const MeshTree& a, const MeshTree& b, const Pose& b_to_a,
                                     const IndexPair& closest);

}  // namespace scb
