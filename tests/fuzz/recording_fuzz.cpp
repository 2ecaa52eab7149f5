#include "scenes/recordings/recording_json.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/scenes/recordings/recording_block.h"

using namespace scb;

namespace {

/// Records as JSON and back are the same bytes, which say the same again.
void read_recording(std::string_view bytes) {
    try {
        const std::string text = scenes::recording_as_json(bytes, "input"),
                          again = scenes::recording_of_json(text, "text");
        fuzz::require(scenes::recording_as_json(again, "again") == text, "JSON loses nothing");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, "input");
    }
}

}  // namespace

SCB_FUZZ(input) {
    const std::string_view text(reinterpret_cast<const char*>(input.data()), input.size());
    read_recording(text);
    read_recording(scenes::recording_with_block(std::string(text)));
    try {
        scenes::recording_of_json(text, "input");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, "input");
    }
}
