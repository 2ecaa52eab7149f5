#include "core/pair_explanation.h"

#include <cmath>

#include "core/exact_overlap.h"
#include "core/overlap.h"
#include "core/placed_volume.h"

namespace scb {
namespace {

template <class V>
void add_verdict(PairExplanation& result, const V& a, const V& b, double margin) {
    result.proof = sharpened(a, b, exact_overlap(a, b));
    if (!(result.proof.margin > margin)) result.proof = {};
    result.proven = verify(a, b, result.proof);
    result.answer = judged(result.steps.stage(), result.proof.contact);
}

template <class V>
PairExplanation explained(const V& a, const V& b, const Placement& placed,
                          const OverlapOptions& options) {
    PairExplanation result;
    result.steps = overlap_steps(a, b, placed, options);
    add_verdict(result, a, seen_from_a(b, placed), placed.margin);
    return result;
}

}  // namespace

std::string_view answer_name(Answer answer) {
    switch (answer) {
        case Answer::false_positive:
            return "false positive";
        case Answer::false_negative:
            return "false negative";
        case Answer::correct:
            break;
    }
    return "correct";
}

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
        result.tests.push_back({test, stage, judged(stage, result.proof.contact)});
    }
    return result;
}

PairExplanation explain(const Ball& a, const Ball& b, const Placement& placed,
                        const OverlapOptions& options) {
    return explained(a, b, placed, options);
}

PairExplanation explain(const Obb& a, const Obb& b, const Placement& placed,
                        const OverlapOptions& options) {
    return explained(a, b, placed, options);
}

Scb seen_from_a(const Scb& b, const Placement& placed) {
    Scb moved = scb::placed(b, placed.b_to_a);
    moved.n /= std::sqrt(squared_norm(moved.n));
    return moved;
}

Ball seen_from_a(const Ball& b, const Placement& placed) { return scb::placed(b, placed.b_to_a); }

Obb seen_from_a(const Obb& b, const Placement& placed) { return scb::placed(b, placed.b_to_a); }

}  // namespace scb
