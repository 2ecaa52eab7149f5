#include "core/analysis/inspection.h"

#include <algorithm>

namespace scb {

std::uint64_t DepthInspection::wasted_by(PassReason reason) const {
    switch (reason) {
        case PassReason::weak_test:
            return wasted_by_tests;
        case PassReason::loose_fit:
            return wasted - wasted_by_tests - wasted_early - wasted_unjudged;
        case PassReason::triangles_meet:
            break;
        case PassReason::early:
            return wasted_early;
        case PassReason::unjudged:
            return wasted_unjudged;
    }
    return 0;
}

Inspection& Inspection::operator+=(const Inspection& other) {
    pairs += other.pairs;
    counts += other.counts;
    depths.resize(std::max(depths.size(), other.depths.size()));
    for (std::size_t d = 0; d < other.depths.size(); ++d) {
        depths[d].tests += other.depths[d].tests;
        depths[d].wasted += other.depths[d].wasted;
        depths[d].wasted_by_tests += other.depths[d].wasted_by_tests;
        depths[d].wasted_early += other.depths[d].wasted_early;
        depths[d].wasted_unjudged += other.depths[d].wasted_unjudged;
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
    // Queries of distances do not count their depth.
    int deepest = frame.found.depth;
    for (const Step& test : tests) deepest = std::max(deepest, test.depth_a + test.depth_b);
    result.depths.resize(static_cast<std::size_t>(deepest) + 1);
    const auto depth_of = [&](std::size_t test) -> DepthInspection& {
        return result.depths[static_cast<std::size_t>(tests[test].depth_a + tests[test].depth_b)];
    };
    for (const PassedPair& pair : attribution.passed)
        ++depth_of(pair.test).passed[static_cast<std::size_t>(pair.reason)];
    for (std::size_t i = 0; i < tests.size(); ++i) {
        DepthInspection& at = depth_of(i);
        ++at.tests;
        // Without results, tests are not attributed.
        if (attribution.wasted_by.empty()) continue;
        const PassReason reason = attribution.wasted_by[i];
        at.wasted += reason != PassReason::triangles_meet ? 1 : 0;
        at.wasted_by_tests += reason == PassReason::weak_test ? 1 : 0;
        at.wasted_early += reason == PassReason::early ? 1 : 0;
        at.wasted_unjudged += reason == PassReason::unjudged ? 1 : 0;
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
