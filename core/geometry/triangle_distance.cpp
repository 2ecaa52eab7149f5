#include "core/geometry/triangle_segment.h"

#include <algorithm>
#include <cmath>

namespace scb {
namespace {

double clamped_share(double part, double whole) {
    return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0;
}

double squared_distance(const Vec3& p, const Vec3& q) { return squared_norm(Vec3(p - q)); }

/// The squared distance of a point and the segment from s to t.
double squared_distance(const Vec3& p, const Vec3& s, const Vec3& t) {
    const Vec3 along = t - s;
    return squared_distance(
        p, Vec3(s + clamped_share(dot(Vec3(p - s), along), squared_norm(along)) * along));
}

/// The squared distance of the segments from p to q and from s to t: between the closest points of
/// their lines if both are on the segments, else at an end of one.
double squared_distance(const Vec3& p, const Vec3& q, const Vec3& s, const Vec3& t) {
    double least = std::min({squared_distance(p, s, t), squared_distance(q, s, t),
                             squared_distance(s, p, q), squared_distance(t, p, q)});
    const Vec3 u = q - p, v = t - s, w = p - s;
    const double uu = squared_norm(u), vv = squared_norm(v), uv = dot(u, v);
    const double determinant = uu * vv - uv * uv;
    if (determinant > 0) {
        const double of_u = (uv * dot(v, w) - vv * dot(u, w)) / determinant,
                     of_v = (uu * dot(v, w) - uv * dot(u, w)) / determinant;
        if (of_u > 0 && of_u < 1 && of_v > 0 && of_v < 1)
            least = std::min(least, squared_distance(Vec3(p + of_u * u), Vec3(s + of_v * v)));
    }
    return least;
}

/// The squared distance of a point and a triangle if the point is above its inside; else infinity,
/// since then an edge is as close.
double squared_distance_above(const Vec3& p, const TriangleCorners& t) {
    const Vec3 normal = cross(Vec3(t[1] - t[0]), Vec3(t[2] - t[0]));
    for (std::size_t k = 0; k < 3; ++k)
        if (!(dot(cross(normal, Vec3(t[(k + 1) % 3] - t[k])), Vec3(p - t[k])) >= 0))
            return HUGE_VAL;
    const double length = std::sqrt(squared_norm(normal));
    if (!(length > 0)) return HUGE_VAL;
    const double height = dot(normal, Vec3(p - t[0])) / length;
    return height * height;
}

/// The overlap of the extents along a direction, the smaller of both sides; infinity if the
/// direction is 0.
double overlap_along(const Vec3& direction, const TriangleCorners& a, const TriangleCorners& b) {
    const double length = std::sqrt(squared_norm(direction));
    if (!(length > 0)) return HUGE_VAL;
    const auto ends = [&](const TriangleCorners& t) {
        // Relative to one of the corners, so that little precision is lost far from the origin.
        const auto at = [&](const Vec3& p) { return dot(direction, Vec3(p - a[0])); };
        return std::minmax({at(t[0]), at(t[1]), at(t[2])});
    };
    const auto [least_a, most_a] = ends(a);
    const auto [least_b, most_b] = ends(b);
    return std::min(most_a - least_b, most_b - least_a) / length;
}

}  // namespace

double triangle_gap(const TriangleCorners& a, const TriangleCorners& b) {
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < 3; ++i) {
        least = std::min({least, squared_distance_above(a[i], b), squared_distance_above(b[i], a)});
        for (std::size_t j = 0; j < 3; ++j)
            least = std::min(least, squared_distance(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
    }
    return std::sqrt(least);
}

double triangle_depth(const TriangleCorners& a, const TriangleCorners& b) {
    const auto edge = [](const TriangleCorners& t, std::size_t k) {
        return Vec3(t[(k + 1) % 3] - t[k]);
    };
    double least = std::min(overlap_along(cross(edge(a, 0), edge(a, 1)), a, b),
                            overlap_along(cross(edge(b, 0), edge(b, 1)), a, b));
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            least = std::min(least, overlap_along(cross(edge(a, i), edge(b, j)), a, b));
    return std::isfinite(least) ? std::max(least, 0.0) : 0;
}

}  // namespace scb
