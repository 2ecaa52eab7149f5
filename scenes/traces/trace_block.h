#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scenes/traces/trace_file.h"

namespace scb::scenes {

// What TraceWriter and TraceReader share: the header and one frame as plain bytes, and deflate.

std::vector<std::uint8_t> header_bytes(const TraceHeader& header);
/// Nothing where the bytes are no header.
std::optional<TraceHeader> header_of(std::span<const std::uint8_t> bytes);

/// A frame as bytes; adds to `nodes` what it says about them.
std::vector<std::uint8_t> frame_bytes(const TraceHeader& header, const TraceFrame& frame,
                                      std::array<TraceNodes, 2>& nodes);
/// Reads a frame into `frame` and `nodes`. Returns what is wrong with it, or nothing.
std::string read_frame(const TraceHeader& header, std::span<const std::uint8_t> bytes,
                       std::array<TraceNodes, 2>& nodes, TraceFrame& frame);

/// No packed block unpacks to more than so many times its size and 1024: bytes that repeat
/// further are packed less well, so that a reader can refuse lengths that nobody wrote.
inline constexpr std::size_t most_unpacked = 16;
std::vector<std::uint8_t> pack(std::span<const std::uint8_t> plain);
/// Nothing where the bytes do not unpack to this size.
std::optional<std::vector<std::uint8_t>> unpack(std::span<const std::uint8_t> packed,
                                                std::size_t size);
/// zlib's CRC-32.
std::uint32_t checksum(std::span<const std::uint8_t> bytes);

}  // namespace scb::scenes
