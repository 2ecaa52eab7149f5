#include "core/analysis/ending.h"

#include <utility>

namespace scb {

std::vector<EndingCounts> endings_by_depth(const QueryTrace& frame, const Outcomes& outcomes) {
    std::vector<EndingCounts> counts;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const Step& test = frame.steps.volumes[i];
        const std::size_t depth = std::size_t{test.depth_a} + test.depth_b;
        if (depth >= counts.size()) counts.resize(depth + 1);
        if (is_ending(outcomes[i])) ++counts[depth][static_cast<std::size_t>(outcomes[i])];
    }
    return counts;
}

EndingCounts ending_counts(const Outcomes& outcomes) {
    EndingCounts counts{};
    // A branch for each of millions of outcomes could not be predicted.
    for (const Stage outcome : outcomes) ++counts[static_cast<std::size_t>(outcome)];
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (!is_ending(static_cast<Stage>(i))) counts[i] = 0;
    return counts;
}

namespace {

std::vector<Stage> with_ends(std::vector<Stage> endings, QueryKind kind, bool of_nodes) {
    if (of_nodes)
        endings.push_back(Stage::found);
    else
        endings.insert(endings.end(), {Stage::triangles_apart, Stage::triangles_meet});
    if (kind == QueryKind::self && !of_nodes) endings.push_back(Stage::neighbors);
    endings.push_back(Stage::left_over);
    return endings;
}

}  // namespace

std::vector<Stage> endings_of(VolumeKind volume, const CollideOptions& options, QueryKind kind) {
    const std::span<const Stage> stages =
        is_of_distance(kind) ? distance_stages(volume) : stages_of(volume, options.overlap);
    return with_ends({stages.begin(), stages.end()}, kind, options.stop_level >= 0);
}

std::vector<Stage> endings_of(const TraceHeader& header) {
    if (!header.engine) return endings_of(header.volume, header.options, header.kind);
    return with_ends(header.engine->stages, QueryKind::collide, pairs_are_nodes(header));
}

std::vector<std::pair<std::string, std::uint64_t>> tests_by_stage(const TraceHeader& header,
                                                                  const QueryTrace& frame) {
    EndingCounts counts{};
    for (const Step& test : frame.steps.volumes) ++counts[static_cast<std::size_t>(test.stage)];
    std::vector<std::pair<std::string, std::uint64_t>> tests = {
        {std::string(stage_name(Stage::overlapping)), counts[0]}};
    for (const Stage ending : endings_of(header))
        if (is_rejection(ending))
            tests.emplace_back(stage_words(header, ending),
                               counts[static_cast<std::size_t>(ending)]);
    return tests;
}

std::optional<Stage> ending_of(const TraceHeader& header, std::string_view name) {
    for (const Stage ending : endings_of(header))
        if (stage_words(header, ending) == name) return ending;
    return std::nullopt;
}

}  // namespace scb
