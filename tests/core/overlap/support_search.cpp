#include "tests/core/overlap/support_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scb {
namespace {

// A farthest point in a unit direction, from c: of the ball, or of the circle or disc that a plane
// leaves of it.
Vec3 farthest_point(const Scb& s, const Vec3& direction) {
    const double top = s.r * s.n.dot(direction);
    // Not of a disc: that which is a pole of the ball has no other point, although the height of
    // those around it is the same, as far as numbers can tell.
    if (s.f < s.e && s.f <= top && top <= s.e) return s.r * direction;
    const double height = top > s.e ? s.e : s.f;
    Vec3 level = direction - s.n.dot(direction) * s.n;
    level -= s.n.dot(level) * s.n;
    const double length = level.norm();
    const double rim = std::sqrt(std::max(0.0, (s.r - height) * (s.r + height)));
    return length > 0 ? Vec3(height * s.n + rim / length * level) : Vec3(height * s.n);
}

// Up to four points; of the mean that is closest to the origin, the weights.
struct Simplex {
    std::array<Vec3, 4> corners;
    std::array<double, 4> weights{};
    int size = 0;

    Vec3 mean(const Vec3& origin) const {
        Vec3 sum = Vec3::Zero();
        for (int i = 0; i < size; ++i)
            sum += weights[static_cast<std::size_t>(i)] *
                   (corners[static_cast<std::size_t>(i)] - origin);
        return sum;
    }
};

// The weights, not all positive perhaps, with which the corners have the mean that is closest to
// the origin of all points of the line, plane or space through them. False where they are not in
// general position.
bool solve(Simplex& s, const Vec3& origin) {
    const Vec3 a = s.corners[0] - origin;
    switch (s.size) {
        case 1:
            s.weights[0] = 1;
            return true;
        case 2: {
            const Vec3 u = s.corners[1] - s.corners[0];
            const double square = u.squaredNorm();
            s.weights[1] = -a.dot(u) / square;
            s.weights[0] = 1 - s.weights[1];
            return square > 0;
        }
        case 3: {
            const Vec3 u = s.corners[1] - s.corners[0], v = s.corners[2] - s.corners[0],
                       normal = cross(u, v);
            const double square = normal.squaredNorm();
            s.weights[1] = -normal.dot(cross(a, v)) / square;
            s.weights[2] = -normal.dot(cross(u, a)) / square;
            s.weights[0] = 1 - s.weights[1] - s.weights[2];
            return square > 0;
        }
        default: {
            const Vec3 u = s.corners[1] - s.corners[0], v = s.corners[2] - s.corners[0],
                       w = s.corners[3] - s.corners[0];
            const double volume = u.dot(cross(v, w));
            s.weights[1] = -a.dot(cross(v, w)) / volume;
            s.weights[2] = -u.dot(cross(a, w)) / volume;
            s.weights[3] = -u.dot(cross(v, a)) / volume;
            s.weights[0] = 1 - s.weights[1] - s.weights[2] - s.weights[3];
            return volume != 0;
        }
    }
}

bool is_mean(const Simplex& s) {
    return std::all_of(s.weights.begin(), s.weights.begin() + s.size,
                       [](double weight) { return weight >= 0; });
}

// The face of the simplex that holds its closest point, given that the last corner takes part.
// False where no face has one.
bool reduce(Simplex& simplex, const Vec3& origin, Vec3& closest) {
    const int others = simplex.size - 1;
    const auto last = static_cast<std::size_t>(others);
    Simplex best;
    double least = HUGE_VAL;
    for (int mask = 0; mask < 1 << others; ++mask) {
        Simplex face;
        face.corners[0] = simplex.corners[last];
        face.size = 1;
        for (int i = 0; i < others; ++i)
            if (mask >> i & 1)
                face.corners[static_cast<std::size_t>(face.size++)] =
                    simplex.corners[static_cast<std::size_t>(i)];
        if (!solve(face, origin) || !is_mean(face)) continue;
        const Vec3 mean = face.mean(origin);
        const double square = mean.squaredNorm();
        if (square >= least) continue;
        least = square;
        closest = mean;
        best = face;
    }
    simplex = best;
    return best.size > 0;
}

struct Bounds {
    double lower = -HUGE_VAL, upper = HUGE_VAL;
};

class Search {
  public:
    Search(const Scb& a, const Scb& b) : a_(a), b_(b), apart_(b.c - a.c) {}

    // How far the set is from the point, until that is known to be more than `enough`, or no more
    // than `reached`. Begins with the simplex that the search before ended with.
    Bounds distance(const Vec3& point, double enough, double reached) {
        Bounds bounds;
        Vec3 closest;
        if (!start(point, closest)) return bounds;
        for (int idle = 0; idle < 4; ++idle) {
            const double length = closest.norm();
            if (length < bounds.upper) {
                bounds.upper = length;
                idle = 0;
            }
            if (length <= reached) break;
            const Vec3 direction = direction_of(closest), corner = nearest(direction);
            if (const double room = direction.dot(corner - point); room > bounds.lower) {
                bounds.lower = room;
                idle = 0;
            }
            if (bounds.lower > enough || simplex_.size == 4) break;
            simplex_.corners[static_cast<std::size_t>(simplex_.size++)] = corner;
            if (!reduce(simplex_, point, closest)) break;
        }
        return bounds;
    }

    // Whether the set holds the ball about the origin, as the corners of a regular tetrahedron
    // about it show, each up to a tenth of the radius.
    bool holds_ball(double radius) {
        const Simplex about_origin = simplex_;
        const double reached = 0.1 * radius, corner = std::sqrt(3.0) * (radius + reached);
        for (const Vec3& signs : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)})
            if (distance(corner * signs, 0, reached).upper > reached) {
                simplex_ = about_origin;
                return false;
            }
        return true;
    }

  private:
    const Scb &a_, &b_;
    const Vec3 apart_;  // from the center of A to the center of B
    Simplex simplex_;

    // The difference that is farthest against the direction.
    Vec3 nearest(const Vec3& direction) const {
        return apart_ + farthest_point(b_, -direction) - farthest_point(a_, direction);
    }

    // From the origin to the closest point of the simplex. Where that is near, its own digits are
    // too few, but the simplex has others: the direction is across all of its edges.
    Vec3 direction_of(const Vec3& closest) const {
        const auto& corners = simplex_.corners;
        Vec3 across = closest;
        if (simplex_.size == 3) {
            across = cross(Vec3(corners[1] - corners[0]), Vec3(corners[2] - corners[0]));
            if (across.dot(closest) < 0) across = -across;
        } else if (simplex_.size == 2) {
            const Vec3 edge = (corners[1] - corners[0]).normalized();
            across -= across.dot(edge) * edge;
        }
        const double length = across.norm();
        return length > 0 ? Vec3(across / length) : Vec3(closest.normalized());
    }

    // The closest point of the simplex so far, in which its last corner need not take part.
    bool start(const Vec3& point, Vec3& closest) {
        if (simplex_.size == 0) {
            simplex_.corners[0] =
                nearest(apart_.norm() > 0 ? Vec3(apart_.normalized()) : Vec3::UnitX());
            simplex_.size = 1;
        }
        if (solve(simplex_, point) && is_mean(simplex_)) {
            closest = simplex_.mean(point);
            return true;
        }
        simplex_.size = 1;
        return reduce(simplex_, point, closest);
    }
};

}  // namespace

SupportBounds search_supports(const Scb& a, const Scb& b, double enough,
                              std::initializer_list<double> depths) {
    Search search(a, b);
    const Bounds bounds = search.distance(Vec3::Zero(), enough, 0.1 * std::min(depths));
    SupportBounds result{bounds.lower, bounds.upper, 0};
    if (bounds.lower > 0) return result;
    for (const double depth : depths) {
        if (!search.holds_ball(depth)) continue;
        result.depth = depth;
        break;
    }
    return result;
}

}  // namespace scb
