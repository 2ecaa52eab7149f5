#include "scenes/meshes/polygon.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <string>

#include "scb/error.h"

namespace scb::scenes {
namespace {

struct Point2 {
    double x = 0, y = 0;

    bool operator==(const Point2&) const = default;
};

/// Twice the signed area, > 0 if a, b, c run counterclockwise.
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
    // Rounding may turn a triangle of three collinear corners slightly backwards, which is
    // harmless.
    const double tolerance = -1e-9 * squared_norm(normal);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Vec3 a = vertices[corners[i]] - origin, b = vertices[corners[i + 1]] - origin;
        // A coordinate that is not finite makes this false, so the fan passes; check_mesh names the
        // vertex later.
        if (dot(Vec3(a.cross(b)), normal) < tolerance) return false;
    }
    return true;
}

/// The polygon projected along the coordinate axis nearest to its normal, seen against it.
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

/// Ear cutting. `steps` is the number of corners that may still be visited; it is reduced.
class EarCutter {
  public:
    EarCutter(std::span<const std::uint32_t> corners, const std::vector<Point2>& points,
              std::uint64_t& steps)
        : corners_(corners), points_(points), steps_(steps), ring_(corners.size()) {
        for (std::size_t i = 0; i < ring_.size(); ++i) ring_[i] = i;
    }

    /// Returns no triangles if a polygon without any ear is left, since it crosses itself; or if
    /// the steps do not suffice, and then no step is left.
    std::vector<Triangle> run() {
        double whole = 0;
        for (std::size_t i = 1; i + 1 < points_.size(); ++i)
            whole += area2(points_[0], points_[i], points_[i + 1]);
        std::size_t at = 0, refused = 0;
        while (ring_.size() > 3) {
            at %= ring_.size();
            if (!is_ear(at)) {
                ++at;
                if (++refused <= ring_.size()) continue;
                // Rounding leaves corners between collinear ones, which are not ears but harmless.
                const auto flat = flat_corner(1e-9 * std::abs(whole));
                if (!flat || steps_ == 0) return {};
                at = *flat;
            }
            // The search continues at the neighbour of the ear, which keeps it short.
            cut(at);
            refused = 0;
        }
        cut(1);
        return std::move(ears_);
    }

  private:
    std::size_t corner(std::size_t at) const { return ring_[at % ring_.size()]; }
    double area_at(std::size_t at) const {
        return area2(points_[corner(at + ring_.size() - 1)], points_[corner(at)],
                     points_[corner(at + 1)]);
    }
    bool is_ear(std::size_t at) {
        const std::size_t n = ring_.size(), ia = corner(at + n - 1), ib = corner(at),
                          ic = corner(at + 1);
        const Point2 &a = points_[ia], &b = points_[ib], &c = points_[ic];
        if (!(area2(a, b, c) > 0)) return false;
        for (const std::size_t k : ring_) {
            if (steps_ == 0) return false;
            --steps_;
            const Point2& p = points_[k];
            if (k == ia || k == ib || k == ic) continue;
            // A corner at the place of a corner of the ear bridges a hole; it does not block the
            // ear.
            if (p == a || p == b || p == c) continue;
            if (area2(a, b, p) >= 0 && area2(b, c, p) >= 0 && area2(c, a, p) >= 0) return false;
        }
        return true;
    }
    std::optional<std::size_t> flat_corner(double tolerance) const {
        for (std::size_t at = 0; at < ring_.size(); ++at)
            if (std::abs(area_at(at)) <= tolerance) return at;
        return std::nullopt;
    }
    void cut(std::size_t at) {
        const std::size_t n = ring_.size();
        ears_.push_back(
            {corners_[corner(at + n - 1)], corners_[corner(at)], corners_[corner(at + 1)]});
        ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
    }

    std::span<const std::uint32_t> corners_;
    const std::vector<Point2>& points_;
    std::uint64_t& steps_;
    std::vector<std::size_t> ring_;
    std::vector<Triangle> ears_;
};

}  // namespace

void PolygonCutter::append(std::span<const std::uint32_t> corners,
                           const std::vector<Vec3>& vertices, std::string_view name,
                           std::vector<Triangle>& triangles) {
    if (corners.size() > 3) {
        const Vec3 normal = area_normal(corners, vertices);
        if (!fan_covers(corners, vertices, normal)) {
            const std::vector<Point2> points = flattened(corners, vertices, normal);
            const std::vector<Triangle> ears = EarCutter(corners, points, steps_).run();
            if (steps_ == 0)
                throw InputError(std::string(name) + " is a concave polygon of " +
                                 std::to_string(corners.size()) +
                                 " corners, and up to it concave polygons take too long to cut; "
                                 "triangulate the file first.");
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
