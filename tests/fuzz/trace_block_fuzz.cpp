#include "scenes/recordings/trace_block.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

namespace {

/// A length of 16 bits, and what follows.
std::span<const std::uint8_t> take_part(std::span<const std::uint8_t>& input) {
    if (input.size() < 2) return {};
    const std::size_t size =
        std::min<std::size_t>(static_cast<std::size_t>(input[0] | input[1] << 8), input.size() - 2);
    const auto part = input.subspan(2, size);
    input = input.subspan(2 + size);
    return part;
}

}  // namespace

// What is in a trace, as it is before it is packed and has its checksum: a header, then frames.
SCB_FUZZ(input) {
    const std::optional<TraceHeader> header = scenes::header_of(take_part(input));
    if (!header) return;
    std::array<scenes::TraceNodes, 2> nodes, written;
    QueryTrace frame;
    while (!input.empty()) {
        const auto part = take_part(input);
        if (!scenes::read_frame(*header, part, nodes, frame).empty()) return;
        // What was read is written as something that reads as the same.
        std::array<scenes::TraceNodes, 2> again = written;
        QueryTrace copy;
        const std::vector<std::uint8_t> bytes = scenes::frame_bytes(*header, frame, written);
        fuzz::require(scenes::read_frame(*header, bytes, again, copy).empty(),
                      "a frame that was written can be read");
        fuzz::require(
            copy.steps.volumes == frame.steps.volumes && copy.found.pairs == frame.found.pairs,
            "a frame is read as it was written");
        fuzz::require(copy.nearest.has_value() == frame.nearest.has_value() &&
                          (!frame.nearest || frame.nearest->distance == copy.nearest->distance),
                      "an answer is read as it was written");
    }
}
