#include "core/judge/node_explanation.h"

#include <cmath>
#include <string>
#include <type_traits>

#include "core/explain/contact_certificate.h"
#include "core/explain/exact_overlap.h"
#include "core/explain/overlap_steps.h"
#include "core/volumes/any_volume.h"

namespace scb {
namespace {

/// Calls `call` with both volumes in the types that exact_verdict uses for them.
template <class Call>
void with_shapes(const NodeVolume& a, const NodeVolume& b, const Call& call) {
    std::visit(
        [&]<class V>(const V& va) {
            if constexpr (std::is_same_v<V, Obb> || std::is_same_v<V, Ball> ||
                          std::is_same_v<V, Scb> || std::is_same_v<V, Scb2>) {
                if (const V* vb = std::get_if<V>(&b)) return call(va, *vb);
            }
            call(convex_shape(a), convex_shape(b));
        },
        a);
}

template <class V>
OverlapStep step_between(const V& a, const V& b, const ContactCertificate& certificate,
                         Stage ended) {
    const Vec3 to_b = center(AnyVolume(b)) - center(AnyVolume(a));
    const double length = std::sqrt(squared_norm(to_b));
    const bool disjoint = certificate.contact == Contact::disjoint;
    const std::string name = disjoint ? "w" : "u";
    const Vec3 u = disjoint     ? certificate.direction
                   : length > 0 ? Vec3(to_b / length)
                                : Vec3(Vec3::UnitZ());
    const double distance = dot(u, to_b), reach_a = support(a, u), reach_b = support(b, Vec3(-u));
    OverlapStep step = comparison(Stage::search, 0, "c1′·" + name + " > ρ0 + ρ1", distance,
                                  reach_a + reach_b, distance - (reach_a + reach_b), disjoint);
    step.direction = u;
    set_terms(step, {{StepTerm::Of::distance, "c1′·" + name, distance},
                     {StepTerm::Of::a, "−ρ0", -reach_a},
                     {StepTerm::Of::b, "−ρ1", -reach_b}});
    if (ended == Stage::overlapping && step.separates)
        step.skipped = "the engine let the pair pass";
    return step;
}

}  // namespace

PairExplanation explain_nodes(const NodeVolume& a, const NodeVolume& b, const Pose& b_to_a,
                              double tolerance, Stage ended) {
    PairExplanation result;
    const ContactCertificate verdict = exact_verdict(a, b, b_to_a, tolerance);
    Placement placed;
    placed.b_to_a = b_to_a;
    with_shapes(a, b, [&](const auto& va, const auto& vb) {
        const auto in_a = seen_from_a(vb, placed);
        result.certificate = sharpened(va, in_a, verdict);
        result.verified =
            verify(va, in_a, verdict) && check_certificate(va, in_a, result.certificate);
        result.steps.steps.push_back(step_between(va, in_a, result.certificate, ended));
    });
    result.steps.margin = tolerance;
    result.answer = judged(ended, verdict.contact);
    return result;
}

}  // namespace scb
