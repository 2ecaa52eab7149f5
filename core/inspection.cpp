#include "core/inspection.h"

#include <algorithm>
#include <numeric>

#include "core/operation_cost.h"

namespace scb {
namespace {

template <std::size_t n>
void add_each(std::array<std::uint64_t, n>& sums, const std::array<std::uint64_t, n>& more) {
    for (std::size_t i = 0; i < n; ++i) sums[i] += more[i];
}

std::uint64_t tests_below(const FalsePair& p) {
    return p.pair.below.volume_tests + p.pair.below.triangle_tests;
}

bool is_worse(const FalsePair& x, const FalsePair& y) {
    const std::uint64_t of_x = tests_below(x), of_y = tests_below(y);
    if (of_x != of_y) return of_x > of_y;
    return std::pair(x.frame, x.pair.test) < std::pair(y.frame, y.pair.test);
}

bool same(const OverlapOptions& x, const OverlapOptions& y) {
    return x.test == y.test && (!has_threshold(x.test) || x.threshold == y.threshold);
}

}  // namespace

std::uint64_t Inspection::passed() const {
    return std::accumulate(inner.begin(), inner.end(), std::uint64_t{0}) +
           std::accumulate(leaves.begin(), leaves.end(), std::uint64_t{0});
}

Work Inspection::wasted_by_fit() const {
    return {wasted.volume_tests - wasted_by_tests.volume_tests,
            wasted.triangle_tests - wasted_by_tests.triangle_tests,
            wasted.operations - wasted_by_tests.operations};
}

void Inspection::add(const Inspection& other) {
    pairs += other.pairs;
    n_v += other.n_v;
    n_p += other.n_p;
    add_each(inner, other.inner);
    add_each(leaves, other.leaves);
    touching += other.touching;
    wrongly_rejected += other.wrongly_rejected;
    all += other.all;
    wasted += other.wasted;
    wasted_by_tests += other.wasted_by_tests;
    depths.resize(std::max(depths.size(), other.depths.size()));
    for (std::size_t d = 0; d < other.depths.size(); ++d) {
        depths[d].tests += other.depths[d].tests;
        depths[d].wasted += other.depths[d].wasted;
        add_each(depths[d].passed, other.depths[d].passed);
    }
}

Inspection inspection(const TraceFrame& frame, const TestTree& tree,
                      const Attribution& attribution) {
    const std::vector<VolumeTest>& tests = frame.events.volume_tests;
    Inspection result;
    result.pairs = frame.found.pairs.size();
    result.n_v = frame.found.n_v;
    result.n_p = frame.found.n_p;
    result.inner = attribution.inner;
    result.leaves = attribution.leaves;
    result.touching = attribution.touching;
    result.wrongly_rejected = attribution.wrongly_rejected.size();
    result.all = attribution.all;
    result.wasted = attribution.wasted;
    result.wasted_by_tests = attribution.wasted_by_tests;
    result.depths.resize(static_cast<std::size_t>(frame.found.depth) + 1);
    const auto depth_of = [&](std::size_t test) -> DepthInspection& {
        return result.depths[static_cast<std::size_t>(tests[test].depth_a + tests[test].depth_b)];
    };
    std::vector<char> is_false(tests.size());
    for (const PassedPair& pair : attribution.passed) {
        const auto reason = static_cast<std::size_t>(pair.reason);
        ++depth_of(pair.test).passed[reason];
        is_false[pair.test] = pair.reason != PassReason::contact;
    }
    for (std::size_t i = 0; i < tests.size(); ++i) {
        ++depth_of(i).tests;
        const std::uint32_t parent = tree.parents[i];
        if (parent != TestTree::no_parent && is_false[parent]) ++depth_of(i).wasted;
    }
    return result;
}

void WorstPairs::add(const TraceFrame& frame, const Attribution& attribution) {
    const bool weak = reason_ == PassReason::weak_test;
    for (const PassedPair& pair : attribution.passed)
        if (pair.reason == reason_ && !(weak ? pair.within_weak_test : pair.within_false_pair))
            pairs_.push_back({frame.frame, pair, frame.events.volume_tests[pair.test]});
    std::sort(pairs_.begin(), pairs_.end(), is_worse);
    if (pairs_.size() > most_) pairs_.resize(most_);
}

void OtherTest::add(const OtherTest& other) {
    caught += other.caught;
    pairs += other.pairs;
    all += other.all;
}

std::vector<OverlapOptions> other_tests(const TraceHeader& header) {
    std::vector<OverlapOptions> tests;
    if (header.volume != VolumeKind::scb) return tests;
    for (const double threshold : {0.5, 0.7, 0.9})
        tests.push_back({OverlapTest::corrected, threshold});
    tests.push_back({OverlapTest::symmetric, OverlapOptions{}.threshold});
    tests.push_back({OverlapTest::extents, OverlapOptions{}.threshold});
    std::erase_if(tests, [&](const OverlapOptions& o) { return same(o, header.options.overlap); });
    return tests;
}

OtherTest try_other_test(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                         const Mesh& mesh_b, const TraceHeader& header, const TraceFrame& frame,
                         const Attribution& attribution, const OverlapOptions& other) {
    OtherTest result;
    result.overlap = other;
    CollideOptions options = header.options;
    options.overlap = other;
    const Collision found = collide(a, mesh_a, b, mesh_b, frame.b_to_a, options);
    result.pairs = found.pairs.size();
    result.all = {found.n_v, found.n_p, operation_count(header.volume, other, found.stages)};
    const auto* scbs_a = std::get_if<Hierarchy<Scb>>(&a);
    const auto* scbs_b = std::get_if<Hierarchy<Scb>>(&b);
    if (scbs_a == nullptr || scbs_b == nullptr) return result;
    const Placement placed = query_placement(*scbs_a, *scbs_b, frame.b_to_a);
    with_overlap_test<Scb>(other, [&](auto test) {
        for (const PassedPair& pair : attribution.passed) {
            if (pair.reason != PassReason::weak_test) continue;
            const IndexPair nodes = frame.events.volume_tests[pair.test].nodes;
            result.caught += test(scbs_a->volumes[nodes.a], scbs_b->volumes[nodes.b], placed) !=
                             Stage::overlapping;
        }
    });
    return result;
}

}  // namespace scb
