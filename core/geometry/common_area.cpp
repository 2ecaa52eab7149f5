#include "core/geometry/common_area.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scb/vec.h"

namespace scb {
namespace {

constexpr double thin = 1e-6;

double longest_edge(const TriangleCorners& t) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, (t[(i + 1) % 3] - t[i]).stableNorm());
    return most;
}

Vec3 normal_of(const TriangleCorners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// The part of a convex polygon where dot(normal, p - at) >= 0.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const Vec3& at, const Vec3& normal) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double of_p = dot(normal, Vec3(p - at)), of_q = dot(normal, Vec3(q - at));
        if (of_p >= 0) kept.push_back(p);
        if ((of_p < 0 && of_q > 0) || (of_p > 0 && of_q < 0))
            kept.emplace_back(p + of_p / (of_p - of_q) * (q - p));
    }
    return kept;
}

/// The unit normal of the larger of two triangles in one plane; none if they are not.
std::optional<Vec3> common_normal(const TriangleCorners& a, const TriangleCorners& b, double size) {
    const Vec3 of_a = normal_of(a), of_b = normal_of(b);
    const double length_a = of_a.stableNorm(), length_b = of_b.stableNorm(),
                 larger = std::max(length_a, length_b);
    if (!(std::min(length_a, length_b) > 0) || !(larger > thin * size * size)) return std::nullopt;
    const bool is_a = length_a == larger;
    const Vec3 normal = (is_a ? of_a : of_b) / larger;
    for (const Vec3& corner : is_a ? b : a)
        if (!(std::abs(dot(normal, Vec3(corner - (is_a ? a : b)[0]))) <= thin * size))
            return std::nullopt;
    return normal;
}

double longest_edge(const TriangleCorners& a, const TriangleCorners& b) {
    return std::max(longest_edge(a), longest_edge(b));
}

}  // namespace

Vec3 area_normal(const std::vector<Vec3>& polygon) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return sum;
}

bool in_one_plane(const TriangleCorners& a, const TriangleCorners& b) {
    return common_normal(a, b, longest_edge(a, b)).has_value();
}

std::vector<Vec3> common_area(const TriangleCorners& a, const TriangleCorners& b) {
    const double size = longest_edge(a, b), narrow = thin * size;
    const std::optional<Vec3> normal = common_normal(a, b, size);
    if (!normal) return {};
    // Inside is on the left of each edge of b, as seen from its front.
    const double turn = dot(*normal, normal_of(b)) < 0 ? -1 : 1;
    std::vector<Vec3> polygon(a.begin(), a.end());
    for (std::size_t i = 0; i < 3 && !polygon.empty(); ++i) {
        const Vec3 edge = b[(i + 1) % 3] - b[i];
        polygon = clipped(polygon, b[i], turn * cross(*normal, edge));
    }
    if (polygon.size() < 3) return {};
    double extent = 0;
    for (const Vec3& p : polygon) extent = std::max(extent, (p - polygon[0]).stableNorm());
    // Twice the area over its extent is about its width.
    if (!(area_normal(polygon).stableNorm() > narrow * extent)) return {};
    return polygon;
}

}  // namespace scb
