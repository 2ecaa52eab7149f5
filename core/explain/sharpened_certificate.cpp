#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>

#include "core/explain/exact_overlap.h"

namespace scb {
namespace {

/// Climbs from a direction or a point until no step of a shrinking size is better. `scale` is the
/// size of the first steps, `value(x)` is maximized, `step(x, s)` is the result of a step.
template <class Value, class Step>
void climb(Vec3& x, double& best, double scale, const Value& value, const Step& step) {
    // The edges and corners of a cube: enough directions for a value with creases.
    constexpr int rounds = 1000;
    double size = scale;
    for (int round = 0; round < rounds && size > 1e-13 * scale; ++round) {
        Vec3 chosen = x;
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                for (int k = -1; k <= 1; ++k) {
                    const Vec3 candidate = step(x, Vec3(size * Vec3(i, j, k)));
                    const double v = value(candidate);
                    if (v > best) {
                        best = v;
                        chosen = candidate;
                    }
                }
        if (chosen == x) size /= 2;
        x = chosen;
    }
}

/// The distance from the point to the slab, along its normal. `point` is from the center.
double miss(const Scb& s, const Vec3& point) {
    const double height = dot(s.n, point);
    return std::clamp(height, s.f, s.e) - height;
}

/// A point near this one that is in both slabs, if possible; from the center of A.
Vec3 pulled_in(const Scb& a, const Scb& b, const Vec3& point, double slop) {
    const Vec3 to_b = b.c - a.c;
    const double from_a = miss(a, point), from_b = miss(b, point - to_b);
    const Vec3 in_a = point + from_a * a.n, in_b = point + from_b * b.n;
    if (std::abs(miss(b, in_a - to_b)) <= slop) return in_a;
    if (std::abs(miss(a, in_b)) <= slop) return in_b;
    // Along both normals at once.
    const double squared_sine = squared_norm(cross(a.n, b.n)), cosine = dot(a.n, b.n);
    if (!(squared_sine > 1e-24)) return point;
    return point + (from_a - cosine * from_b) / squared_sine * a.n +
           (from_b - cosine * from_a) / squared_sine * b.n;
}

/// Moves to the slabs of each volume in turn, and into its ball.
Vec3 pulled_in(const Scb2& a, const Scb2& b, Vec3 point, double) {
    const Vec3 to_b = b.c - a.c;
    const auto nearest = [](const Scb2& s, Vec3 from_center) {
        for (const Slab& slab : s.slabs) {
            const double height = dot(slab.n, from_center);
            from_center += (std::clamp(height, slab.f, slab.e) - height) * slab.n;
        }
        const double distance = std::sqrt(squared_norm(from_center));
        return distance > s.r ? Vec3(s.r / distance * from_center) : from_center;
    };
    for (int turn = 0; turn < 8; ++turn) point = to_b + nearest(b, nearest(a, point) - to_b);
    return point;
}

Vec3 pulled_in(const Ball&, const Ball&, const Vec3& point, double) { return point; }

Vec3 pulled_in(const Obb& a, const Obb& b, Vec3 point, double) {
    const Vec3 to_b = b.center - a.center;
    const auto nearest = [](const Obb& box, const Vec3& from_center) {
        Vec3 result = Vec3::Zero();
        for (int i = 0; i < 3; ++i) {
            const Vec3 axis = box.axes.col(i);
            result += std::clamp(dot(axis, from_center), -box.half[i], box.half[i]) * axis;
        }
        return result;
    };
    for (int turn = 0; turn < 8; ++turn) point = to_b + nearest(b, nearest(a, point) - to_b);
    return point;
}

/// The distance of a point from the farther one of the two volumes; for SCBs from their slabs,
/// since proven_depth proves no depth outside of a ball.
double outside(const Scb& a, const Scb& b, const Vec3& point) {
    return std::max(std::abs(miss(a, point)), std::abs(miss(b, point - (b.c - a.c))));
}

double outside(const Scb2& a, const Scb2& b, const Vec3& point) {
    const auto beyond = [](const Scb2& s, const Vec3& from_center) {
        double most = std::sqrt(squared_norm(from_center)) - s.r;
        for (const Slab& slab : s.slabs) {
            const double height = dot(slab.n, from_center);
            most = std::max({most, height - slab.e, slab.f - height});
        }
        return most;
    };
    return std::max(beyond(a, point), beyond(b, point - (b.c - a.c)));
}

double outside(const Ball&, const Ball&, const Vec3&) { return 0; }

double outside(const Obb& a, const Obb& b, const Vec3& point) {
    const auto beyond = [](const Obb& box, const Vec3& from_center) {
        double most = 0;
        for (int i = 0; i < 3; ++i)
            most = std::max(most, std::abs(dot(Vec3(box.axes.col(i)), from_center)) - box.half[i]);
        return most;
    };
    return std::max(beyond(a, point), beyond(b, point - (b.center - a.center)));
}

template <class V>
ContactCertificate climbed(const V& a, const V& b, ContactCertificate certificate) {
    if (certificate.contact == Contact::disjoint)
        climb(
            certificate.direction, certificate.margin, 0.5,
            [&](const Vec3& d) { return proven_gap(a, b, d); },
            [](const Vec3& d, const Vec3& s) {
                const Vec3 moved = d + s;
                const double length = std::sqrt(squared_norm(moved));
                return length > 0.1 ? Vec3(moved / length) : d;
            });
    if (certificate.contact == Contact::overlapping) {
        // The point must stay in both volumes, although proven_depth accepts other points.
        const double slop = 1e-13 * std::max(diameter(a), diameter(b));
        climb(
            certificate.point, certificate.margin, std::min(diameter(a), diameter(b)) / 4,
            [&](const Vec3& p) {
                return outside(a, b, p) <= slop ? proven_depth(a, b, p) : -HUGE_VAL;
            },
            [&](const Vec3& p, const Vec3& s) { return pulled_in(a, b, p + s, slop); });
    }
    return certificate;
}

}  // namespace

template <class V>
ContactCertificate sharpened(const V& a, const V& b, ContactCertificate certificate) {
    if constexpr (!std::same_as<V, ConvexShape>)
        return climbed(a, b, certificate);
    else if (certificate.contact == Contact::overlapping)
        certificate.margin =
            std::max(certificate.margin, least_depth(a, b, {HUGE_VAL, 1e-4, 20000}));
    return certificate;
}

#define SCB_INSTANTIATE(V) \
    template ContactCertificate sharpened(const V&, const V&, ContactCertificate);
SCB_FOR_EACH_SHAPE(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
