#include <algorithm>
#include <cmath>

#include "core/explain/exact_overlap.h"
#include "core/overlap/gjk.h"

namespace scb {
namespace {

/// The weights with which up to four points make the point of their hull closest to the origin;
/// each point is needed, see Simplex.
std::array<double, 4> weights_of(std::span<const Vec3> p) {
    std::array<double, 4> w = {1, 0, 0, 0};
    if (p.size() < 2) return w;
    const Vec3 a = p[1] - p[0];
    if (p.size() == 2) {
        w[1] = -dot(a, p[0]) / squared_norm(a);
    } else {
        const Vec3 b = p[2] - p[0], normal = cross(a, b);
        if (p.size() == 3) {
            w[1] = -dot(normal, cross(p[0], b)) / squared_norm(normal);
            w[2] = -dot(normal, cross(a, p[0])) / squared_norm(normal);
        } else {
            const Vec3 c = p[3] - p[0];
            const double sixfold = dot(c, normal);
            w[1] = -dot(p[0], cross(b, c)) / sixfold;
            w[2] = -dot(p[0], cross(c, a)) / sixfold;
            w[3] = -dot(p[0], normal) / sixfold;
        }
    }
    double sum = 0;
    for (std::size_t i = 1; i < 4; ++i) {
        w[i] = std::isfinite(w[i]) ? std::clamp(w[i], 0.0, 1.0) : 0;
        sum += w[i];
    }
    w[0] = std::max(0.0, 1 - sum);
    return w;
}

/// The closest points of two cores, from the center of A, and the direction with the largest proven
/// gap between the cores.
struct ClosestPoints {
    Vec3 of_a, of_b;
    Vec3 direction = Vec3::Zero();
    double gap = -HUGE_VAL;
};

ClosestPoints closest_points(const ConvexShape& a, const ConvexShape& b) {
    const Vec3 to_b = b.center - a.center;
    struct Pair {
        Vec3 difference, of_a, of_b;
    };
    std::vector<Pair> met;
    const auto farthest = [&](const Vec3& d) {
        const Vec3 of_a = a.support_point(d), of_b = to_b + b.support_point(Vec3(-d));
        met.push_back({of_a - of_b, of_a, of_b});
        return met.back().difference;
    };
    ClosestPoints result;
    const auto is_done = [&](const Vec3& d, const Vec3& w) {
        const double length = std::sqrt(squared_norm(d)), gap = -dot(d, w) / length;
        if (gap > result.gap) {
            result.gap = gap;
            result.direction = d / length;
        }
        return false;
    };
    const Simplex simplex =
        gjk(farthest, squared_norm(to_b) > 0 ? to_b : Vec3(Vec3::UnitX()), is_done);
    const std::array<double, 4> weights = weights_of(simplex.points());
    result.of_a = result.of_b = Vec3::Zero();
    for (std::size_t i = 0; i < simplex.points().size(); ++i) {
        const auto pair = std::find_if(met.begin(), met.end(), [&](const Pair& p) {
            return p.difference == simplex.points()[i];
        });
        result.of_a += weights[i] * pair->of_a;
        result.of_b += weights[i] * pair->of_b;
    }
    return result;
}

/// How far the point, relative to the center, is outside of the shape.
double outside(const ConvexShape& shape, const Vec3& point) {
    const ConvexShape single{shape.center + point, 0, Mat3::Identity(),
                             [](const Vec3&) { return Vec3(0, 0, 0); }};
    return closest_points(shape, single).gap - shape.rounding;
}

}  // namespace

double proven_gap(const ConvexShape& a, const ConvexShape& b, const Vec3& direction) {
    return dot(direction, Vec3(b.center - a.center)) - support(a, direction) -
           support(b, Vec3(-direction));
}

double proven_depth(const ConvexShape& a, const ConvexShape& b, const Vec3& point) {
    const double slop = 1e-12 * std::max(diameter(a), diameter(b));
    if (outside(a, point) > slop || outside(b, Vec3(point - (b.center - a.center))) > slop)
        return 0;
    return least_depth(a, b, {HUGE_VAL});
}

ContactCertificate exact_overlap(const ConvexShape& a, const ConvexShape& b, double tolerance) {
    const double least = tolerance * std::max(diameter(a), diameter(b)) / 2;
    const ClosestPoints closest = closest_points(a, b);
    const double rounding = a.rounding + b.rounding;
    ContactCertificate certificate;
    if (closest.gap - rounding > least) {
        certificate.contact = Contact::disjoint;
        certificate.direction = closest.direction;
        certificate.margin = proven_gap(a, b, closest.direction);
        return certificate;
    }
    // Balls about the closest points prove that most rounded volumes overlap, with a slightly
    // smaller depth so that least_depth confirms it. Else the search, which need not be long.
    const double between = std::sqrt(squared_norm(Vec3(closest.of_b - closest.of_a)));
    const double of_balls = 0.9 * (rounding - between);
    const double depth = of_balls > least ? of_balls : least_depth(a, b, {least, 0.01, 1500});
    if (depth > least) {
        certificate.contact = Contact::overlapping;
        certificate.margin = depth;
        const double share = rounding > 0 ? a.rounding / rounding : 0.5;
        certificate.point = closest.of_a + share * (closest.of_b - closest.of_a);
    }
    return certificate;
}

}  // namespace scb
