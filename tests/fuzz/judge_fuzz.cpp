#include "scenes/recordings/recording_judgement.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/scenes/recordings/recording_block.h"

using namespace scb;

/// The input is the payload of a block.
SCB_FUZZ(input) {
    const std::string bytes = scenes::recording_with_block(
        std::string(reinterpret_cast<const char*>(input.data()), input.size()));
    try {
        const scenes::RecordingJudgement judged = scenes::judge_recording(
            bytes, "input", [](int) { return true; }, [] { return true; });
        std::uint64_t missed = 0, of_causes = 0;
        for (const scenes::FrameJudgement& frame : judged.frames) missed += frame.missed;
        for (const scenes::ProblemGroup& group : judged.missed) of_causes += group.count;
        fuzz::require(missed == of_causes, "each missed pair has a cause");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, "input");
    }
}
