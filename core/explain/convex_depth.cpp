#include "core/explain/exact_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <vector>

namespace scb {
namespace {

/// A direction, and the point of the cores' difference that is farthest along it.
struct Corner {
    Vec3 direction, point;
};

struct Triangle {
    double bound;
    std::size_t number;  // if bounds are equal, the older triangle is first
    std::array<Corner, 3> corners;

    bool operator<(const Triangle& other) const {  // for a heap with the greatest on top
        return bound != other.bound ? bound > other.bound : number > other.number;
    }
};

class Search {
  public:
    Search(const ConvexShape& a, const ConvexShape& b)
        : a_(a), b_(b), to_b_(b.center - a.center), rounding_(a.rounding + b.rounding) {}

    double run(const DepthSearch& search) {
        constexpr std::array<double, 2> sides = {1, -1};
        for (const double x : sides)
            for (const double y : sides)
                for (const double z : sides)
                    push({corner(Vec3(x, 0, 0)), corner(Vec3(0, y, 0)), corner(Vec3(0, 0, z))},
                         -HUGE_VAL);
        while (true) {
            const Triangle lowest = open_.top();
            if (lowest.bound > search.enough || directions_ >= search.most_directions ||
                least_ <= 0 || lowest.bound >= (1 - search.accuracy) * least_)
                return lowest.bound;
            open_.pop();
            const auto& [p, q, r] = lowest.corners;
            const Corner pq = between(p, q), qr = between(q, r), rp = between(r, p);
            push({p, pq, rp}, lowest.bound);
            push({q, qr, pq}, lowest.bound);
            push({r, rp, qr}, lowest.bound);
            push({pq, qr, rp}, lowest.bound);
        }
    }

  private:
    Corner corner(const Vec3& d) {
        ++directions_;
        const Corner result{d, a_.support_point(d) - to_b_ - b_.support_point(Vec3(-d))};
        least_ = std::min(least_, dot(d, result.point) + rounding_);
        return result;
    }
    Corner between(const Corner& p, const Corner& q) {
        const Vec3 sum = p.direction + q.direction;
        return corner(sum / std::sqrt(squared_norm(sum)));
    }
    void push(const std::array<Corner, 3>& corners, double bound_before) {
        double most = -HUGE_VAL;
        for (const Corner& of : corners) {
            double least = HUGE_VAL;
            for (const Corner& along : corners)
                least = std::min(least, dot(along.direction, of.point));
            most = std::max(most, least);
        }
        // A unit direction in the triangle is a weighted sum of the corners. The sum of the weights
        // is at least 1, and at most 1 / the distance of the plane through the corners.
        if (most < 0) most /= plane_distance(corners);
        open_.push({std::max(bound_before, most + rounding_), next_++, corners});
    }

    static double plane_distance(const std::array<Corner, 3>& corners) {
        const Vec3& p = corners[0].direction;
        const Vec3 normal = cross(Vec3(corners[1].direction - p), Vec3(corners[2].direction - p));
        const double length = std::sqrt(squared_norm(normal));
        constexpr double least_of_octants = 0.577;
        return length > 0 ? std::max(least_of_octants, std::abs(dot(p, normal)) / length)
                          : least_of_octants;
    }

    const ConvexShape &a_, &b_;
    const Vec3 to_b_;
    const double rounding_;
    std::priority_queue<Triangle> open_;
    std::size_t next_ = 0;
    double least_ = HUGE_VAL;
    int directions_ = 0;
};

}  // namespace

double least_depth(const ConvexShape& a, const ConvexShape& b, const DepthSearch& search) {
    return Search(a, b).run(search);
}

}  // namespace scb
