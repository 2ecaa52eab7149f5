#include <zlib.h>

#include "scenes/traces/trace_file.h"
#include "tests/fuzz/fuzz_input.h"

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
    // Also with the checksum that these bytes ask for, which chance does not find.
    if (input.size() < 4) return;
    std::vector<std::uint8_t> bytes(input.begin(), input.end());
    const auto sum = static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size() - 4));
    for (std::size_t i = 0; i < 4; ++i)
        bytes[bytes.size() - 4 + i] = static_cast<std::uint8_t>(sum >> (8 * i));
    read_trace(bytes);
}
