#include "tests/core/scb_contact_proof.h"

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

bool verify(const Scb& a, const Scb& b, const ContactProof& proof) {
    const double rounding = 1e-14 * std::max(a.r, b.r);
    if (proof.contact == Contact::undecided || !(proof.margin > rounding)) return false;
    const double margin = proof.contact == Contact::disjoint ? proven_gap(a, b, proof.direction)
                                                             : proven_depth(a, b, proof.point);
    return margin >= proof.margin - rounding;
}

}  // namespace scb
