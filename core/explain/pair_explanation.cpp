#include "core/explain/pair_explanation.h"

#include "core/explain/contact_certificate.h"
#include "core/explain/exact_overlap.h"
#include "core/explain/overlap_steps_convex.h"
#include "core/overlap/test_functors.h"
#include "core/volumes/shape.h"
#include "scb/overlap.h"

namespace scb {
namespace {

/// The result of each test for slab cut balls; empty for other volumes.
template <Volume V>
std::vector<TestAnswer> answers_of(const V& a, const V& b, const Placement& placed,
                                   const OverlapOptions& options, Contact contact) {
    std::vector<TestAnswer> answers;
    if constexpr (std::same_as<V, Scb>)
        for (const OverlapTest test : all_overlap_tests()) {
            const Stage stage = with_overlap_test<Scb>(
                {test, options.threshold}, [&](const auto& t) { return t(a, b, placed); });
            answers.push_back({test, stage, judged(stage, contact)});
        }
    return answers;
}

}  // namespace

std::string ending_words(Stage stage) {
    return stage == Stage::overlapping ? "passed" : "rejected at " + std::string(stage_name(stage));
}

Answer judged(Stage stage, Contact contact) {
    if (stage == Stage::overlapping && contact == Contact::disjoint) return Answer::false_positive;
    if (stage != Stage::overlapping && contact == Contact::overlapping)
        return Answer::false_negative;
    return Answer::correct;
}

template <Volume V>
PairExplanation explain(const V& a, const V& b, const Placement& placed,
                        const OverlapOptions& options) {
    PairExplanation result;
    result.steps = overlap_steps(a, b, placed, options);
    const auto shape = shape_of(a);
    const ContactCertificate verdict = exact_verdict(shape, shape_of(b), placed);
    const auto in_a = seen_from_a(shape_of(b), placed);
    result.certificate = sharpened(shape, in_a, verdict);
    result.verified =
        verify(shape, in_a, verdict) && check_certificate(shape, in_a, result.certificate);
    result.answer = judged(result.steps.stage(), verdict.contact);
    result.tests = answers_of(a, b, placed, options, verdict.contact);
    return result;
}

#define SCB_INSTANTIATE(V) \
    template PairExplanation explain(const V&, const V&, const Placement&, const OverlapOptions&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
