#include "scenes/meshes/polygon.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "scb/error.h"

namespace scb::scenes {
namespace {

struct Point2 {
    double x = 0, y = 0;
};

/// Twice the signed area, > 0 where a, b, c run counterclockwise.
double area2(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Newell's normal: the sum of the cross products about the first corner, twice the area long.
Vec3 area_normal(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices) {
    const Vec3& origin = vertices[corners[0]];
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Vec3 a = vertices[corners[i]] - origin, b = vertices[corners[i + 1]] - origin;
        normal += a.cross(b);
    }
    return normal;
}

bool fan_covers(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices,
                const Vec3& normal) {
    const Vec3& origin = vertices[corners[0]];
    // Rounding may turn a triangle of three collinear corners slightly backwards; that harms
    // nobody.
    const double tolerance = -1e-9 * squared_norm(normal);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Vec3 a = vertices[corners[i]] - origin, b = vertices[corners[i + 1]] - origin;
        // A coordinate that is not finite makes this false, so the fan passes; check_mesh names the
        // vertex later.
        if (dot(Vec3(a.cross(b)), normal) < tolerance) return false;
    }
    return true;
}

/// The polygon seen against its normal, along the coordinate axis nearest to it.
std::vector<Point2> flattened(std::span<const std::uint32_t> corners,
                              const std::vector<Vec3>& vertices, const Vec3& normal) {
    Eigen::Index drop = 0;
    normal.cwiseAbs().maxCoeff(&drop);
    const Eigen::Index u = (drop + 1) % 3, v = (drop + 2) % 3;
    std::vector<Point2> points;
    for (const std::uint32_t corner : corners) {
        const Vec3& p = vertices[corner];
        points.push_back(normal[drop] > 0 ? Point2{p[u], p[v]} : Point2{p[v], p[u]});
    }
    return points;
}

/// Ear cutting. Returns no triangles where a polygon without any ear is left over: it crosses
/// itself.
std::vector<Triangle> cut_ears(std::span<const std::uint32_t> corners,
                               const std::vector<Point2>& points) {
    std::vector<std::size_t> ring(corners.size());
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = i;
    std::vector<Triangle> ears;
    std::size_t at = 0, refused = 0;
    while (ring.size() > 3) {
        if (refused > ring.size()) return {};
        const std::size_t n = ring.size(), ia = ring[(at + n - 1) % n], ib = ring[at % n],
                          ic = ring[(at + 1) % n];
        const Point2 &a = points[ia], &b = points[ib], &c = points[ic];
        bool ear = area2(a, b, c) > 0;
        for (std::size_t k = 0; ear && k < n; ++k) {
            const Point2& p = points[ring[k]];
            if (ring[k] == ia || ring[k] == ib || ring[k] == ic) continue;
            // A corner at the place of an ear's end is where a hole is bridged; it does not block
            // the ear.
            if ((p.x == a.x && p.y == a.y) || (p.x == c.x && p.y == c.y)) continue;
            ear = !(area2(a, b, p) >= 0 && area2(b, c, p) >= 0 && area2(c, a, p) >= 0);
        }
        if (!ear) {
            at = (at + 1) % n;
            ++refused;
            continue;
        }
        ears.push_back({corners[ia], corners[ib], corners[ic]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at % n));
        // Staying at the neighbour of the ear keeps the search short.
        at %= ring.size();
        refused = 0;
    }
    ears.push_back({corners[ring[0]], corners[ring[1]], corners[ring[2]]});
    return ears;
}

}  // namespace

void append_polygon(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices,
                    std::string_view name, std::vector<Triangle>& triangles) {
    if (corners.size() > 3) {
        const Vec3 normal = area_normal(corners, vertices);
        if (!fan_covers(corners, vertices, normal)) {
            // Ear cutting takes time up to the cube of the corners.
            constexpr std::size_t most_corners = 2000;
            if (corners.size() > most_corners)
                throw InputError(std::string(name) + " is a concave polygon of " +
                                 std::to_string(corners.size()) + " corners; at most " +
                                 std::to_string(most_corners) +
                                 " are cut here, so triangulate the file first.");
            const std::vector<Triangle> ears =
                cut_ears(corners, flattened(corners, vertices, normal));
            if (!ears.empty()) {
                triangles.insert(triangles.end(), ears.begin(), ears.end());
                return;
            }
        }
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

}  // namespace scb::scenes
