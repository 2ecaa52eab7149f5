#include "core/geometry/placed_box.h"

namespace scb {

Box bounding_box(const Mesh& mesh, const Pose& pose) {
    Box box;
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle) box.add(transform_point(pose, mesh.vertices[v]));
    return box;
}

Vec3 gap_between(const Box& x, const Box& y) {
    return (y.lower - x.upper).cwiseMax(0) + (y.upper - x.lower).cwiseMin(0);
}

}  // namespace scb
