#include "core/explain/contact_certificate.h"

#include <algorithm>
#include <cmath>

namespace scb {
namespace {

// The greatest d.(x - c). By symmetry it is attained in the half plane of n and d, at the height h
// of the SCB that is nearest to the height of the ball's farthest point.
double reach(double r, double f, double e, double cosine, double sine) {
    const double h = std::clamp(r * cosine, f, e);
    return h * cosine + std::sqrt(std::max(0.0, (r - h) * (r + h))) * sine;
}

double reach(const Scb& s, const Vec3& d) {
    return reach(s.r, s.f, s.e, dot(s.n, d), cross(s.n, d).norm());
}

// What a point of an SCB sees around it.
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

/// `size`: the largest of the lengths that meet.
template <class V>
bool verify_within(const V& a, const V& b, const ContactCertificate& certificate, double size) {
    // Squares of shorter lengths lose digits, or vanish, and those of longer ones overflow.
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
    const auto reach = [&](const Vec3& direction) {
        return (a.axes.transpose() * direction).cwiseAbs().dot(in_a.cwiseMax(0)) +
               (b.axes.transpose() * direction).cwiseAbs().dot(in_b.cwiseMax(0));
    };
    double least = HUGE_VAL;
    for (int i = 0; i < 3; ++i) {
        least = std::min({least, reach(a.axes.col(i)), reach(b.axes.col(i))});
        for (int j = 0; j < 3; ++j) {
            const Vec3 across = cross(Vec3(a.axes.col(i)), Vec3(b.axes.col(j)));
            if (across.norm() > 1e-9) least = std::min(least, reach(across.normalized()));
        }
    }
    return least - outside;
}

bool verify(const Scb& a, const Scb& b, const ContactCertificate& certificate) {
    return verify_within(a, b, certificate, std::max({a.r, b.r, (b.c - a.c).stableNorm()}));
}

bool verify(const Ball& a, const Ball& b, const ContactCertificate& certificate) {
    return verify_within(a, b, certificate,
                         std::max({a.radius, b.radius, (b.center - a.center).stableNorm()}));
}

bool verify(const Obb& a, const Obb& b, const ContactCertificate& certificate) {
    return verify_within(
        a, b, certificate,
        std::max({a.half.stableNorm(), b.half.stableNorm(), (b.center - a.center).stableNorm()}));
}

}  // namespace scb
