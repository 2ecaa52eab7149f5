#include "core/volumes/convex_shape.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scb {

namespace {

Vec3 sides_of_box(const ConvexShape& shape) {
    Vec3 sides;
    for (int i = 0; i < 3; ++i)
        sides[i] = support(shape, Vec3::Unit(i)) + support(shape, Vec3(-Vec3::Unit(i)));
    return sides;
}

}  // namespace

double diameter(const ConvexShape& shape) { return std::sqrt(squared_norm(sides_of_box(shape))); }

double thickness(const ConvexShape& shape) { return sides_of_box(shape).minCoeff(); }

ConvexShape placed(const ConvexShape& shape, const Pose& pose) {
    std::vector<FacePlane> faces = shape.faces;
    for (FacePlane& face : faces) face.normal = transform_direction(pose, face.normal);
    return {transform_point(pose, shape.center), shape.rounding, pose.rotation * shape.axes,
            [r = pose.rotation, own = shape.support_point](const Vec3& d) {
                return rotate(r, own(Vec3(dot(Vec3(r.col(0)), d), dot(Vec3(r.col(1)), d),
                                          dot(Vec3(r.col(2)), d))));
            },
            std::move(faces)};
}

std::vector<FacePlane> planes_about(const ConvexShape& shape, std::span<const Vec3> directions) {
    if (!shape.faces.empty()) return shape.faces;
    std::vector<FacePlane> planes;
    for (const Vec3& own : directions) {
        const Vec3 d = rotate(shape.axes, own);
        planes.push_back({d, support(shape, d)});
    }
    return planes;
}

bool identical(const ConvexShape& a, const ConvexShape& b) {
    const auto directions = touching_directions();
    return a.center == b.center && a.rounding == b.rounding &&
           std::all_of(directions.begin(), directions.end(),
                       [&](const Vec3& d) { return a.support_point(d) == b.support_point(d); });
}

}  // namespace scb
