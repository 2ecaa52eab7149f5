#include "core/distance/hull_separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace scb {
namespace {

/// A point of a simplex: how far from the origin it is, and the direction there, of any length.
struct NearestPoint {
    double distance = HUGE_VAL;
    Vec3 direction = Vec3::Zero();
    unsigned corners = 0;  ///< a bit for each corner that it is between
};

/// Up to four points.
class Simplex {
  public:
    bool contains(const Vec3& p) const {
        return std::find(points_.begin(), points_.begin() + size_, p) != points_.begin() + size_;
    }
    void add(const Vec3& p) { points_[static_cast<std::size_t>(size_++)] = p; }

    /// The point that is nearest to the origin; leaves the corners that it is between. Tries all
    /// faces: there are only 15.
    NearestPoint reduce() {
        best_ = {};
        for (unsigned i = 0; i < 4; ++i) {
            if (has(i)) take(points_[i], 1, 1u << i);
            for (unsigned j = i + 1; j < 4; ++j) {
                if (has(j)) edge(i, j);
                for (unsigned k = j + 1; k < 4; ++k)
                    if (has(k)) face(i, j, k);
            }
        }
        if (size_ == 4 && is_around_origin()) best_ = {0, Vec3::Zero(), 0xf};
        int kept = 0;
        for (unsigned i = 0; i < 4; ++i)
            if (best_.corners >> i & 1) points_[static_cast<std::size_t>(kept++)] = points_[i];
        size_ = kept;
        return best_;
    }

  private:
    bool has(unsigned i) const { return static_cast<int>(i) < size_; }

    /// A point in the given direction, whose length is that many times the point's.
    void take(const Vec3& direction, double scale, unsigned corners) {
        const double distance = std::sqrt(squared_norm(direction)) / scale;
        if (distance < best_.distance) best_ = {distance, direction, corners};
    }
    void edge(unsigned i, unsigned j) {
        const Vec3 &p = points_[i], along = points_[j] - p;
        const double squared = squared_norm(along), share = -dot(p, along) / squared;
        if (!(share > 0 && share < 1)) return;
        Vec3 nearest = p + share * along;
        nearest -= dot(nearest, along) / squared * along;
        take(nearest, 1, 1u << i | 1u << j);
    }
    void face(unsigned i, unsigned j, unsigned k) {
        const Vec3 &p = points_[i], u = points_[j] - p, v = points_[k] - p, n = cross(u, v);
        const double squared = squared_norm(n), of_u = -dot(n, cross(p, v)) / squared,
                     of_v = -dot(n, cross(u, p)) / squared;
        if (!(of_u > 0 && of_v > 0 && of_u + of_v < 1)) return;
        const double height = dot(n, p);
        if (height == 0)
            best_ = {0, Vec3::Zero(), 1u << i | 1u << j | 1u << k};
        else
            take(height < 0 ? Vec3(-n) : n, squared / std::abs(height),
                 1u << i | 1u << j | 1u << k);
    }
    /// Whether the origin is on the inner side of all four faces.
    bool is_around_origin() const {
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 &p = points_[(i + 1) % 4], u = points_[(i + 2) % 4] - p,
                       v = points_[(i + 3) % 4] - p, n = cross(u, v);
            if (!(dot(n, Vec3(points_[i] - p)) * -dot(n, p) > 0)) return false;
        }
        return true;
    }

    std::array<Vec3, 4> points_;
    int size_ = 0;
    NearestPoint best_;
};

const Vec3& farthest_along(std::span<const Vec3> points, const Vec3& n) {
    const Vec3* best = &points[0];
    double most = dot(n, *best);
    for (const Vec3& p : points.subspan(1)) {
        const double at = dot(n, p);
        if (at <= most) continue;
        most = at;
        best = &p;
    }
    return *best;
}

}  // namespace

HullSeparation separate_hulls(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& first,
                              double enough) {
    constexpr int most_steps = 32;
    HullSeparation result;
    Simplex simplex;
    Vec3 n = first;
    double widest = -HUGE_VAL;
    for (int step = 0; step < most_steps; ++step) {
        n /= n.cwiseAbs().maxCoeff();
        const Vec3 apart = farthest_along(b, -n) - farthest_along(a, n);
        const double gap = dot(n, apart) / std::sqrt(squared_norm(n));
        if (gap > widest) {
            widest = gap;
            result.direction = n;
        }
        if (gap >= enough) {
            result.verdict = HullVerdict::apart;
            break;
        }
        if (simplex.contains(apart)) break;  // rounding: there is no better direction
        simplex.add(apart);
        const NearestPoint nearest = simplex.reduce();
        if (nearest.distance < enough) {
            result.verdict = HullVerdict::nearer;
            break;
        }
        n = nearest.direction;
        if (!(n.cwiseAbs().maxCoeff() > 0)) break;
    }
    return result;
}

}  // namespace scb
