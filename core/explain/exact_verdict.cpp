#include "core/explain/exact_verdict.h"

#include <algorithm>
#include <cmath>

#include "core/explain/exact_overlap.h"
#include "core/volumes/any_volume.h"

namespace scb {
namespace {

template <class V>
ContactCertificate verdict(const V& a, const V& b, const Placement& placed) {
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

}  // namespace

ContactCertificate exact_verdict(const Scb& a, const Scb& b, const Placement& placed) {
    return verdict(a, b, placed);
}

ContactCertificate exact_verdict(const Scb2& a, const Scb2& b, const Placement& placed) {
    return verdict(a, b, placed);
}

ContactCertificate exact_verdict(const Ball& a, const Ball& b, const Placement& placed) {
    return verdict(a, b, placed);
}

ContactCertificate exact_verdict(const Obb& a, const Obb& b, const Placement& placed) {
    return verdict(a, b, placed);
}

ContactCertificate exact_verdict(const ConvexShape& a, const ConvexShape& b,
                                 const Placement& placed) {
    return verdict(a, b, placed);
}

Scb seen_from_a(const Scb& b, const Placement& placed) {
    Scb moved = scb::placed(b, placed.b_to_a);
    moved.n /= std::sqrt(squared_norm(moved.n));
    return moved;
}

Scb2 seen_from_a(const Scb2& b, const Placement& placed) {
    Scb2 moved = scb::placed(b, placed.b_to_a);
    auto& [first, second] = moved.slabs;
    first.n /= std::sqrt(squared_norm(first.n));
    second.n -= dot(first.n, second.n) * first.n;
    second.n /= std::sqrt(squared_norm(second.n));
    return moved;
}

Ball seen_from_a(const Ball& b, const Placement& placed) { return scb::placed(b, placed.b_to_a); }

Obb seen_from_a(const Obb& b, const Placement& placed) { return scb::placed(b, placed.b_to_a); }

ConvexShape seen_from_a(const ConvexShape& b, const Placement& placed) {
    return scb::placed(b, placed.b_to_a);
}

}  // namespace scb
