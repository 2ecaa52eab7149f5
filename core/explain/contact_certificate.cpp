#include "core/explain/contact_certificate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scb {
namespace {

// The greatest d.(x - c). By symmetry it is attained in the half plane of n and d, at the height h
// in the SCB that is nearest to the height of the ball's farthest point.
double reach(double r, double f, double e, double cosine, double sine) {
    const double h = std::clamp(r * cosine, f, e);
    return h * cosine + std::sqrt(std::max(0.0, (r - h) * (r + h))) * sine;
}

double reach(const Scb& s, const Vec3& d) {
    return reach(s.r, s.f, s.e, dot(s.n, d), cross(s.n, d).norm());
}

// The distances from a point of an SCB to its sphere and its nearer plane.
struct Surroundings {
    double to_sphere, to_plane, outside;
};

Surroundings surroundings(const Scb& s, const Vec3& from_center) {
    const double height = dot(s.n, from_center), to_plane = std::min(s.e - height, height - s.f),
                 outside = std::max(0.0, -to_plane);
    return {s.r - from_center.norm() - outside, std::max(0.0, to_plane), outside};
}

double reach(const Surroundings& s, double cosine, double sine) {
    const double h = std::min(s.to_plane, s.to_sphere);
    return reach(s.to_sphere, -h, h, std::abs(cosine), sine);
}

// An upper bound of the greatest d.(x - c), for a unit d, and the greatest itself up to rounding:
// by duality (Boyd and Vandenberghe, "Convex Optimization", Section 5.2), multiples of the outward
// normals may be subtracted from d, if the multiples of their planes are added. Tries no plane,
// either plane, and both.
double bounded_reach(const Scb2& s, const Vec3& d) {
    const Vec3 along(std::abs(dot(s.slabs[0].n, d)), std::abs(dot(s.slabs[1].n, d)),
                     std::abs(dot(long_axis(s), d)));
    const auto plane = [&](const Slab& slab) { return dot(slab.n, d) < 0 ? -slab.f : slab.e; };
    const std::array<double, 2> k = {plane(s.slabs[0]), plane(s.slabs[1])};
    double least = s.r;
    for (int i = 0; i < 2; ++i) {
        const double at = k[static_cast<std::size_t>(i)],
                     rim = std::sqrt(std::max(0.0, (s.r - at) * (s.r + at))),
                     rest = std::hypot(along[1 - i], along[2]);
        // With this multiple, the point of the rim is the farthest in the rest of d.
        if (along[i] * rim >= rest * at) least = std::min(least, along[i] * at + rim * rest);
    }
    const double squared = s.r * s.r - k[0] * k[0] - k[1] * k[1],
                 corner = std::sqrt(std::max(0.0, squared));
    const double of_planes = along[0] * k[0] + along[1] * k[1];
    if (along[0] * corner >= along[2] * k[0] && along[1] * corner >= along[2] * k[1] && squared > 0)
        least = std::min(least, of_planes + along[2] * corner);
    return std::min(least, of_planes + along[2] * s.r);
}

// How far one of two boxes about one point must move to leave the other: the least sum of their
// extents, which is along the normal of a face of either or across an edge of each.
double least_reach(const Mat3& axes_a, const Vec3& half_a, const Mat3& axes_b, const Vec3& half_b) {
    const auto reach = [&](const Vec3& d) {
        return (axes_a.transpose() * d).cwiseAbs().dot(half_a) +
               (axes_b.transpose() * d).cwiseAbs().dot(half_b);
    };
    double least = HUGE_VAL;
    for (int i = 0; i < 3; ++i) {
        least = std::min({least, reach(axes_a.col(i)), reach(axes_b.col(i))});
        for (int j = 0; j < 3; ++j) {
            const Vec3 across = cross(Vec3(axes_a.col(i)), Vec3(axes_b.col(j)));
            if (across.norm() > 1e-9) least = std::min(least, reach(across.normalized()));
        }
    }
    return least;
}

// A box about a point inside a volume, and a ball.
struct FreeBox {
    Mat3 axes;
    Vec3 half;
    double ball, outside;
};

FreeBox free_box(const Scb2& s, const Vec3& from_center) {
    const double to_sphere = s.r - from_center.norm();
    std::array<double, 2> left{};
    FreeBox box;
    // Moves towards the center and to the planes. No step undoes the others.
    box.outside = std::max(0.0, -to_sphere);
    for (int i = 0; i < 2; ++i) {
        const Slab& slab = s.slabs[static_cast<std::size_t>(i)];
        const double height = slab.n.dot(from_center);
        left[static_cast<std::size_t>(i)] = std::min(slab.e - height, height - slab.f);
        box.outside += std::max(0.0, -left[static_cast<std::size_t>(i)]);
        box.axes.col(i) = slab.n;
    }
    box.axes.col(2) = long_axis(s);
    // After the move by `outside`, all of this is about the point. The box is as wide as fits into
    // the ball; its sides are equal if the planes are far.
    const double ball = std::max(0.0, to_sphere - box.outside);
    const std::size_t near = left[0] <= left[1] ? 0 : 1, far = 1 - near;
    const double narrow = std::clamp(left[near], 0.0, ball / std::sqrt(3.0)),
                 wide = std::clamp(left[far], 0.0, std::sqrt((ball * ball - narrow * narrow) / 2));
    const double rest = ball * ball - narrow * narrow - wide * wide;
    box.half = near == 0 ? Vec3(narrow, wide, 0) : Vec3(wide, narrow, 0);
    box.half[2] = std::sqrt(std::max(0.0, rest));
    box.ball = std::min(ball, std::max(0.0, left[near]));
    return box;
}

double length_of(const Scb& s) { return s.r; }
double length_of(const Scb2& s) { return s.r; }
double length_of(const Ball& ball) { return ball.radius; }
double length_of(const Obb& box) { return box.half.stableNorm(); }
double length_of(const ConvexShape& shape) { return diameter(shape); }

}  // namespace

double proven_gap(const Scb& a, const Scb& b, const Vec3& direction) {
    const Vec3 d = direction / direction.norm();
    return dot(d, Vec3(b.c - a.c)) - reach(a, d) - reach(b, -d);
}

double proven_depth(const Scb& a, const Scb& b, const Vec3& point) {
    const Surroundings in_a = surroundings(a, point), in_b = surroundings(b, point - (b.c - a.c));
    const double outside_ball = std::min(in_a.to_sphere, in_b.to_sphere);
    if (outside_ball < 0) return outside_ball;
    const double cosine = dot(a.n, b.n), sine = cross(a.n, b.n).norm();
    const double along_a = reach(in_a, 1, 0) + reach(in_b, cosine, sine),
                 along_b = reach(in_b, 1, 0) + reach(in_a, cosine, sine);
    return std::min(along_a, along_b) - in_a.outside - in_b.outside;
}

double proven_gap(const Scb2& a, const Scb2& b, const Vec3& direction) {
    const Vec3 d = direction / direction.norm();
    return dot(d, Vec3(b.c - a.c)) - bounded_reach(a, d) - bounded_reach(b, -d);
}

double proven_depth(const Scb2& a, const Scb2& b, const Vec3& point) {
    const FreeBox in_a = free_box(a, point), in_b = free_box(b, point - (b.c - a.c));
    const double of_boxes = least_reach(in_a.axes, in_a.half, in_b.axes, in_b.half);
    return std::max(of_boxes, in_a.ball + in_b.ball) - in_a.outside - in_b.outside;
}

double proven_gap(const Ball& a, const Ball& b, const Vec3& direction) {
    const Vec3 d = direction / direction.norm();
    return dot(d, Vec3(b.center - a.center)) - a.radius - b.radius;
}

double proven_depth(const Ball& a, const Ball& b, const Vec3& point) {
    const double in_a = a.radius - point.norm(),
                 in_b = b.radius - (point - (b.center - a.center)).norm();
    return in_a + in_b + std::min(0.0, in_a) + std::min(0.0, in_b);
}

double proven_gap(const Obb& a, const Obb& b, const Vec3& direction) {
    const Vec3 d = direction / direction.norm(), to_b = b.center - a.center;
    double highest_of_a = -HUGE_VAL, lowest_of_b = HUGE_VAL;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        highest_of_a = std::max(highest_of_a, d.dot(a.axes * signs.cwiseProduct(a.half)));
        lowest_of_b = std::min(lowest_of_b, d.dot(to_b + b.axes * signs.cwiseProduct(b.half)));
    }
    return lowest_of_b - highest_of_a;
}

double proven_depth(const Obb& a, const Obb& b, const Vec3& point) {
    const auto room = [](const Obb& box, const Vec3& from_center) {
        return Vec3(box.half - (box.axes.transpose() * from_center).cwiseAbs());
    };
    const Vec3 in_a = room(a, point), in_b = room(b, point - (b.center - a.center));
    const double outside = std::max(0.0, -in_a.minCoeff()) + std::max(0.0, -in_b.minCoeff());
    return least_reach(a.axes, in_a.cwiseMax(0), b.axes, in_b.cwiseMax(0)) - outside;
}

template <class V>
bool verify(const V& a, const V& b, const ContactCertificate& certificate) {
    const double size =
        std::max({length_of(a), length_of(b), (shape_center(b) - shape_center(a)).stableNorm()});
    // Squares of shorter lengths lose digits, or vanish; squares of longer lengths overflow.
    if (!(size > 1e-140 && size < 1e140)) return false;
    const double rounding = 1e-14 * size;
    if (!(certificate.margin > rounding)) return false;
    switch (certificate.contact) {
        case Contact::disjoint:
            return std::abs(certificate.direction.norm() - 1) <= 1e-9 &&
                   proven_gap(a, b, certificate.direction) >= certificate.margin - rounding;
        case Contact::overlapping:
            return proven_depth(a, b, certificate.point) >= certificate.margin - rounding;
        case Contact::touching:
            break;
    }
    return false;
}

#define SCB_INSTANTIATE(V) template bool verify(const V&, const V&, const ContactCertificate&);
SCB_FOR_EACH_SHAPE(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
