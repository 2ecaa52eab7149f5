#include "core/judge/query_attribution.h"

namespace scb {
namespace {

/// Per test: 1 if a pair was found below it, plus the number of pairs missed below it.
std::vector<std::uint64_t> contacts_below(const QueryJudgement& judged) {
    std::vector<std::uint64_t> contacts;
    for (const JudgedTest& test : judged.tests) contacts.push_back(test.meets ? 1 : 0);
    for (const PairProblem& problem : judged.pairs) {
        if (!is_missed(problem.cause)) continue;
        for (std::uint32_t i = problem.test; i != no_index; i = judged.tests[i].parent)
            ++contacts[i];
    }
    return contacts;
}

}  // namespace

Attribution attribution(const EngineQuery& query, const QueryJudgement& judged,
                        const TraceHeader& header, const QueryTrace& frame) {
    // Without results, the pairs below a test are unknown.
    if (!query.has_item_tests && !query.has_pairs) return {};
    const std::vector<std::uint64_t> contacts = contacts_below(judged);
    std::vector<TestedPair> pairs;
    for (std::size_t i = 0; i < judged.tests.size(); ++i) {
        const JudgedTest& test = judged.tests[i];
        if (test.nodes.a == no_index || test.nodes.b == no_index) continue;
        TestedPair pair;
        pair.known = test.verdict != TestVerdict::unjudged || is_of_distance(header.kind);
        const bool passed = frame.steps.volumes[pairs.size()].stage == Stage::overlapping;
        pair.early = test.early;
        // Without a proof, the volumes touch.
        if (test.is_proven(header.kind))
            pair.exact = (test.verdict == TestVerdict::right) == passed ? Contact::overlapping
                                                                        : Contact::disjoint;
        pair.gap = pair.exact == Contact::disjoint ? test.margin : 0;
        // Of several nearest pairs, a query may leave out all but one.
        pair.contacts = passed || header.kind != QueryKind::distance ? contacts[i] : 0;
        pair.leaves = query.sides[0].shape->is_leaf(test.nodes.a) &&
                      query.sides[1].shape->is_leaf(test.nodes.b);
        pairs.push_back(pair);
    }
    return attribute(header, frame, pairs);
}

}  // namespace scb
