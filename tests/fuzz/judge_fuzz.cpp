#include <algorithm>

#include "core/analysis/ended_paths.h"
#include "core/analysis/ending.h"
#include "core/analysis/triangle_heat.h"
#include "core/model/level_statistics.h"
#include "scenes/recordings/recorded_trace.h"
#include "scenes/recordings/recording_judgement.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/scenes/recordings/recording_block.h"

using namespace scb;

namespace {

/// What pictures make of a body.
void use(const Tree& tree) {
    const TreeShape& shape = tree.shape();
    const std::size_t all = level_cover(shape, -1).size();
    for (int level = 0; level <= std::min(depth(shape), 4); ++level)
        cover_statistics(tree, level_cover(shape, level));
    fuzz::require(all <= shape.size(), "leaves are nodes");
}

/// What pictures and tables make of a recording.
void show(const std::shared_ptr<const scenes::RecordingFile>& file) {
    scenes::RecordedTrace recorded(
        std::make_shared<const scenes::Recording>(scenes::read_recording(file)), "", "all");
    const TraceHeader& header = recorded.header();
    for (const int number : recorded.frames()) {
        const QueryTrace& frame = recorded.frame(number);
        const Outcomes outcomes = outcomes_of(header, frame);
        const EndingCounts counts = ending_counts(outcomes);
        std::uint64_t ended = 0;
        for (const std::uint64_t count : counts) ended += count;
        fuzz::require(ended <= frame.found.n_v, "a path ends once");
        for (std::size_t side = 0; side < 2; ++side) {
            const BodyAtFrame body = recorded.body(side, number);
            if (number == recorded.frames().front()) use(*body.tree);
            const TreeShape& shape = body.tree->shape();
            innermost(ended_paths(frame, outcomes, side), shape);
            if (!header.engine->objects) triangle_heat(frame.steps, shape, side, HeatOf::triangles);
            triangle_heat(frame.steps, shape, side, HeatOf::volumes);
        }
    }
}

}  // namespace

/// The input is the payload of a block.
SCB_FUZZ(input) {
    std::string bytes = scenes::recording_with_block(
        std::string(reinterpret_cast<const char*>(input.data()), input.size()));
    try {
        const auto file = std::make_shared<const scenes::RecordingFile>(std::move(bytes), "input");
        const scenes::RecordingJudgement judged = scenes::judge_recording(
            *file, [](int) { return true; }, [](bool) { return true; });
        std::uint64_t missed = 0, of_causes = 0;
        for (const scenes::FrameJudgement& frame : judged.frames) missed += frame.missed;
        for (const scenes::ProblemGroup& group : judged.missed) of_causes += group.count;
        fuzz::require(missed == of_causes, "each missed pair has a cause");
        show(file);
    } catch (const InputError& error) {
        fuzz::require_sentence(error, "input");
    }
}
