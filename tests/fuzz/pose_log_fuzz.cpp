#include "scenes/scene/pose_log.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

SCB_FUZZ(input) {
    const fuzz::InputFile file(input);
    try {
        scenes::PoseLogs logs(false);
        const scenes::Motion motion = logs.read(file.path());
        fuzz::require(logs.frames() > 0, "a log has frames");
        for (int frame = 0; frame < logs.frames(); ++frame)
            check_rigid(scenes::pose_at(motion, frame), "a pose");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, file.path());
    }
}
