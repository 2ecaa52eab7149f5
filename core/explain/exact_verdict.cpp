#include <algorithm>
#include <cmath>
#include <concepts>

#include "core/explain/exact_overlap.h"
#include "core/volumes/any_volume.h"

namespace scb {

template <class V>
V seen_from_a(const V& b, const Placement& placed) {
    V moved = scb::placed(b, placed.b_to_a);
    if constexpr (std::same_as<V, Scb>) moved.n /= std::sqrt(squared_norm(moved.n));
    if constexpr (std::same_as<V, Scb2>) {
        auto& [first, second] = moved.slabs;
        first.n /= std::sqrt(squared_norm(first.n));
        second.n -= dot(first.n, second.n) * first.n;
        second.n /= std::sqrt(squared_norm(second.n));
    }
    return moved;
}

namespace {

// The length that the tolerance of exact_overlap is a share of.
template <class V>
double size_of(const V& a, const V& b) {
    return std::max(diameter(a), diameter(b)) / 2;
}

double tolerance_of(double size, const Placement& placed) {
    return size > 0 ? std::max(contact_tolerance, placed.margin / size) : contact_tolerance;
}

}  // namespace

template <class V>
bool apart_along_centers(const V& a, const V& b, const Placement& placed) {
    const V moved = seen_from_a(b, placed);
    const Vec3 to_b = shape_center(moved) - shape_center(a);
    const double distance = std::sqrt(squared_norm(to_b));
    // The greatest gap of two boxes along the 15 directions of exact_overlap is at least this gap
    // over the root of 3. A factor of 2 also covers rounding.
    const double size = size_of(a, b), least = 2 * tolerance_of(size, placed) * size;
    return distance > 0 && least > 0 && proven_gap(a, moved, Vec3(to_b / distance)) > least;
}

template <class V>
ContactCertificate exact_verdict(const V& a, const V& b, const Placement& placed) {
    const double tolerance = tolerance_of(size_of(a, b), placed);
    const ContactCertificate certificate = exact_overlap(a, seen_from_a(b, placed), tolerance);
    // Points, which have no size, are disjoint at any distance.
    const bool lost =
        certificate.contact == Contact::disjoint && !(certificate.margin > placed.margin);
    return lost ? ContactCertificate{} : certificate;
}

#define SCB_INSTANTIATE(V)                                                   \
    template V seen_from_a(const V&, const Placement&);                      \
    template bool apart_along_centers(const V&, const V&, const Placement&); \
    template ContactCertificate exact_verdict(const V&, const V&, const Placement&);
SCB_FOR_EACH_SHAPE(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
