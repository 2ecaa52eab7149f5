#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scb/mesh.h"
#include "scb/pose.h"
#include "scb/triangle_overlap.h"

namespace scb {

/// Classes of slenderness: below 4, then up to 16, 64, 256, 1024, and above.
inline constexpr std::size_t slenderness_classes = 6;

/// Facts about a mesh that matter for its hierarchies. Corners with equal coordinates count as one
/// vertex, regardless of their indices.
struct MeshFacts {
    Box box;  ///< bounds of the vertices that triangles use
    std::size_t triangles = 0;
    std::size_t components = 0;     ///< parts that have no vertex in common
    std::size_t degenerate = 0;     ///< triangles whose corners are collinear
    std::size_t duplicates = 0;     ///< triangles that have the three corners of an earlier one
    std::size_t open_edges = 0;     ///< edges of one triangle alone
    std::size_t crowded_edges = 0;  ///< edges of more than two triangles

    /// The number of triangles in each class of slenderness: the longest side over the height on
    /// it, 1.15 for equal sides. Degenerate triangles do not count.
    std::array<std::size_t, slenderness_classes> slenderness{};
    double median_slenderness = 0;      ///< 0 where all triangles are degenerate
    double longest_slender_side = 0;    ///< among triangles with a slenderness of 16 and more
    std::uint32_t longest_slender = 0;  ///< the first triangle with this side, if any

    /// Whether every edge has two triangles, duplicates and triangles with two corners at one place
    /// set aside.
    bool closed() const { return open_edges == 0 && crowded_edges == 0; }
    /// How many triangles have a slenderness of 16 and more.
    std::size_t slender() const;
};

/// The longest side of a triangle, and its slenderness: the longest side over the height on it,
/// infinite for collinear corners.
struct TriangleSize {
    double longest_side = 0, slenderness = 0;
};
TriangleSize triangle_size(const TriangleCorners& corners);

/// Whether a triangle has a slenderness of 16 or more; a degenerate one has none.
bool is_slender(const TriangleCorners& corners);

/// O(n log n) in the triangles. `mesh` must satisfy check_mesh.
MeshFacts mesh_facts(const Mesh& mesh);

/// The triangles that have the three corners of an earlier one, ascending.
std::vector<std::uint32_t> duplicate_triangles(const Mesh& mesh);

/// The box of the vertices that triangles use, after the pose.
Box bounding_box(const Mesh& mesh, const Pose& pose);

/// The gap between two boxes along each axis: from x to y, positive or negative, 0 if they overlap
/// along it.
Vec3 gap_between(const Box& x, const Box& y);

}  // namespace scb
