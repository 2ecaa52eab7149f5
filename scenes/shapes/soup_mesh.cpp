#include "core/base/random.h"
#include "scenes/shapes/parameter_checks.h"
#include "scenes/shapes/procedural.h"

namespace scb::scenes {
namespace {

/// Uniform in the cube of the given side about the origin; the three numbers are drawn in the order
/// x, y, z.
Vec3 point_in_cube(Random& random, double side) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = side * (random.uniform() - 0.5);
    return point;
}

}  // namespace

Mesh soup_mesh(const SoupShape& shape) {
    require_between("count", shape.count, 1, max_procedural_triangles);
    require_length("size", shape.size);
    require_length("triangle_size", shape.triangle_size);
    Random random(shape.seed);
    Mesh mesh;
    mesh.vertices.reserve(3 * static_cast<std::size_t>(shape.count));
    mesh.triangles.reserve(static_cast<std::size_t>(shape.count));
    for (std::uint32_t t = 0; t < static_cast<std::uint32_t>(shape.count); ++t) {
        const Vec3 center = point_in_cube(random, shape.size);
        for (int corner = 0; corner < 3; ++corner)
            mesh.vertices.push_back(center + point_in_cube(random, shape.triangle_size));
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return mesh;
}

}  // namespace scb::scenes
