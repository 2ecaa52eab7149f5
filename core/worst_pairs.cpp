#include "core/worst_pairs.h"

#include <algorithm>
#include <set>

namespace scb {
namespace {

std::uint64_t tests_below(const FalsePair& p) {
    return p.pair.below.volume_tests + p.pair.below.triangle_tests;
}

bool is_worse(const FalsePair& x, const FalsePair& y) {
    const std::uint64_t of_x = tests_below(x), of_y = tests_below(y);
    if (of_x != of_y) return of_x > of_y;
    return std::pair(x.frame, x.pair.test) < std::pair(y.frame, y.pair.test);
}

/// Keeps the first of those with the same nodes, and at most that many.
template <class P>
void keep_worst(std::vector<P>& sorted, std::size_t most) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    std::vector<P> kept;
    for (const P& pair : sorted) {
        if (kept.size() == most) break;
        const IndexPair nodes = pair.test.nodes;
        if (seen.insert({nodes.a, nodes.b}).second) kept.push_back(pair);
    }
    sorted = std::move(kept);
}

}  // namespace

void WorstPairs::add(const TraceFrame& frame, const Attribution& attribution) {
    const bool weak = reason_ == PassReason::weak_test;
    for (const PassedPair& pair : attribution.passed)
        if (pair.reason == reason_ && !(weak ? pair.within_weak_test : pair.within_false_pair))
            pairs_.push_back({frame.frame, pair, frame.events.volume_tests[pair.test]});
    std::sort(pairs_.begin(), pairs_.end(), is_worse);
    keep_worst(pairs_, most_);
}

void WorstRejections::add(const TraceFrame& frame, const Attribution& attribution) {
    for (const WrongRejection& rejection : attribution.wrongly_rejected)
        pairs_.push_back({frame.frame, rejection, frame.events.volume_tests[rejection.test]});
    // Frames are added in their order, and tests are in theirs.
    std::stable_sort(pairs_.begin(), pairs_.end(), [](const auto& x, const auto& y) {
        return x.rejection.missed > y.rejection.missed;
    });
    keep_worst(pairs_, most_);
}

}  // namespace scb
