#include "core/analysis/worst_pairs.h"

#include <algorithm>
#include <set>
#include <utility>

namespace scb {
namespace {

std::uint64_t tests_below(const PassedPair& pair) {
    return pair.below.volume_tests + pair.below.triangle_tests;
}

std::uint64_t tests_below(const FalsePair& p) { return tests_below(p.pair); }

bool is_worse(const FalsePair& x, const FalsePair& y) {
    const std::uint64_t of_x = tests_below(x), of_y = tests_below(y);
    if (of_x != of_y) return of_x > of_y;
    return std::pair(x.frame, x.pair.test) < std::pair(y.frame, y.pair.test);
}

bool misses_more(const WronglyRejectedPair& x, const WronglyRejectedPair& y) {
    if (x.rejection.missed != y.rejection.missed) return x.rejection.missed > y.rejection.missed;
    return std::pair(x.frame, x.rejection.test) < std::pair(y.frame, y.rejection.test);
}

/// Keeps at most `most` pairs; of pairs with the same nodes, the first.
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

/// The test of a frame, with the numbers of its nodes.
Step numbered(const QueryTrace& frame, std::uint32_t test) {
    Step step = frame.steps.volumes[test];
    step.nodes = numbers_of(frame, step.nodes);
    return step;
}

}  // namespace

void WorstPairs::add(const QueryTrace& frame, const Attribution& attribution) {
    // Per test, the cost of the listed pair that it is a part of; parents come first.
    std::vector<std::uint64_t> listed(frame.steps.volumes.size());
    for (const PassedPair& pair : attribution.passed) {
        const std::uint32_t parent = frame.steps.volumes[pair.test].parent;
        const std::uint64_t around = parent == no_step ? 0 : listed[parent];
        listed[pair.test] = around;
        if (pair.reason != reason_ || tests_below(pair) == 0) continue;
        const Step& test = frame.steps.volumes[pair.test];
        if (parent == no_step && test.depth_a == 0 && test.depth_b == 0) {
            listed[pair.test] = tests_below(pair);
            continue;
        }
        const FalsePair found{frame.frame, pair, numbered(frame, pair.test)};
        const bool outermost = reason_ == PassReason::loose_fit
                                   ? pair.within == PassReason::triangles_meet
                                   : pair.within != reason_;
        if (!outermost && (around == 0 || 4 * tests_below(found) > around)) continue;
        (outermost ? outermost_ : parts_).push_back(found);
        listed[pair.test] = tests_below(found);
    }
    keep_worst_ones();
}

void WorstPairs::add(const std::vector<FalsePair>& outermost, const std::vector<FalsePair>& parts) {
    outermost_.insert(outermost_.end(), outermost.begin(), outermost.end());
    parts_.insert(parts_.end(), parts.begin(), parts.end());
    keep_worst_ones();
}

void WorstPairs::keep_worst_ones() {
    for (std::vector<FalsePair>* pairs : {&outermost_, &parts_}) {
        std::sort(pairs->begin(), pairs->end(), is_worse);
        keep_worst(*pairs, most_);
    }
}

std::vector<FalsePair> WorstPairs::pairs() const {
    std::vector<FalsePair> all = outermost_;
    all.insert(all.end(), parts_.begin(), parts_.end());
    keep_worst(all, most_);
    std::sort(all.begin(), all.end(), is_worse);
    return all;
}

void WorstRejections::add(const QueryTrace& frame, const Attribution& attribution) {
    for (const WrongRejection& rejection : attribution.wrongly_rejected)
        pairs_.push_back({frame.frame, rejection, numbered(frame, rejection.test)});
    add(std::vector<WronglyRejectedPair>{});
}

void WorstRejections::add(const std::vector<WronglyRejectedPair>& pairs) {
    pairs_.insert(pairs_.end(), pairs.begin(), pairs.end());
    std::sort(pairs_.begin(), pairs_.end(), misses_more);
    keep_worst(pairs_, most_);
}

}  // namespace scb
