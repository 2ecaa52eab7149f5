#include "core/explain/pair_explanation.h"

#include "core/explain/certificate_check.h"
#include "core/explain/exact_overlap.h"
#include "core/overlap/test_functors.h"
#include "scb/overlap.h"

namespace scb {
namespace {

template <class V>
PairExplanation explained(const V& a, const V& b, const Placement& placed,
                          const OverlapOptions& options) {
    PairExplanation result;
    result.steps = overlap_steps(a, b, placed, options);
    const ContactCertificate verdict = exact_verdict(a, b, placed);
    const V in_a = seen_from_a(b, placed);
    result.certificate = sharpened(a, in_a, verdict);
    result.verified = verify(a, in_a, verdict) && check_certificate(a, in_a, result.certificate);
    result.answer = judged(result.steps.stage(), verdict.contact);
    return result;
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

PairExplanation explain(const Scb& a, const Scb& b, const Placement& placed,
                        const OverlapOptions& options) {
    PairExplanation result = explained(a, b, placed, options);
    for (const OverlapTest test : all_overlap_tests()) {
        const Stage stage = with_overlap_test<Scb>({test, options.threshold},
                                                   [&](const auto& t) { return t(a, b, placed); });
        result.tests.push_back({test, stage, judged(stage, result.certificate.contact)});
    }
    return result;
}

PairExplanation explain(const Scb2& a, const Scb2& b, const Placement& placed,
                        const OverlapOptions& options) {
    return explained(a, b, placed, options);
}

PairExplanation explain(const Ball& a, const Ball& b, const Placement& placed,
                        const OverlapOptions& options) {
    return explained(a, b, placed, options);
}

PairExplanation explain(const Obb& a, const Obb& b, const Placement& placed,
                        const OverlapOptions& options) {
    return explained(a, b, placed, options);
}

}  // namespace scb
