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

template <class V>
ContactCertificate exact_verdict(const V& a, const V& b, const Placement& placed) {
    // The length that the tolerance of exact_overlap is a share of.
    const double size = std::max(diameter(a), diameter(b)) / 2;
    const double tolerance =
        size > 0 ? std::max(contact_tolerance, placed.margin / size) : contact_tolerance;
    const ContactCertificate certificate = exact_overlap(a, seen_from_a(b, placed), tolerance);
    // Points, which have no size, are disjoint at any distance.
    const bool lost =
        certificate.contact == Contact::disjoint && !(certificate.margin > placed.margin);
    return lost ? ContactCertificate{} : certificate;
}

#define SCB_INSTANTIATE(V)                              \
    template V seen_from_a(const V&, const Placement&); \
    template ContactCertificate exact_verdict(const V&, const V&, const Placement&);
SCB_FOR_EACH_SHAPE(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
