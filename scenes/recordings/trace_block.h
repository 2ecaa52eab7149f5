#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scenes/recordings/trace_file.h"

namespace scb::scenes {

// What TraceWriter and TraceReader share: the header and one frame as plain bytes, and deflate.

std::vector<std::uint8_t> header_bytes(const TraceHeader& header);
/// Nothing if the bytes are no header.
std::optional<TraceHeader> header_of(std::span<const std::uint8_t> bytes);

/// A frame as bytes. Adds the links that it writes to `nodes`.
std::vector<std::uint8_t> frame_bytes(const TraceHeader& header, const QueryTrace& frame,
                                      std::array<TraceNodes, 2>& nodes);
/// Reads a frame into `frame` and `nodes`. Returns the error as a clause, or an empty text.
std::string read_frame(const TraceHeader& header, std::span<const std::uint8_t> bytes,
                       std::array<TraceNodes, 2>& nodes, QueryTrace& frame);

/// A packed block unpacks to at most this many times its size plus 1024. Bytes that repeat more are
/// packed less well, so that a reader can refuse larger lengths.
inline constexpr std::size_t most_unpacked = 16;
std::vector<std::uint8_t> pack(std::span<const std::uint8_t> plain);
/// Nothing if the bytes do not unpack to this size.
std::optional<std::vector<std::uint8_t>> unpack(std::span<const std::uint8_t> packed,
                                                std::size_t size);
/// zlib's CRC-32.
std::uint32_t checksum(std::span<const std::uint8_t> bytes);

}  // namespace scb::scenes
