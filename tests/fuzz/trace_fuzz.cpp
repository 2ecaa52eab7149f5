#include <zlib.h>

#include "scenes/recordings/trace_file.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/scenes/recordings/recording_block.h"

using namespace scb;

namespace {

void read_trace(std::span<const std::uint8_t> bytes) {
    try {
        scenes::TraceReader reader(bytes, "input");
        for (int frames = 0; frames < 100 && reader.next() != nullptr; ++frames) {
        }
    } catch (const InputError& error) {
        fuzz::require_sentence(error, "input");
    }
}

}  // namespace

SCB_FUZZ(input) {
    read_trace(input);
    // Also with the checksums that these bytes ask for, which chance does not find: behind the
    // beginning of a compact recording, and as a trace of scb 1.0.
    std::vector<std::uint8_t> compact;
    const std::string start = scenes::recording_with_block("");
    compact.assign(start.begin(), start.begin() + 12);
    compact.insert(compact.end(), input.begin(), input.end());
    read_trace(scenes::with_fitting_checksums(compact));
    if (input.size() < 4) return;
    std::vector<std::uint8_t> bytes(input.begin(), input.end());
    const auto sum = static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size() - 4));
    for (std::size_t i = 0; i < 4; ++i)
        bytes[bytes.size() - 4 + i] = static_cast<std::uint8_t>(sum >> (8 * i));
    read_trace(bytes);
}
