#include "core/analysis/ending.h"

namespace scb {

std::vector<EndingCounts> endings_by_depth(const TraceFrame& frame, const TraversalTree& tree) {
    std::vector<EndingCounts> counts;
    for (std::size_t i = 0; i < tree.outcomes.size(); ++i) {
        const VolumeTest& test = frame.events.volume_tests[i];
        const std::size_t depth = std::size_t{test.depth_a} + test.depth_b;
        if (depth >= counts.size()) counts.resize(depth + 1);
        if (is_ending(tree.outcomes[i]))
            ++counts[depth][static_cast<std::size_t>(tree.outcomes[i])];
    }
    return counts;
}

EndingCounts ending_counts(const TraceFrame& frame, const TraversalTree& tree) {
    EndingCounts sum{};
    for (const EndingCounts& counts : endings_by_depth(frame, tree))
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += counts[i];
    return sum;
}

std::vector<Outcome> endings_of(VolumeKind kind, const CollideOptions& options) {
    std::vector<Outcome> endings;
    for (const Stage stage : stages_of(kind, options.overlap))
        endings.push_back(rejected_at(stage));
    if (options.stop_level >= 0)
        endings.push_back(Outcome::found);
    else
        endings.insert(endings.end(), {Outcome::triangles_apart, Outcome::triangles_meet});
    endings.push_back(Outcome::left_over);
    return endings;
}

}  // namespace scb
