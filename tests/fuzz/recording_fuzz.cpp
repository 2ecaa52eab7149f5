#include <zlib.h>

#include "scenes/recordings/recording_file.h"
#include "scenes/recordings/recording_json.h"
#include "tests/fuzz/fuzz_input.h"

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

/// The bytes as what a block holds, with the checksum that they ask for.
std::string in_a_block(std::string_view payload) {
    std::string bytes = scenes::RecordingWriter().finish();
    const auto put = [&bytes](std::uint32_t value) {
        for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift);
    };
    put(static_cast<std::uint32_t>(payload.size()));
    const std::string checked = "data" + std::string(payload);
    bytes += checked;
    put(static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const Bytef*>(checked.data()), checked.size())));
    return bytes;
}

}  // namespace

SCB_FUZZ(input) {
    const std::string_view text(reinterpret_cast<const char*>(input.data()), input.size());
    read_recording(text);
    read_recording(in_a_block(text));
    try {
        scenes::recording_of_json(text, "input");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, "input");
    }
}
