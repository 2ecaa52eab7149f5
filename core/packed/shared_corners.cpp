#include "core/packed/shared_corners.h"

#include <algorithm>
#include <cmath>

namespace scb {

bool is_farthest_corner(const TriangleCorners& t, const Vec3& u, const Vec3& v, double scale) {
    const auto at = std::find(t.begin(), t.end(), u);
    if (at == t.end()) return false;
    const auto i = static_cast<std::size_t>(at - t.begin());
    const Vec3 e = t[(i + 1) % 3] - u, f = t[(i + 2) % 3] - u;
    const double vv = squared_norm(v), ee = squared_norm(e), ff = squared_norm(f),
                 smallest = 0x1p-40 * scale * scale;
    const auto is_behind = [&](double along, double squared) {
        return along < 0 && along * along >= 0x1p-20 * vv * squared;
    };
    return std::min({vv, ee, ff}) >= smallest && is_behind(dot(v, e), ee) &&
           is_behind(dot(v, f), ff) && squared_norm(cross(e, f)) >= 0x1p-24 * ee * ff;
}

bool is_distance_of_corners(const TriangleCorners& a, const TriangleCorners& b,
                            const TriangleDistance& nearest) {
    double scale = 0;
    for (const TriangleCorners& t : {a, b})
        for (const Vec3& corner : t) scale = std::max(scale, corner.cwiseAbs().maxCoeff());
    const Vec3 v = nearest.point_b - nearest.point_a;
    return is_farthest_corner(a, nearest.point_a, v, scale) &&
           is_farthest_corner(b, nearest.point_b, Vec3(-v), scale);
}

}  // namespace scb
