#include "core/analysis/ending.h"

#include <algorithm>

namespace scb {

std::string_view ending_name(Ending ending) {
    switch (ending) {
        case Ending::triangles_apart:
            return "triangles apart";
        case Ending::triangles_meet:
            return "triangles meet";
        case Ending::found:
            return "found";
        case Ending::left_over:
            return "left over";
    }
    return stage_name(static_cast<Stage>(ending));
}

std::optional<Ending> ending_of(std::string_view name) {
    for (std::size_t i = 1; i < ending_count; ++i)
        if (ending_name(static_cast<Ending>(i)) == name) return static_cast<Ending>(i);
    return std::nullopt;
}

std::optional<Ending> ending_of(const VolumeTest& test, Outcome outcome) {
    switch (outcome) {
        case Outcome::divided_a:
        case Outcome::divided_b:
            return std::nullopt;
        case Outcome::rejected:
            return rejected_at(test.stage);
        case Outcome::triangles_apart:
            return Ending::triangles_apart;
        case Outcome::triangles_meet:
            return Ending::triangles_meet;
        case Outcome::found:
            return Ending::found;
        case Outcome::left_over:
            return Ending::left_over;
    }
    return std::nullopt;
}

std::vector<EndingCounts> endings_by_depth(const TraceFrame& frame, const TestTree& tree) {
    std::vector<EndingCounts> counts;
    for (std::size_t i = 0; i < tree.outcomes.size(); ++i) {
        const VolumeTest& test = frame.events.volume_tests[i];
        const std::size_t depth = std::size_t{test.depth_a} + test.depth_b;
        if (depth >= counts.size()) counts.resize(depth + 1);
        if (const auto ending = ending_of(test, tree.outcomes[i]))
            ++counts[depth][static_cast<std::size_t>(*ending)];
    }
    return counts;
}

EndingCounts ending_counts(const TraceFrame& frame, const TestTree& tree) {
    EndingCounts sum{};
    for (const EndingCounts& counts : endings_by_depth(frame, tree))
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += counts[i];
    return sum;
}

std::vector<Ending> endings_of(VolumeKind kind, const CollideOptions& options) {
    std::vector<Ending> endings;
    for (const Stage stage : stages_of(kind, options.overlap))
        endings.push_back(rejected_at(stage));
    if (options.stop_level >= 0)
        endings.push_back(Ending::found);
    else
        endings.insert(endings.end(), {Ending::triangles_apart, Ending::triangles_meet});
    endings.push_back(Ending::left_over);
    return endings;
}

}  // namespace scb
