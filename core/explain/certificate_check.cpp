#include "core/explain/contact_certificate.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scb {
namespace {

// A farthest point in a unit direction, from the center.
Vec3 farthest(const Scb& s, const Vec3& d) {
    const double top = s.r * dot(s.n, d);
    // Not for a disc: a disc at a pole is a single point, but rounding gives other points its
    // height.
    if (s.f < s.e && s.f <= top && top <= s.e) return s.r * d;
    const double height = std::clamp(top, s.f, s.e),
                 rim = std::sqrt(std::max(0.0, (s.r - height) * (s.r + height)));
    Vec3 level = d - dot(s.n, d) * s.n;
    level -= dot(s.n, level) * s.n;
    const double length = level.norm();
    return length > 0 ? Vec3(height * s.n + rim / length * level) : Vec3(height * s.n);
}

// The farthest point in the volume among the sphere's point, the points of the planes' rims, and
// the corners.
Vec3 farthest(const Scb2& s, const Vec3& d) {
    const double slop = 1e-14 * s.r;
    Vec3 best = Vec3::Zero();
    double most = 0;
    const auto consider = [&](const Vec3& x) {
        for (const Slab& slab : s.slabs) {
            const double height = dot(slab.n, x);
            if (height < slab.f - slop || height > slab.e + slop) return;
        }
        if (dot(d, x) > most) {
            most = dot(d, x);
            best = x;
        }
    };
    consider(s.r * d);
    const Vec3 line = long_axis(s);
    const Vec3 &n = s.slabs[0].n, &m = s.slabs[1].n;
    const auto on_rim = [&](const Vec3& foot, double height, const Vec3& u, const Vec3& v) {
        const double rim = std::sqrt(std::max(0.0, (s.r - height) * (s.r + height)));
        const double x = dot(u, d), y = dot(v, d), length = std::hypot(x, y);
        if (length > 0) consider(foot + rim / length * (x * u + y * v));
        consider(foot);
    };
    for (const double k : {s.slabs[0].e, s.slabs[0].f}) on_rim(k * n, k, m, line);
    for (const double k : {s.slabs[1].e, s.slabs[1].f}) on_rim(k * m, k, n, line);
    for (const double k : {s.slabs[0].e, s.slabs[0].f})
        for (const double l : {s.slabs[1].e, s.slabs[1].f}) {
            const double squared = s.r * s.r - k * k - l * l;
            if (squared < -slop * s.r) continue;
            const double rest = std::sqrt(std::max(0.0, squared));
            for (const double side : {rest, -rest}) consider(k * n + l * m + side * line);
        }
    return best;
}

Vec3 farthest(const Ball& ball, const Vec3& d) { return ball.radius * d; }

Vec3 farthest(const Obb& box, const Vec3& d) {
    Vec3 corner = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
        corner += std::copysign(box.half[i], dot(Vec3(box.axes.col(i)), d)) * Vec3(box.axes.col(i));
    return corner;
}

Vec3 farthest(const ConvexShape& shape, const Vec3& d) {
    return shape.support_point(d) + shape.rounding * d;
}

void add_directions(std::vector<Vec3>& to, const Scb& s) { to.push_back(s.n); }
void add_directions(std::vector<Vec3>& to, const Scb2& s) {
    for (const Slab& slab : s.slabs) to.push_back(slab.n);
}
void add_directions(std::vector<Vec3>&, const Ball&) {}
void add_directions(std::vector<Vec3>&, const ConvexShape&) {}
void add_directions(std::vector<Vec3>& to, const Obb& box) {
    for (int i = 0; i < 3; ++i) to.push_back(box.axes.col(i));
}

}  // namespace

template <class V>
bool check_certificate(const V& a, const V& b, const ContactCertificate& certificate) {
    const Vec3 to_b = shape_center(b) - shape_center(a);
    const double rounding = 1e-13 * std::max({diameter(a), diameter(b), to_b.norm()});
    const auto reach_of_a = [&](const Vec3& d) { return dot(d, farthest(a, d)); };
    const auto end_of_b = [&](const Vec3& d) { return dot(d, Vec3(to_b + farthest(b, -d))); };
    if (certificate.contact == Contact::touching) return false;
    if (certificate.contact == Contact::disjoint) {
        const Vec3& d = certificate.direction;
        return end_of_b(d) - reach_of_a(d) >= certificate.margin - rounding;
    }
    std::vector<Vec3> directions;
    add_directions(directions, a);
    add_directions(directions, b);
    if (to_b.norm() > 0) directions.push_back(to_b.normalized());
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            for (int k = -1; k <= 1; ++k)
                if (9 * i + 3 * j + k > 0) directions.push_back(Vec3(i, j, k).normalized());
    const auto holds_along = [&](const Vec3& d) {
        const double at = dot(d, certificate.point);
        return at <= reach_of_a(d) + rounding && at >= end_of_b(d) - rounding &&
               reach_of_a(d) - end_of_b(d) >= certificate.margin - rounding;
    };
    return std::all_of(directions.begin(), directions.end(),
                       [&](const Vec3& d) { return holds_along(d) && holds_along(-d); });
}

#define SCB_INSTANTIATE(V) \
    template bool check_certificate(const V&, const V&, const ContactCertificate&);
SCB_FOR_EACH_SHAPE(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
