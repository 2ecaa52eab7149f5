#include "scb/triangle_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/geometry/triangle_segment.h"

namespace scb {
namespace {

/// Two points, and their squared distance.
struct PointPair {
    Vec3 p, q;
    double squared = HUGE_VAL;

    PointPair() = default;
    PointPair(const Vec3& of_a, const Vec3& of_b)
        : p(of_a), q(of_b), squared(squared_norm(Vec3(of_a - of_b))) {}
    PointPair reversed() const {
        PointPair pair = *this;
        std::swap(pair.p, pair.q);
        return pair;
    }
};

bool is_before(const Vec3& p, const Vec3& q) {
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
}

/// A triangle whose corners are in the order of their coordinates.
struct OrderedTriangle {
    TriangleCorners corners;

    explicit OrderedTriangle(const TriangleCorners& given) : corners(given) {
        std::sort(corners.begin(), corners.end(), is_before);
    }
    const Vec3& corner(std::size_t i) const { return corners[i]; }
    /// The ends of edge i, in their order.
    std::pair<Vec3, Vec3> edge(std::size_t i) const {
        return {corners[i == 2 ? 1 : 0], corners[i == 0 ? 1 : 2]};
    }
};

/// The edge from `from` on.
struct Edge {
    Vec3 from, along;
    double squared_length;

    explicit Edge(const std::pair<Vec3, Vec3>& ends)
        : from(ends.first), along(ends.second - ends.first), squared_length(squared_norm(along)) {}
    Vec3 at(double share) const { return from + share * along; }
    /// The share at which the line of the edge is nearest to a point.
    double nearest(const Vec3& point) const {
        const double share = dot(Vec3(point - from), along) / squared_length;
        return share + dot(Vec3(point - at(share)), along) / squared_length;
    }
};

bool is_inside(double share) { return share > 0 && share < 1; }

/// A point and the inside of an edge; infinitely far if an end of the edge is as close.
PointPair closest(const Vec3& point, const Edge& edge) {
    const double share = edge.squared_length > 0 ? edge.nearest(point) : 0;
    return is_inside(share) ? PointPair(point, edge.at(share)) : PointPair();
}

/// The insides of two edges; infinitely far if a corner is as close.
PointPair closest(const Edge& a, const Edge& b) {
    // The determinant of the two products is less exact than their cross product, where edges are
    // nearly parallel.
    const Vec3 normal = cross(a.along, b.along);
    const double squared = squared_norm(normal);
    if (!(squared > 0)) return {};
    const double share = dot(normal, cross(b.along, Vec3(a.from - b.from))) / squared;
    if (!is_inside(share)) return {};
    const double of_b = b.nearest(a.at(share));
    if (!is_inside(of_b)) return {};
    const double of_a = a.nearest(b.at(of_b));
    return is_inside(of_a) ? PointPair(a.at(of_a), b.at(of_b)) : PointPair();
}

/// A triangle's inside, by its longest edge and the height on it.
class Face {
  public:
    Face(const OrderedTriangle& t, const std::array<Edge, 3>& edges) {
        std::size_t longest = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (edges[i].squared_length > edges[longest].squared_length) longest = i;
        from_ = edges[longest].from;
        apex_ = t.corner(2 - longest);
        along_ = edges[longest].along;
        squared_length_ = edges[longest].squared_length;
        if (!(squared_length_ > 0)) return;
        // Twice: a needle's apex is nearly on the edge.
        height_ = apex_ - from_;
        for (int k = 0; k < 2; ++k) height_ -= dot(height_, along_) / squared_length_ * along_;
        foot_ = dot(Vec3(apex_ - from_), along_) / squared_length_;
        squared_height_ = squared_norm(height_);
    }

    /// A point and the inside of the face; infinitely far if an edge is as close.
    PointPair closest(const Vec3& point) const {
        if (!(squared_height_ > 0)) return {};
        Vec3 shares = Vec3::Zero();  // of the apex, the first and the second end of the edge
        Vec3 rest = point - from_;
        for (int k = 0; k < 2; ++k) {
            const double of_apex = dot(rest, height_) / squared_height_,
                         of_end = dot(rest, along_) / squared_length_ - of_apex * foot_;
            shares[0] += of_apex;
            shares[2] += of_end;
            rest = point - at(shares);
        }
        shares[1] = 1 - shares[0] - shares[2];
        if (!(shares.minCoeff() > 0)) return {};
        return {point, at(shares)};
    }

  private:
    Vec3 at(const Vec3& shares) const {
        return from_ + shares[0] * Vec3(apex_ - from_) + shares[2] * along_;
    }

    Vec3 from_, apex_, along_, height_ = Vec3::Zero();
    double squared_length_ = 0, squared_height_ = 0, foot_ = 0;
};

/// The closest features; of equal distances the first. Triangles that intersect may have a positive
/// distance here, since an edge goes through a face.
PointPair closest_features(const TriangleCorners& given_a, const TriangleCorners& given_b) {
    const OrderedTriangle a(given_a), b(given_b);
    PointPair best;
    const auto take = [&best](const PointPair& pair) {
        if (pair.squared < best.squared) best = pair;
    };
    const std::array<Edge, 3> edges_a = {Edge(a.edge(0)), Edge(a.edge(1)), Edge(a.edge(2))},
                              edges_b = {Edge(b.edge(0)), Edge(b.edge(1)), Edge(b.edge(2))};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            take({a.corner(i), b.corner(j)});
            take(closest(a.corner(i), edges_b[j]));
            take(closest(b.corner(j), edges_a[i]).reversed());
            take(closest(edges_a[i], edges_b[j]));
        }
    const Face face_a(a, edges_a), face_b(b, edges_b);
    for (std::size_t i = 0; i < 3; ++i) {
        take(face_b.closest(a.corner(i)));
        take(face_a.closest(b.corner(i)).reversed());
    }
    return best;
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

TriangleDistance triangle_distance(const TriangleCorners& a, const TriangleCorners& b) {
    if (const auto common = triangles_intersection(a, b)) {
        const Vec3 point = (common->a + common->b) / 2;
        return {0, point, point};
    }
    const PointPair closest = closest_features(a, b);
    double distance = std::sqrt(closest.squared);
    // The square of a small distance may underflow.
    if (!(distance > 0)) distance = (closest.p - closest.q).cwiseAbs().maxCoeff();
    return {std::max(distance, std::numeric_limits<double>::denorm_min()), closest.p, closest.q};
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
