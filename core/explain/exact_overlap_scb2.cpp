#include <algorithm>
#include <array>
#include <cmath>

#include "core/explain/box_room.h"
#include "core/explain/centered_pair.h"
#include "core/explain/exact_overlap.h"
#include "core/volumes/scb2_reach.h"

namespace scb {
namespace {

using Scb2Pair = CenteredPair<Scb2>;
using Scb2Separation = Separation<Scb2, support>;

/// A half space that contains A or B: normal.x <= at, from A's center.
struct Bound {
    Vec3 normal;
    double at;
    bool of_a;
};

using Vectors = std::array<Vec3, 3>;
const Vectors no_vectors = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};

/// A candidate for the point of A within B's slabs that is closest to B's center: a point on some
/// of the bounds' planes, and perhaps on A's sphere.
struct Candidate {
    Vec3 point = Vec3::Zero();
    Vectors normals = no_vectors;  ///< see Bound
    Vec3 at = Vec3::Zero();        ///< see Bound
    std::array<bool, 3> of_a{};
    std::size_t count = 0;
    bool on_sphere = false;
};

/// The dual basis of the first `count` vectors, in their span: dual[i].v[j] is 1 where i = j, else
/// 0. False if they are dependent.
bool find_dual(const Vectors& v, std::size_t count, Vectors& dual) {
    dual = no_vectors;
    if (count == 1) {
        dual[0] = v[0] / squared_norm(v[0]);
        return squared_norm(v[0]) > 0;
    }
    const Vec3 w = cross(v[0], v[1]), third = count == 3 ? v[2] : w;
    const double volume = dot(w, third), squared = squared_norm(w);
    if (!(squared > 1e-24 * squared_norm(v[0]) * squared_norm(v[1]) &&
          volume * volume > 1e-24 * squared * squared_norm(third)))
        return false;
    dual = {cross(v[1], third) / volume, cross(third, v[0]) / volume, w / volume};
    return true;
}

class Candidates {
  public:
    explicit Candidates(const Scb2Pair& p) : pair_(p) {
        for (const bool of_a : {true, false})
            for (std::size_t i = 0; i < 2; ++i) {
                const Slab& s = (of_a ? p.a : p.b).slabs[i];
                const double shift = of_a ? 0 : dot(s.n, p.to_b());
                bounds_[(of_a ? 0u : 2u) + i] = {Bound{s.n, s.e + shift, of_a},
                                                 Bound{-s.n, -(s.f + shift), of_a}};
            }
    }

    /// Calls visit with each candidate, until it returns true.
    template <class Visit>
    bool visit(const Visit& visit) const {
        return extend(Candidate(), 0, visit);
    }

    /// The part of the direction from the candidate to B's center in which the candidate is a
    /// farthest point of A.
    bool direction(const Candidate& c, Vec3& d) const {
        Vectors normals = c.normals, dual;
        std::array<bool, 3> of_a = c.of_a;
        std::size_t count = c.count;
        if (c.on_sphere) {
            normals[count] = c.point;
            of_a[count++] = true;
        }
        if (count == 0 || !find_dual(normals, count, dual)) return false;
        const Vec3 towards = pair_.to_b() - c.point;
        d = Vec3::Zero();
        for (std::size_t i = 0; i < count; ++i)
            if (of_a[i]) d += dot(dual[i], towards) * normals[i];
        return true;
    }

    /// Whether the point is in A and within B's slabs.
    bool is_feasible(const Vec3& x, double slop) const {
        if (!(squared_norm(x) <= (pair_.a.r + slop) * (pair_.a.r + slop))) return false;
        for (const auto& slab : bounds_)
            for (const Bound& bound : slab)
                if (!(dot(bound.normal, x) <= bound.at + slop)) return false;
        return true;
    }

  private:
    /// Visits candidates on the planes of `chosen`, and on one plane each of further slabs.
    template <class Visit>
    bool extend(const Candidate& chosen, std::size_t next, const Visit& visit) const {
        if (try_planes(chosen, visit) || try_sphere(chosen, visit)) return true;
        if (chosen.count == 3) return false;
        for (std::size_t slab = next; slab < bounds_.size(); ++slab)
            for (const Bound& bound : bounds_[slab]) {
                Candidate more = chosen;
                more.normals[more.count] = bound.normal;
                more.at[static_cast<int>(more.count)] = bound.at;
                more.of_a[more.count++] = bound.of_a;
                if (extend(more, slab + 1, visit)) return true;
            }
        return false;
    }

    /// The point of all the planes that is closest to `from`.
    static bool foot(const Candidate& c, const Vec3& from, Vec3& point) {
        Vectors dual;
        point = from;
        if (c.count == 0) return true;
        if (!find_dual(c.normals, c.count, dual)) return false;
        for (std::size_t i = 0; i < c.count; ++i)
            point += (c.at[static_cast<int>(i)] - dot(c.normals[i], from)) * dual[i];
        return true;
    }

    template <class Visit>
    bool try_planes(Candidate c, const Visit& visit) const {
        c.on_sphere = false;
        return foot(c, pair_.to_b(), c.point) && visit(c);
    }

    template <class Visit>
    bool try_sphere(Candidate c, const Visit& visit) const {
        c.on_sphere = true;
        Vec3 middle;
        if (c.count == 3 || !foot(c, Vec3::Zero(), middle)) return false;
        // Planes that miss the sphere by rounding count as touching it.
        const double r = pair_.a.r, off = std::sqrt(squared_norm(middle));
        if (!(off <= r * (1 + 1e-6))) return false;
        const double radius = half_chord(r, std::min(off, r));
        if (c.count == 2) {
            const Vec3 line = cross(c.normals[0], c.normals[1]);
            const double length = std::sqrt(squared_norm(line));
            for (const double side : {radius, -radius}) {
                c.point = middle + side / length * line;
                if (visit(c)) return true;
            }
            return false;
        }
        Vec3 towards = pair_.to_b() - middle;
        if (c.count == 1) towards -= dot(c.normals[0], towards) * c.normals[0];
        double length = std::sqrt(squared_norm(towards));
        if (!(length > 1e-12 * r)) {
            // All points of the circle are equally close; any will do.
            const Vec3 axis = c.count == 1 ? c.normals[0] : Vec3::UnitZ();
            towards = cross(axis, std::abs(axis[0]) < 0.5 ? Vec3::UnitX() : Vec3::UnitY());
            length = std::sqrt(squared_norm(towards));
        }
        c.point = middle + radius / length * towards;
        return visit(c);
    }

    const Scb2Pair& pair_;
    std::array<std::array<Bound, 2>, 4> bounds_;
};

/// Tries the directions that follow from candidates; with `only_feasible`, from candidates that are
/// in A and within B's slabs.
void try_candidates(const Scb2Pair& p, double slop, bool only_feasible, double enough,
                    Scb2Separation& separation) {
    const Candidates candidates(p);
    candidates.visit([&](const Candidate& c) {
        Vec3 d;
        if (only_feasible && !candidates.is_feasible(c.point, slop)) return false;
        if (candidates.direction(c, d)) separation.try_direction(d);
        return separation.gap > enough;
    });
}

/// Adds the candidates that are in both, from A's center, moved by `shift`.
void add_common_points(const Scb2Pair& p, double slop, const Vec3& shift, Vec3& sum, int& count) {
    const Candidates candidates(p);
    const double limit = (p.b.r + slop) * (p.b.r + slop);
    candidates.visit([&](const Candidate& c) {
        if (candidates.is_feasible(c.point, slop) && squared_norm(c.point - p.to_b()) <= limit) {
            sum += c.point + shift;
            ++count;
        }
        return false;
    });
}

/// The directions of the pair with wider slabs of B: if A only touches B's slabs, its single point
/// there gives no direction.
void try_wider_slabs(const Scb2Pair& p, double missed, double enough, Scb2Separation& separation) {
    for (const double share : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const double by = missed + share * std::max(p.a.r, p.b.r);
        Scb2Pair wider = p;
        for (Slab& slab : wider.b.slabs) {
            slab.e = std::min(slab.e + by, p.b.r);
            slab.f = std::max(slab.f - by, -p.b.r);
        }
        try_candidates(wider, 0, false, enough, separation);
        if (separation.gap > enough) return;
    }
}

}  // namespace

ContactCertificate exact_overlap(const Scb2& a, const Scb2& b, double tolerance) {
    const double larger = std::max(a.r, b.r), least = tolerance * larger, slop = 1e-13 * larger;
    const Scb2Pair pair(a, b);
    const Scb2Pair exchanged = pair.exchanged();

    ContactCertificate certificate;
    Scb2Separation separation{pair}, backward{exchanged};
    const auto is_disjoint = [&] {
        separation.try_direction(-backward.direction);
        if (!(separation.gap > least)) return false;
        certificate.contact = Contact::disjoint;
        certificate.direction = separation.direction;
        certificate.margin = separation.gap;
        return true;
    };

    separation.try_direction(pair.to_b());
    for (std::size_t i = 0; i < 2; ++i) {
        separation.try_both_ways(a.slabs[i].n);
        separation.try_both_ways(b.slabs[i].n);
    }
    separation.try_both_ways(cross(long_axis(a), long_axis(b)));
    if (is_disjoint()) return certificate;
    try_candidates(pair, slop, true, least, separation);
    if (is_disjoint()) return certificate;
    try_candidates(exchanged, slop, true, least, backward);
    if (is_disjoint()) return certificate;

    Vec3 sum = Vec3::Zero();
    int count = 0;
    add_common_points(pair, slop, Vec3::Zero(), sum, count);
    add_common_points(exchanged, slop, pair.to_b(), sum, count);
    if (count > 0) {
        certificate.point = sum / count;
        certificate.margin = depth_of(room_about(a, certificate.point),
                                      room_about(b, certificate.point - pair.to_b()));
        if (certificate.margin > least) {
            certificate.contact = Contact::overlapping;
            return certificate;
        }
        certificate = {};
    }

    try_candidates(pair, slop, false, least, separation);
    try_candidates(exchanged, slop, false, least, backward);
    if (is_disjoint()) return certificate;
    const double missed = std::max(0.0, separation.gap);
    try_wider_slabs(pair, missed, least, separation);
    try_wider_slabs(exchanged, missed, least, backward);
    is_disjoint();
    return certificate;
}

}  // namespace scb
