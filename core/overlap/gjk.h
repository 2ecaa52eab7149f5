#pragma once

#include <array>
#include <cmath>
#include <span>

#include "scb/vec.h"

namespace scb {

/// Up to four points of a convex set, and the point of their hull that is closest to the origin.
class Simplex {
  public:
    /// Adds a point, and drops points that do not span the closest point. False if the closest
    /// point is the origin, or no closer than before.
    bool add(const Vec3& point) {
        points_[size_] = point;
        const std::size_t last = size_;
        Candidate best;
        // The closest point is on a part of the hull with the new point; otherwise it would have
        // been found before.
        consider(best, {last}, 1);
        for (std::size_t i = 0; i < last; ++i) consider(best, {i, last}, 2);
        for (std::size_t i = 0; i < last; ++i)
            for (std::size_t j = 0; j < i; ++j) consider(best, {j, i, last}, 3);
        if (last == 3 && holds_origin()) {
            size_ = 4;
            squared_ = 0;
            closest_ = Vec3::Zero();
            return false;
        }
        if (!(best.squared < squared_)) return false;
        squared_ = best.squared;
        closest_ = best.point;
        std::array<Vec3, 4> kept;
        for (std::size_t i = 0; i < best.count; ++i) kept[i] = points_[best.which[i]];
        points_ = kept;
        size_ = best.count;
        return squared_ > 0;
    }

    const Vec3& closest() const { return closest_; }
    std::span<const Vec3> points() const { return std::span(points_).first(size_); }

  private:
    struct Candidate {
        double squared = HUGE_VAL;
        Vec3 point;
        std::array<std::size_t, 3> which;
        std::size_t count;
    };

    /// The point closest to the origin in the plane through one, two or three points, if it is
    /// between them.
    void consider(Candidate& best, const std::array<std::size_t, 3>& which,
                  std::size_t count) const {
        const Vec3& a = points_[which[0]];
        Vec3 point = a;
        if (count == 2) {
            const Vec3 ab = points_[which[1]] - a;
            const double length = squared_norm(ab), at = -dot(a, ab);
            if (!(at > 0 && at < length)) return;
            point = a + at / length * ab;
        } else if (count == 3) {
            const Vec3 ab = points_[which[1]] - a, ac = points_[which[2]] - a;
            const Vec3 normal = cross(ab, ac);
            const double area = squared_norm(normal);
            const double b = -dot(normal, cross(a, ac)), c = -dot(normal, cross(ab, a));
            if (!(area > 0 && b > 0 && c > 0 && b + c < area)) return;
            point = dot(a, normal) / area * normal;
        }
        const double squared = squared_norm(point);
        if (squared < best.squared) best = {squared, point, which, count};
    }

    /// Whether the origin is in the tetrahedron.
    bool holds_origin() const {
        const auto& [a, b, c, d] = points_;
        const auto side = [](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& other) {
            const Vec3 normal = cross(Vec3(q - p), Vec3(r - p));
            const double of_origin = -dot(p, normal), of_other = dot(Vec3(other - p), normal);
            return of_other > 0 ? of_origin >= 0 : of_other < 0 && of_origin <= 0;
        };
        return side(a, b, c, d) && side(b, c, d, a) && side(c, d, a, b) && side(d, a, b, c);
    }

    std::array<Vec3, 4> points_;
    std::size_t size_ = 0;
    Vec3 closest_ = Vec3::Zero();
    double squared_ = HUGE_VAL;
};

/// Walks to the point of a convex set that is closest to the origin (Gilbert, Johnson and Keerthi,
/// "A Fast Procedure for Computing the Distance Between Complex Objects in Three-Dimensional
/// Space", 1988). `farthest(d)` is the point of the set that is farthest along d, which is not
/// zero; the walk begins along `first`. `is_done(d, w)` receives each direction d and its farthest
/// point w. If -d.w / |d| is positive, it is a distance along d that separates the set from the
/// origin. The walk ends if `is_done` returns true, or if it comes no closer. It returns the points
/// that span the closest point.
template <class Farthest, class IsDone>
Simplex gjk(const Farthest& farthest, const Vec3& first, const IsDone& is_done) {
    constexpr int most_steps = 64;
    Simplex simplex;
    Vec3 d = first;
    for (int step = 0; step < most_steps; ++step) {
        const Vec3 w = farthest(d);
        if (is_done(d, w) || !simplex.add(w)) break;
        d = -simplex.closest();
    }
    return simplex;
}

}  // namespace scb
