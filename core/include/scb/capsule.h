#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scb/convex.h"
#include "scb/fit_points.h"

namespace scb {

/// A capsule, or line swept sphere: the points within `radius` of a segment. Closed. (Larsen,
/// Gottschalk, Lin and Manocha, "Fast Proximity Queries with Swept Sphere Volumes", 1999.)
struct Capsule {
    /// Its name in pictures.
    static constexpr const char* title = "capsule";
    /// The cost of `support_point`, see ConvexVolume.
    static constexpr unsigned support_operations = 9;

    Vec3 center = Vec3::Zero();     ///< the middle of the segment
    Vec3 half_axis = Vec3::Zero();  ///< from there to one of its ends
    /// The distance from the segment to the surface.
    double radius = 0;
};

/// The middle of the segment.
inline Vec3 center(const Capsule& c) { return c.center; }
/// The radius.
inline double rounding(const Capsule& c) { return c.radius; }
/// The end of the segment, from the center, on the side of `d`.
inline Vec3 support_point(const Capsule& c, const Vec3& d) {
    return dot(c.half_axis, d) < 0 ? Vec3(-c.half_axis) : c.half_axis;
}

/// The squared distance of a point to the segment.
inline double squared_distance(const Capsule& c, const Vec3& point) {
    const Vec3 p = point - c.center;
    const double squared_length = squared_norm(c.half_axis);
    const double at = squared_length > 0 ? dot(c.half_axis, p) / squared_length : 0;
    return squared_norm(Vec3(p - std::clamp(at, -1.0, 1.0) * c.half_axis));
}
/// Whether the point is inside or on the surface.
inline bool contains(const Capsule& c, const Vec3& point) {
    return squared_distance(c, point) <= c.radius * c.radius;
}

/// The segment is along the longest principal axis, through the middle of the points' extents along
/// the other two. These two give the radius; the segment is as short as the radius allows.
inline void fit(Capsule& result, const FitPoints& points) {
    const Mat3 axes = points.axes();
    const Vec3 along = axes.col(0), origin = points[0];
    Vec3 lower = Vec3::Constant(HUGE_VAL), upper = -lower;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const double at = dot(Vec3(axes.col(k)), Vec3(points[i] - origin));
            lower[k] = std::min(lower[k], at);
            upper[k] = std::max(upper[k], at);
        }
    result.center = origin;
    for (int k = 0; k < 3; ++k) result.center += 0.5 * (lower[k] + upper[k]) * Vec3(axes.col(k));
    double squared_radius = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        squared_radius =
            std::max(squared_radius, squared_norm(cross(along, Vec3(points[i] - result.center))));
    // The ends are as near to each other as the balls about them allow.
    double first = HUGE_VAL, last = -HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 p = points[i] - result.center;
        const double at = dot(along, p);
        const double cap = std::sqrt(std::max(0.0, squared_radius - squared_norm(cross(along, p))));
        first = std::min(first, at + cap);
        last = std::max(last, at - cap);
    }
    if (first > last) first = last = 0.5 * (first + last);  // one ball contains all points
    result.center += 0.5 * (first + last) * along;
    result.half_axis = 0.5 * (last - first) * along;
    double squared = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        squared = std::max(squared, squared_distance(result, points[i]));
    result.radius = radius_of_square(squared);
}

/// The size that decides which of two volumes a traversal descends into: half the length.
inline double descent_size(const Capsule& c) {
    return std::sqrt(squared_norm(c.half_axis)) + c.radius;
}
/// Diameter: the length, round ends included.
inline double diameter(const Capsule& c) { return 2 * descent_size(c); }
/// Thickness: twice the radius.
inline double thickness(const Capsule& c) { return 2 * c.radius; }
/// Area and volume, in closed form.
inline SurfaceMeasures measures(const Capsule& c) {
    using std::numbers::pi;
    const double half = std::sqrt(squared_norm(c.half_axis)), r = c.radius;
    return {4 * pi * r * (r + half), pi * r * r * (2 * half + 4.0 / 3 * r)};
}

}  // namespace scb
