#pragma once

#include <array>
#include <vector>

#include "scenes/recordings/trace_block.h"

namespace scb::scenes {

/// The frames of a trace as plain bytes.
inline std::vector<std::vector<std::uint8_t>> plain_frames(const Trace& trace) {
    std::array<TraceNodes, 2> nodes;
    std::vector<std::vector<std::uint8_t>> frames;
    for (const QueryTrace& frame : trace.frames)
        frames.push_back(frame_bytes(trace.header, frame, nodes));
    return frames;
}

/// A trace of these frames as scb 1.0 wrote it.
inline std::vector<std::uint8_t> trace_file_1_0(
    const TraceHeader& header, const std::vector<std::vector<std::uint8_t>>& frames) {
    ByteWriter out;
    out.append(as_bytes("\x89scbtr\r\n"));
    out.fixed32(1);
    const std::vector<std::uint8_t> head = header_bytes(header);
    out.varint(head.size());
    out.append(head);
    for (const std::vector<std::uint8_t>& frame : frames) {
        const std::vector<std::uint8_t> packed = pack(frame);
        out.varint(packed.size());
        out.varint(frame.size());
        out.append(packed);
    }
    out.varint(0);
    out.fixed32(checksum(out.bytes));
    return out.bytes;
}

}  // namespace scb::scenes
