#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "scb/vec.h"

namespace scb {

/// The three corners of a triangle, as indices of vertices.
using Triangle = std::array<std::uint32_t, 3>;

/// A triangle mesh or triangle soup in its body frame. No connectivity is assumed; degenerate and
/// duplicate triangles are legal, and vertices that no triangle uses are ignored by everything that
/// bounds the mesh.
struct Mesh {
    /// Points, in any unit of length.
    std::vector<Vec3> vertices;
    /// Three vertices each.
    std::vector<Triangle> triangles;
};

/// An axis-aligned box; empty (lower > upper) until something is added.
struct Box {
    /// The least coordinates.
    Vec3 lower = Vec3::Constant(1e300);
    /// The greatest coordinates.
    Vec3 upper = Vec3::Constant(-1e300);

    /// Grows it until it holds the point.
    void add(const Vec3& point) {
        lower = lower.cwiseMin(point);
        upper = upper.cwiseMax(point);
    }
    /// Grows it until it holds the other box.
    void add(const Box& box) {
        lower = lower.cwiseMin(box.lower);
        upper = upper.cwiseMax(box.upper);
    }
};

/// The largest |coordinate| that a mesh may have: fourth powers of lengths must stay finite.
inline constexpr double max_coordinate = 1e70;

/// The smallest longest side of the box of a mesh that is not a point: fourth powers of lengths
/// must not vanish.
inline constexpr double min_size = 1e-60;

/// The most triangles that a hierarchy can index.
inline constexpr std::size_t max_triangles = std::size_t{1} << 30;
/// The most vertices that a hierarchy can index.
inline constexpr std::size_t max_vertices = std::size_t{1} << 31;

/// Throws InputError, naming the first offender, if the mesh has no triangles, too many triangles
/// or vertices, an index out of range, or a used vertex that is not finite or beyond
/// max_coordinate. `name` is the name of the mesh in the message.
void check_mesh(const Mesh& mesh, std::string_view name);

/// The box of the vertices that triangles use.
Box bounding_box(const Mesh& mesh);

/// Per vertex the first vertex at the same position (0 and -0 are equal): vertices with equal
/// values are one vertex. A vertex that is not finite has the value 2^32 - 1.
std::vector<std::uint32_t> joined_vertices(const Mesh& mesh);

}  // namespace scb
