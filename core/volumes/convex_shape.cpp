#include "core/volumes/convex_shape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "scb/convex.h"

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

namespace {

/// Clips a convex polygon by a half space (Sutherland and Hodgman, "Reentrant Polygon Clipping").
/// Returns whether anything was cut off.
bool clip(const std::vector<Vec3>& polygon, const FacePlane& plane, std::vector<Vec3>& kept) {
    const auto beyond = [&](const Vec3& p) { return dot(plane.normal, p) - plane.offset; };
    if (std::none_of(polygon.begin(), polygon.end(), [&](const Vec3& p) { return beyond(p) > 0; }))
        return false;
    kept.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const double at_a = beyond(a), at_b = beyond(b);
        if (at_a <= 0) kept.push_back(a);
        if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))
            kept.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    return true;
}

double area_of(const std::vector<Vec3>& polygon, const Vec3& normal) {
    double doubled = 0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        doubled +=
            dot(normal, cross(Vec3(polygon[k] - polygon[0]), Vec3(polygon[k + 1] - polygon[0])));
    return std::abs(doubled) / 2;
}

/// Calls `use` with each face that has corners: its plane's unit normal and distance, its polygon.
template <class Use>
void for_each_face(std::span<const FacePlane> planes, double size, const Use& use) {
    std::vector<Vec3> face, kept;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const double length = std::sqrt(squared_norm(planes[i].normal));
        const Vec3 normal = planes[i].normal / length;
        const double height = planes[i].offset / length;
        // A square in the plane, larger than the polytope, clipped by the other planes.
        const Vec3 other = std::abs(normal[0]) < 0.6 ? Vec3::UnitX() : Vec3::UnitY();
        Vec3 u = cross(normal, other);
        u *= 2 * size / std::sqrt(squared_norm(u));
        const Vec3 v = cross(normal, u), middle = height * normal;
        face = {middle + u + v, middle - u + v, middle - u - v, middle + u - v};
        for (std::size_t j = 0; j < planes.size() && !face.empty(); ++j)
            if (j != i && clip(face, planes[j], kept)) face.swap(kept);
        if (face.size() > 2) use(normal, height, face);
    }
}

}  // namespace

std::vector<std::vector<Vec3>> face_polygons(std::span<const FacePlane> planes, double size) {
    std::vector<std::vector<Vec3>> polygons;
    for_each_face(planes, size, [&](const Vec3&, double, const std::vector<Vec3>& face) {
        polygons.push_back(face);
    });
    return polygons;
}

SurfaceMeasures polytope_measures(std::span<const FacePlane> planes, double size) {
    SurfaceMeasures sum;
    for_each_face(planes, size,
                  [&](const Vec3& normal, double height, const std::vector<Vec3>& face) {
                      const double area = area_of(face, normal);
                      sum.area += area;
                      sum.volume += area * height / 3;
                  });
    return sum;
}

std::span<const Vec3> touching_directions() {
    static const DirectionGrid grid = direction_grid(4);
    return grid.directions;
}

DirectionGrid direction_grid(int steps) {
    DirectionGrid grid;
    std::map<std::array<int, 3>, std::uint32_t> known;
    // Points are keyed by integers from -steps to steps, so that faces share the points of common
    // edges.
    const auto at = [&](int axis, int side, int i, int j) {
        std::array<int, 3> corner{};
        const auto a = static_cast<std::size_t>(axis);
        corner[a] = side * steps;
        corner[(a + 1) % 3] = 2 * i - steps;
        corner[(a + 2) % 3] = side * (2 * j - steps);
        const auto [found, is_new] =
            known.try_emplace(corner, static_cast<std::uint32_t>(grid.directions.size()));
        if (is_new) {
            const Vec3 d(corner[0], corner[1], corner[2]);
            grid.directions.push_back(d / std::sqrt(squared_norm(d)));
        }
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {1, -1})
            for (int i = 0; i < steps; ++i)
                for (int j = 0; j < steps; ++j) {
                    const std::uint32_t a = at(axis, side, i, j), b = at(axis, side, i + 1, j),
                                        c = at(axis, side, i + 1, j + 1),
                                        d = at(axis, side, i, j + 1);
                    grid.triangles.push_back({a, b, c});
                    grid.triangles.push_back({a, c, d});
                }
    return grid;
}

}  // namespace scb
