#include "core/judge/triangle_cover.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace scb {
namespace {

using Polygon = std::vector<Vec3>;  // convex

/// With more pieces than this, the cover is undecided.
constexpr std::size_t most_pieces = 20'000;

/// The points x with dot(normal, x) <= offset.
struct HalfSpace {
    Vec3 normal;
    double offset = 0;
};

HalfSpace slab_plane(const Slab& slab, const Vec3& center, const Vec3& p) {
    const double along = dot(slab.n, Vec3(p - center));
    return along > slab.e ? HalfSpace{slab.n, dot(slab.n, center) + slab.e}
                          : HalfSpace{-slab.n, -dot(slab.n, center) - slab.f};
}

double beyond(const HalfSpace& half, const Vec3& p) { return dot(half.normal, p) - half.offset; }

/// The flat face that the point is farthest outside of, if any.
struct FaceBeyond {
    const Vec3& p;
    std::optional<HalfSpace> worst{};
    double most = 0;

    void take(const HalfSpace& half) {
        if (!(beyond(half, p) > most)) return;
        most = beyond(half, p);
        worst = half;
    }
    void take_axis(const Vec3& axis, double lower, double upper) {
        if (std::isfinite(upper)) take({axis, upper});
        if (std::isfinite(lower)) take({-axis, -lower});
    }

    void operator()(const Obb& box) {
        for (int i = 0; i < 3; ++i) {
            const Vec3 axis = box.axes.col(i);
            const double middle = dot(axis, box.center);
            take_axis(axis, middle - box.half[i], middle + box.half[i]);
        }
    }
    void operator()(const OpenBox& box) {
        for (int i = 0; i < 3; ++i) take_axis(Vec3::Unit(i), box.lower[i], box.upper[i]);
    }
    void operator()(const Scb& scb) { take(slab_plane({scb.n, scb.e, scb.f}, scb.c, p)); }
    void operator()(const Scb2& scb) {
        for (const Slab& slab : scb.slabs) take(slab_plane(slab, scb.c, p));
    }
    void operator()(const std::shared_ptr<const Polytope>& polytope) {
        for (const FacePlane& face : polytope->faces)
            take({face.normal, face.offset + dot(face.normal, polytope->center)});
        if (!polytope->faces.empty()) return;
        // For a hull of points: the plane that touches it at the point nearest to `p`.
        const Vec3 away = p - nearest_point(*polytope, p);
        const double length = std::sqrt(squared_norm(away));
        if (!(length > 0)) return;
        const Vec3 normal = away / length;
        double farthest = -HUGE_VAL;
        for (const Vec3& corner : polytope->corners)
            farthest = std::max(farthest, dot(normal, corner));
        take({normal, farthest + dot(normal, polytope->center)});
    }
    /// The edges of the rectangle, moved outward by the radius.
    void operator()(const Rss& v) {
        for (const Vec3& side : v.half_sides) {
            const double length = std::sqrt(squared_norm(side));
            if (!(length > 0)) continue;
            const Vec3 axis = side / length;
            const double middle = dot(axis, v.center), half = length + v.radius;
            take_axis(axis, middle - half, middle + half);
        }
    }
    void operator()(const std::monostate&) {}
    void operator()(const Ball&) {}
    void operator()(const Capsule&) {}

    /// The point of the polytope nearest to `p`. Each step goes toward the corner farthest in the
    /// direction of `p`, and shortens the distance (Gilbert, "An Iterative Procedure for Computing
    /// the Minimum of a Quadratic Form on a Convex Set", 1966).
    static Vec3 nearest_point(const Polytope& polytope, const Vec3& p) {
        Vec3 at = polytope.center + polytope.corners.front();
        for (int step = 0; step < 200; ++step) {
            const Vec3 away = p - at;
            const auto next = std::max_element(
                polytope.corners.begin(), polytope.corners.end(),
                [&](const Vec3& a, const Vec3& b) { return dot(a, away) < dot(b, away); });
            const Vec3 side = polytope.center + *next - at;
            const double gain = dot(side, away), square = squared_norm(side);
            if (!(gain > 1e-15 * square) || !(square > 0)) break;
            at += side * std::min(1.0, gain / square);
        }
        return at;
    }
};

double outside(const LeafWay& way, const Vec3& p) {
    double most = -HUGE_VAL;
    for (const NodeVolume* volume : way) most = std::max(most, excess(*volume, p));
    return most;
}

/// The parts of the polygon inside and outside of the half space; both have the points of the cut.
std::array<Polygon, 2> cut(const Polygon& polygon, const HalfSpace& half) {
    std::array<Polygon, 2> parts;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = beyond(half, p), at_q = beyond(half, q);
        if (at_p <= 0) parts[0].push_back(p);
        if (at_p >= 0) parts[1].push_back(p);
        if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
            const Vec3 between = p + (q - p) * (at_p / (at_p - at_q));
            parts[0].push_back(between);
            parts[1].push_back(between);
        }
    }
    return parts;
}

double extent(const Polygon& polygon) {
    double most = 0;
    for (const Vec3& p : polygon) most = std::max(most, squared_norm(Vec3(p - polygon[0])));
    return std::sqrt(most);
}

Vec3 middle_of(const Polygon& polygon) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : polygon) middle += p / static_cast<double>(polygon.size());
    return middle;
}

/// The half space of a cut across the middle of the longest edge.
HalfSpace halving(const Polygon& polygon) {
    Vec3 along = Vec3::Zero(), middle = polygon[0];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        if (!(squared_norm(edge) > squared_norm(along))) continue;
        along = edge;
        middle = polygon[i] + edge / 2;
    }
    const double length = std::sqrt(squared_norm(along));
    if (length > 0) along /= length;
    return {along, dot(along, middle)};
}

class Cover {
  public:
    Cover(std::span<const LeafWay> ways, double tolerance) : ways_(ways), tolerance_(tolerance) {}

    TriangleCover of(const TriangleCorners& triangle) {
        pieces_.push_back({triangle[0], triangle[1], triangle[2]});
        for (std::size_t taken = 0; !pieces_.empty(); ++taken) {
            if (taken == most_pieces) {
                found_.kind = TriangleCover::Kind::undecided;
                return found_;
            }
            const Polygon piece = std::move(pieces_.back());
            pieces_.pop_back();
            if (!take(piece)) return found_;
        }
        return found_;
    }

  private:
    /// False: the piece has a point that is in no leaf.
    bool take(const Polygon& piece) {
        const Vec3 middle = middle_of(piece);
        std::size_t of_middle = ways_.size();
        std::vector<bool> in_some(piece.size(), false);
        for (std::size_t k = 0; k < ways_.size(); ++k) {
            std::size_t inside = 0;
            for (std::size_t i = 0; i < piece.size(); ++i) {
                const bool in = outside(ways_[k], piece[i]) <= tolerance_;
                inside += in;
                in_some[i] = in_some[i] || in;
            }
            if (inside == piece.size()) return true;
            if (of_middle == ways_.size() && outside(ways_[k], middle) <= tolerance_) of_middle = k;
        }
        for (std::size_t i = 0; i < piece.size(); ++i)
            if (!in_some[i]) return leave_out(piece[i]);
        if (of_middle == ways_.size()) {
            // A point nearer to a corner may be farther outside.
            Vec3 farthest = middle;
            for (const Vec3& corner : piece)
                for (const double share : {1e-3, 0.03, 0.1, 0.3}) {
                    const Vec3 p = corner + (middle - corner) * share;
                    if (nearest_to(p).second > nearest_to(farthest).second) farthest = p;
                }
            return leave_out(farthest);
        }
        // Each corner is in a leaf within the tolerance, and no point is farther from a corner than
        // that.
        if (extent(piece) <= tolerance_) return true;
        divide(piece, ways_[of_middle]);
        return true;
    }

    bool leave_out(const Vec3& p) {
        found_.kind = TriangleCover::Kind::open;
        found_.point = p;
        std::tie(found_.nearest, found_.amount) = nearest_to(p);
        return false;
    }

    /// The way that the point is least outside of, and by how much.
    std::pair<std::size_t, double> nearest_to(const Vec3& p) const {
        std::pair<std::size_t, double> nearest{0, HUGE_VAL};
        for (std::size_t k = 0; k < ways_.size(); ++k)
            if (const double amount = outside(ways_[k], p); amount < nearest.second)
                nearest = {k, amount};
        return nearest;
    }

    /// Cuts a piece along a face of a way that contains its middle. The part cut off is outside of
    /// the way, and the rest is closer to being inside.
    void divide(const Polygon& piece, const LeafWay& way) {
        for (const Vec3& p : piece) {
            if (outside(way, p) <= tolerance_) continue;
            FaceBeyond face{p};
            for (const NodeVolume* volume : way) std::visit(face, *volume);
            if (face.most <= tolerance_) continue;
            std::array<Polygon, 2> parts = cut(piece, *face.worst);
            if (parts[0].size() < 3 || parts[1].size() < 3) continue;
            for (Polygon& part : parts) pieces_.push_back(std::move(part));
            return;
        }
        for (Polygon& part : cut(piece, halving(piece)))
            if (!part.empty()) pieces_.push_back(std::move(part));
    }

    std::span<const LeafWay> ways_;
    double tolerance_;
    std::vector<Polygon> pieces_;
    TriangleCover found_;
};

}  // namespace

TriangleCover cover_of(const TriangleCorners& triangle, std::span<const LeafWay> ways,
                       double tolerance) {
    return Cover(ways, tolerance).of(triangle);
}

}  // namespace scb
