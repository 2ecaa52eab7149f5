#include "core/judge/node_contact.h"

namespace scb {

TestVerdict verdict_of(const std::optional<ContactCertificate>& certificate, bool passed) {
    if (!certificate) return TestVerdict::unjudged;
    if (certificate->contact == Contact::disjoint)
        return passed ? TestVerdict::false_positive : TestVerdict::right;
    if (certificate->contact == Contact::overlapping)
        return passed ? TestVerdict::right : TestVerdict::wrong;
    return TestVerdict::right;
}

std::optional<ContactCertificate> certificate_of(const EngineQuery& query, const Pose& b_to_a,
                                                 IndexPair nodes, double reach) {
    if (nodes.a == no_index || nodes.b == no_index) return std::nullopt;
    const NodeVolume &a = (*query.sides[0].tree)[nodes.a].volume,
                     &b = (*query.sides[1].tree)[nodes.b].volume;
    const double tolerance = tolerance_of(query, nodes);
    const auto found = proven_verdict(a, b, b_to_a, tolerance, reach);
    // For volumes smaller than the tolerance, touching means nothing.
    if (found && found->contact == Contact::touching)
        for (const NodeVolume* volume : {&a, &b})
            if (const double size = diameter(convex_shape(*volume)); size > 0 && size <= tolerance)
                return std::nullopt;
    return found;
}

}  // namespace scb
