#include "core/explain/exact_overlap.h"

#include <algorithm>
#include <cmath>

#include "core/explain/centered_pair.h"
#include "core/volumes/scb2_reach.h"

namespace scb {
namespace {

// The vector without its part along the unit vector n, of length 1; any unit vector across n if
// nothing is left.
Vec3 unit_across(const Vec3& n, const Vec3& v) {
    Vec3 across = v - dot(n, v) * n;
    if (!(squared_norm(across) > 1e-30 * squared_norm(v)))
        across = cross(n, std::abs(n[0]) < 0.5 ? Vec3::UnitX() : Vec3::UnitY());
    across /= std::sqrt(squared_norm(across));
    // Once more: the first difference cancels if v is nearly along n.
    across -= dot(n, across) * n;
    return across / std::sqrt(squared_norm(across));
}

// The point closest to `target` of the circle in which the plane n.x = k cuts the ball of radius r
// about the origin.
Vec3 closest_on_circle(double r, const Vec3& n, double k, const Vec3& target) {
    return k * n + half_chord(r, k) * unit_across(n, target);
}

// The frame of two planes: `along` their common line, `across` it within the first one.
struct Crossing {
    Vec3 along, across;
    double sine;  // sine of the angle between the planes, as n1.across

    Crossing(const Vec3& n0, const Vec3& n1) {
        const Vec3 product = cross(n0, n1);
        // Exactly in the first plane: for nearly parallel planes the product has few digits, but
        // any direction of the first plane near the right one is near the second plane.
        along = unit_across(n0, product);
        across = cross(along, n0);
        across /= std::sqrt(squared_norm(across));
        sine = squared_norm(product) > 1e-30 ? dot(n1, across) : 0;
    }
};

using Pair = CenteredPair<Scb>;

// Calls visit(x) with each point in which two of the planes, one of A and one of B, and the sphere
// of A meet, if `with_sphere`; otherwise with the point of each line that is closest to B's center.
// Stops where visit returns true.
template <class Visit>
bool visit_corners(const Pair& p, const Crossing& crossing, bool with_sphere, const Visit& visit) {
    if (crossing.sine == 0) return false;
    const double cosine = dot(p.a.n, p.b.n), offset = dot(p.b.n, p.to_b());
    for (const double ka : {p.a.e, p.a.f})
        for (const double kb : {p.b.e, p.b.f}) {
            const double across = (kb + offset - ka * cosine) / crossing.sine;
            if (!with_sphere) {
                const double along = dot(crossing.along, p.to_b());
                if (visit(Vec3(ka * p.a.n + across * crossing.across + along * crossing.along)))
                    return true;
                continue;
            }
            // A line that misses the sphere by rounding counts as touching it.
            const double rho = half_chord(p.a.r, ka), on_disc = std::clamp(across, -rho, rho),
                         along = half_chord(rho, on_disc);
            if (std::abs(across - on_disc) > 1e-6 * p.a.r) continue;
            const Vec3 foot = ka * p.a.n + on_disc * crossing.across;
            if (visit(Vec3(foot + along * crossing.along))) return true;
            if (visit(Vec3(foot - along * crossing.along))) return true;
        }
    return false;
}

// Tries the point of A within B's slab that is closest to the center of B, and others. True, with
// the point, if one of them is in both up to `slop`.
bool find_common_point(const Pair& p, const Crossing& crossing, double slop, Vec3& found) {
    if (p.a.r < 0 || p.b.r < 0) return false;
    const Scb &a = p.a, &b = p.b;
    const Vec3 target = p.to_b();
    const double a_limit = (a.r + slop) * (a.r + slop), b_limit = (b.r + slop) * (b.r + slop);
    const auto is_common = [&](const Vec3& x) {
        if (!(squared_norm(x) <= a_limit)) return false;
        const Vec3 y = x - target;
        if (!(squared_norm(y) <= b_limit)) return false;
        const double ha = dot(a.n, x), hb = dot(b.n, y);
        if (ha < a.f - slop || ha > a.e + slop || hb < b.f - slop || hb > b.e + slop) return false;
        found = x;
        return true;
    };

    if (is_common(target + std::clamp(0.0, b.f, b.e) * b.n)) return true;
    const double height = dot(a.n, target);
    if (is_common(target + (std::clamp(height, a.f, a.e) - height) * a.n)) return true;
    if (visit_corners(p, crossing, false, is_common)) return true;

    const double distance = std::sqrt(squared_norm(target));
    if (distance > 0 && is_common(target * (a.r / distance))) return true;
    for (const double k : {a.e, a.f})
        if (is_common(closest_on_circle(a.r, a.n, k, target))) return true;
    const double offset = dot(b.n, target);
    for (const double k : {b.e + offset, b.f + offset})
        if (std::abs(k) <= a.r && is_common(closest_on_circle(a.r, b.n, k, target))) return true;
    return visit_corners(p, crossing, true, is_common);
}

// The extent of the ball's farthest point, or of the farthest point of the rim if the slab cuts
// that off.
double exact_reach(const Scb& s, const Vec3& d) {
    const double cosine = dot(s.n, d), top = s.r * cosine;
    if (top >= s.f && top <= s.e) return s.r;
    const double k = top < s.f ? s.f : s.e;
    return k * cosine + half_chord(s.r, k) * std::sqrt(squared_norm(cross(s.n, d)));
}

using ScbSeparation = Separation<Scb, exact_reach>;

// Tries the normals of faces, and all directions that involve a sphere.
void try_closed_forms(const Pair& pair, ScbSeparation& separation) {
    const Scb &a = pair.a, &b = pair.b;
    const Vec3 to_b = pair.to_b(), to_a = -to_b;
    separation.try_both_ways(a.n);
    separation.try_both_ways(b.n);
    separation.try_direction(to_b);
    for (const double k : {a.e, a.f})
        separation.try_direction(to_b - closest_on_circle(a.r, a.n, k, to_b));
    for (const double k : {b.e, b.f})
        separation.try_direction(to_b + closest_on_circle(b.r, b.n, k, to_a));
    const double b_offset = dot(b.n, to_b), a_offset = dot(a.n, to_a);
    for (const double k : {b.e + b_offset, b.f + b_offset})
        if (std::abs(k) <= a.r) separation.try_direction(closest_on_circle(a.r, b.n, k, to_b));
    for (const double k : {a.e + a_offset, a.f + a_offset})
        if (std::abs(k) <= b.r) separation.try_direction(-closest_on_circle(b.r, a.n, k, to_a));
}

// Rim against rim: the plane of the tangent of A's rim in a corner x and the tangent there of the
// circle of B's plane about B's axis.
void try_corners(const Pair& p, const Crossing& crossing, ScbSeparation& separation) {
    visit_corners(p, crossing, true, [&](const Vec3& x) {
        const Vec3 a_tangent = cross(p.a.n, x), b_tangent = cross(p.b.n, Vec3(p.to_b() - x));
        separation.try_both_ways(cross(a_tangent, b_tangent));
        return false;
    });
}

// The directions of the pair with a wider slab of B. If A only touches B's slab, or misses it by
// `missed` at most, its single point there gives no direction, but its cap in the wider slab does.
void try_wider_slabs(const Pair& p, double missed, ScbSeparation& separation) {
    for (const double share : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const double by = missed + share * std::max(p.a.r, p.b.r);
        Pair wider = p;
        wider.b.e = std::min(p.b.e + by, p.b.r);
        wider.b.f = std::max(p.b.f - by, -p.b.r);
        try_closed_forms(wider, separation);
        try_corners(wider, Crossing(p.a.n, p.b.n), separation);
    }
}

// The cores of A and B: a point in both cores proves the depth. A point this deep in one SCB and
// anywhere in the other proves it (well within the other's ball, so that only its planes take part
// in the rounding). If both SCBs are too thin, the point needs more room along their planes, and
// more if these cross less steeply.
Pair cores(Pair p, const Crossing& crossing, double depth) {
    const auto is_thick = [&](const Scb& s) { return thickness(s) >= 2 * depth; };
    const bool thin = !is_thick(p.a) && !is_thick(p.b);
    for (Scb* s : {&p.a, &p.b}) {
        if (is_thick(*s)) {
            s->e -= depth;
            s->f += depth;
        }
        // No core (negative radius) if the planes are parallel.
        s->r -= !thin               ? std::min(depth, s->r / 2)
                : crossing.sine > 0 ? depth / crossing.sine
                                    : 2 * s->r;
    }
    return p;
}

}  // namespace

ContactCertificate exact_overlap(const Scb& a, const Scb& b, double tolerance) {
    const double larger = std::max(a.r, b.r), least = tolerance * larger;
    const Pair pair(a, b);

    ContactCertificate certificate;
    const Crossing crossing(a.n, b.n);
    const auto have_common_point = [&] {
        const Pair inner = cores(pair, crossing, 2 * least);
        if (!(least > 0 && find_common_point(inner, crossing, 1e-14 * larger, certificate.point)))
            return false;
        certificate.contact = Contact::overlapping;
        certificate.margin = least;
        return true;
    };
    ScbSeparation separation{pair};
    const auto are_disjoint = [&] {
        if (!(separation.gap > least)) return false;
        certificate.contact = Contact::disjoint;
        certificate.direction = separation.direction;
        certificate.margin = separation.gap;
        return true;
    };
    const auto closed_forms_show_it = [&] {
        try_closed_forms(pair, separation);
        return are_disjoint();
    };
    // Each result is a proof, so the order of the searches changes only their time.
    ScbSeparation centers{pair};
    centers.try_direction(pair.to_b());
    if (centers.gap > 0) {
        if (closed_forms_show_it() || have_common_point()) return certificate;
    } else {
        if (have_common_point() || closed_forms_show_it()) return certificate;
    }

    try_corners(pair, crossing, separation);
    if (are_disjoint()) return certificate;
    const Pair exchanged = pair.exchanged();
    ScbSeparation backward{exchanged};
    try_corners(exchanged, Crossing(b.n, a.n), backward);
    separation.try_direction(-backward.direction);
    if (are_disjoint()) return certificate;

    const double missed = std::max(0.0, separation.gap);
    try_wider_slabs(pair, missed, separation);
    try_wider_slabs(exchanged, missed, backward);
    separation.try_direction(-backward.direction);
    are_disjoint();
    return certificate;
}

}  // namespace scb
