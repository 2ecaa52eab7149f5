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
        at.wasted.add(attribution.wasted_by[i]);
    }
    return result;
}

void sort_by_waste(std::vector<InspectedFrame>& frames) {
    std::sort(frames.begin(), frames.end(), [](const InspectedFrame& x, const InspectedFrame& y) {
        const std::uint64_t of_x = x.found.counts.wasted().volume_tests,
                            of_y = y.found.counts.wasted().volume_tests;
        return of_x != of_y ? of_x > of_y : x.frame < y.frame;
    });
}

}  // namespace scb
