#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scb/convex.h"
#include "scb/fit_points.h"

namespace scb {

/// A rectangle swept sphere: the points within `radius` of a rectangle. Closed. (Larsen,
/// Gottschalk, Lin and Manocha, "Fast Proximity Queries with Swept Sphere Volumes", 1999: the
/// volume of PQP, and one of FCL's.)
struct Rss {
    /// Its name in pictures.
    static constexpr const char* title = "RSS";
    /// The cost of `support_point`, see ConvexVolume.
    static constexpr unsigned support_operations = 18;

    Vec3 center = Vec3::Zero();                         ///< the middle of the rectangle
    Vec3 half_sides[2] = {Vec3::Zero(), Vec3::Zero()};  ///< from there to the middles of its edges
    /// The distance from the rectangle to the surface.
    double radius = 0;
};

/// The middle of the rectangle.
inline Vec3 center(const Rss& v) { return v.center; }
/// The radius.
inline double rounding(const Rss& v) { return v.radius; }
/// The corner of the rectangle, from the center, that is farthest along `d`.
inline Vec3 support_point(const Rss& v, const Vec3& d) {
    const Vec3 &s = v.half_sides[0], &t = v.half_sides[1];
    return (dot(s, d) < 0 ? Vec3(-s) : s) + (dot(t, d) < 0 ? Vec3(-t) : t);
}

/// The squared distance of a point to the rectangle.
inline double squared_distance(const Rss& v, const Vec3& point) {
    Vec3 rest = point - v.center;
    const Vec3 p = rest;
    for (const Vec3& side : v.half_sides) {
        const double squared_length = squared_norm(side);
        const double at = squared_length > 0 ? dot(side, p) / squared_length : 0;
        rest -= std::clamp(at, -1.0, 1.0) * side;
    }
    return squared_norm(rest);
}
/// Whether the point is inside or on the surface.
inline bool contains(const Rss& v, const Vec3& point) {
    return squared_distance(v, point) <= v.radius * v.radius;
}

/// The rectangle is across the shortest principal axis, in the middle of the points' extent along
/// it. The radius is half this extent. The sides are as short as the balls about their ends allow,
/// and then grow alike until the corners hold all points.
inline void fit(Rss& result, const FitPoints& points) {
    const Mat3 axes = points.axes();
    const Vec3 origin = points[0];
    const auto in_frame = [&](std::size_t i) {
        const Vec3 p = points[i] - origin;
        return Vec3(dot(Vec3(axes.col(0)), p), dot(Vec3(axes.col(1)), p),
                    dot(Vec3(axes.col(2)), p));
    };
    double lower = HUGE_VAL, upper = -HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); ++i) {
        lower = std::min(lower, in_frame(i)[2]);
        upper = std::max(upper, in_frame(i)[2]);
    }
    const double radius = 0.5 * (upper - lower);
    Vec3 middle(0, 0, 0.5 * (lower + upper));
    const auto cap_of = [&](const Vec3& p) {
        const double height = p[2] - middle[2];
        return std::sqrt(std::max(0.0, radius * radius - height * height));
    };
    double half[2];
    for (int k = 0; k < 2; ++k) {
        double first = HUGE_VAL, last = -HUGE_VAL;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3 p = in_frame(i);
            const double cap = cap_of(p);
            first = std::min(first, p[k] + cap);
            last = std::max(last, p[k] - cap);
        }
        middle[k] = 0.5 * (first + last);
        half[k] = std::max(0.0, 0.5 * (last - first));
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 p = in_frame(i) - middle;
        const double x = std::abs(p[0]) - half[0], y = std::abs(p[1]) - half[1],
                     cap = cap_of(p + middle);
        if (!(x > 0 && y > 0 && x * x + y * y > cap * cap)) continue;
        const double root = std::sqrt(std::max(0.0, 2 * cap * cap - (x - y) * (x - y)));
        const double step = 0.5 * (x + y - root);
        half[0] += step;
        half[1] += step;
    }
    result.center = origin;
    for (int k = 0; k < 3; ++k) result.center += middle[k] * Vec3(axes.col(k));
    for (int k = 0; k < 2; ++k) result.half_sides[k] = half[k] * axes.col(k);
    double squared = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        squared = std::max(squared, squared_distance(result, points[i]));
    result.radius = radius_of_square(squared);
}

/// The size that decides which of two volumes a traversal descends into: half the longer side, and
/// the radius.
inline double descent_size(const Rss& v) {
    return std::sqrt(std::max(squared_norm(v.half_sides[0]), squared_norm(v.half_sides[1]))) +
           v.radius;
}
/// Diameter: the rectangle's diagonal and two radii.
inline double diameter(const Rss& v) {
    return 2 *
           (std::sqrt(squared_norm(v.half_sides[0]) + squared_norm(v.half_sides[1])) + v.radius);
}
/// Thickness: twice the radius.
inline double thickness(const Rss& v) { return 2 * v.radius; }

/// By Steiner's formula, from the rectangle's area, half its perimeter, and the radius.
inline SurfaceMeasures measures(const Rss& v) {
    using std::numbers::pi;
    const double a = std::sqrt(squared_norm(v.half_sides[0])),
                 b = std::sqrt(squared_norm(v.half_sides[1])), r = v.radius;
    const double face = 4 * a * b, half_perimeter = 2 * (a + b);
    return {2 * face + 2 * pi * r * half_perimeter + 4 * pi * r * r,
            2 * face * r + pi * r * r * half_perimeter + 4 * pi / 3 * r * r * r};
}

}  // namespace scb
