#pragma once

#include <cstdint>

#include "scb/mesh.h"

namespace scb::scenes {

/// Meshes made by formula. Lengths are scene units, every mesh is centered on the origin of its
/// body frame, and triangles are counterclockwise seen from outside. The order of vertices and
/// triangles and every coordinate are the same on every compiler and CPU. Each function throws
/// InputError, naming the parameter, if one is out of its range.

/// The most triangles that one procedural mesh may have.
inline constexpr std::int64_t max_procedural_triangles = std::int64_t{1} << 23;

/// An icosahedron with every triangle cut into four `subdivisions` times (0 to 9), each new vertex
/// pushed to the unit sphere, and the result scaled by `radius` at the end. Vertices are shared: 10
/// * 4^n + 2 vertices and 20 * 4^n triangles, a closed surface.
Mesh icosphere(int subdivisions, double radius);

/// A box, closed, with the origin in its middle; every side is a grid of `subdivisions` x
/// `subdivisions` cells of two triangles (1 to 512). Vertices are shared across the edges.
struct BoxShape {
    Vec3 size = Vec3::Ones();  ///< full lengths along x, y, z, each > 0
    int subdivisions = 1;
};
Mesh box_mesh(const BoxShape& shape);

/// An open rectangle in the plane z = 0, facing +z: `cells_x` x `cells_y` cells of two triangles.
struct PlaneShape {
    double size_x = 1;
    double size_y = 1;
    int cells_x = 1;
    int cells_y = 1;
};
Mesh plane_mesh(const PlaneShape& shape);

/// A cylinder about the z axis from -height/2 to height/2. The mantle is `segments` belts of `2 *
/// sides` triangles: few segments on a tall cylinder give long thin triangles, the weak case of
/// slab cut balls.
struct CylinderShape {
    double radius = 1;
    double height = 1;
    int sides = 32;  ///< at least 3
    int segments = 1;
    bool capped = true;  ///< close both ends with `sides` triangles around a middle vertex
};
Mesh cylinder_mesh(const CylinderShape& shape);

/// A cone about the z axis, base at -height/2 and tip at +height/2. The mantle is cut into
/// `segments` belts.
struct ConeShape {
    double radius = 1;
    double height = 1;
    int sides = 32;  ///< at least 3
    int segments = 1;
    bool capped = true;  ///< close the base with `sides` triangles around a middle vertex
};
Mesh cone_mesh(const ConeShape& shape);

/// Independent triangles: centers uniform in a cube of side `size`, corners uniform in a cube of
/// side `triangle_size` about the center. Each has its own three vertices. Equal seeds give equal
/// soups.
struct SoupShape {
    int count = 1000;
    double size = 1;
    double triangle_size = 0.1;
    std::uint64_t seed = 1;
};
Mesh soup_mesh(const SoupShape& shape);

}  // namespace scb::scenes
