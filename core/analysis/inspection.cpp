#include "core/analysis/inspection.h"

#include <algorithm>

namespace scb {

Inspection& Inspection::operator+=(const Inspection& other) {
    pairs += other.pairs;
    counts += other.counts;
    depths.resize(std::max(depths.size(), other.depths.size()));
    for (std::size_t d = 0; d < other.depths.size(); ++d) {
        depths[d].tests += other.depths[d].tests;
        depths[d].wasted += other.depths[d].wasted;
        depths[d].wasted_by_tests += other.depths[d].wasted_by_tests;
        for (std::size_t r = 0; r < pass_reason_count; ++r)
            depths[d].passed[r] += other.depths[d].passed[r];
    }
    return *this;
}

Inspection inspection(const QueryTrace& frame, const Attribution& attribution) {
    const std::vector<Step>& tests = frame.steps.volumes;
    Inspection result;
    result.pairs = frame.found.pairs.size();
    result.counts = attribution.counts;
    result.depths.resize(static_cast<std::size_t>(frame.found.depth) + 1);
    const auto depth_of = [&](std::size_t test) -> DepthInspection& {
        return result.depths[static_cast<std::size_t>(tests[test].depth_a + tests[test].depth_b)];
    };
    std::vector<char> is_false(tests.size()), is_within_weak_test(tests.size());
    for (const PassedPair& pair : attribution.passed) {
        ++depth_of(pair.test).passed[static_cast<std::size_t>(pair.reason)];
        is_false[pair.test] = pair.reason != PassReason::triangles_meet;
        is_within_weak_test[pair.test] =
            pair.within_weak_test || pair.reason == PassReason::weak_test;
    }
    for (std::size_t i = 0; i < tests.size(); ++i) {
        ++depth_of(i).tests;
        const std::uint32_t parent = tests[i].parent;
        if (parent == no_step) continue;
        depth_of(i).wasted += static_cast<std::uint64_t>(is_false[parent]);
        depth_of(i).wasted_by_tests += static_cast<std::uint64_t>(is_within_weak_test[parent]);
    }
    return result;
}

void sort_by_waste(std::vector<InspectedFrame>& frames) {
    std::sort(frames.begin(), frames.end(), [](const InspectedFrame& x, const InspectedFrame& y) {
        const std::uint64_t of_x = x.found.counts.wasted.volume_tests,
                            of_y = y.found.counts.wasted.volume_tests;
        return of_x != of_y ? of_x > of_y : x.frame < y.frame;
    });
}

}  // namespace scb
