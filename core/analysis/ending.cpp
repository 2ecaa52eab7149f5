#include "core/analysis/ending.h"

#include <utility>

namespace scb {

std::vector<EndingCounts> endings_by_depth(const TraceFrame& frame, const Outcomes& outcomes) {
    std::vector<EndingCounts> counts;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const Step& test = frame.steps.volumes[i];
        const std::size_t depth = std::size_t{test.depth_a} + test.depth_b;
        if (depth >= counts.size()) counts.resize(depth + 1);
        if (is_ending(outcomes[i])) ++counts[depth][static_cast<std::size_t>(outcomes[i])];
    }
    return counts;
}

EndingCounts ending_counts(const TraceFrame& frame, const Outcomes& outcomes) {
    EndingCounts sum{};
    for (const EndingCounts& counts : endings_by_depth(frame, outcomes))
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += counts[i];
    return sum;
}

namespace {

std::vector<Outcome> with_ends(std::vector<Outcome> endings, QueryKind kind, bool of_nodes) {
    if (of_nodes)
        endings.push_back(Outcome::found);
    else
        endings.insert(endings.end(), {Outcome::triangles_apart, Outcome::triangles_meet});
    if (kind == QueryKind::self && !of_nodes) endings.push_back(Outcome::neighbors);
    endings.push_back(Outcome::left_over);
    return endings;
}

}  // namespace

std::vector<Outcome> endings_of(VolumeKind volume, const CollideOptions& options, QueryKind kind) {
    std::vector<Outcome> endings;
    for (const Stage stage : stages_of(volume, options.overlap))
        endings.push_back(rejected_at(stage));
    return with_ends(std::move(endings), kind, options.stop_level >= 0);
}

std::vector<Outcome> endings_of(const TraceHeader& header) {
    if (!header.engine) return endings_of(header.volume, header.options, header.kind);
    std::vector<Outcome> endings;
    for (const NamedStage& stage : header.engine->stages)
        endings.push_back(rejected_at(stage.stage));
    return with_ends(std::move(endings), QueryKind::collide, pairs_are_nodes(header));
}

std::vector<std::pair<std::string, std::uint64_t>> tests_by_stage(const TraceHeader& header,
                                                                  const TraceFrame& frame) {
    EndingCounts counts{};
    for (const Step& test : frame.steps.volumes) ++counts[static_cast<std::size_t>(test.stage)];
    std::vector<std::pair<std::string, std::uint64_t>> tests = {
        {std::string(stage_name(Stage::overlapping)), counts[0]}};
    for (const Outcome ending : endings_of(header))
        if (is_rejection(ending))
            tests.emplace_back(ending_words(header, ending),
                               counts[static_cast<std::size_t>(ending)]);
    return tests;
}

std::string ending_words(const TraceHeader& header, Outcome ending) {
    return is_rejection(ending) ? stage_words(header, static_cast<Stage>(ending))
                                : std::string(outcome_name(ending));
}

std::optional<Outcome> ending_of(const TraceHeader& header, std::string_view name) {
    for (const Outcome ending : endings_of(header))
        if (ending_words(header, ending) == name) return ending;
    return std::nullopt;
}

}  // namespace scb
