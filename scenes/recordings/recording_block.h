#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "scenes/recordings/byte_stream.h"

namespace scb::scenes {

// The frame of a recording (`.scbrec`): magic, version, and blocks. README.md of this folder has
// the whole format.

/// The highest version that is read, and the one that is written.
inline constexpr std::uint32_t recording_version = 1;

inline constexpr std::string_view recording_magic = "\x89scbrc\r\n";

/// Kinds of blocks. Records are in `data` blocks, or deflated in `pack` blocks. A compact recording
/// has one `head` block first, then a `step` block per frame, then a `data` block with the end.
/// Blocks of other kinds are of a newer version, and may be skipped.
inline constexpr std::string_view data_block = "data", packed_block = "pack", head_block = "head",
                                  step_block = "step";

struct RecordingBlock {
    std::string_view kind;                  ///< four letters
    std::span<const std::uint8_t> content;  ///< in the bytes of the file
};

/// Whether the bytes start as a recording does.
bool starts_as_recording(std::string_view bytes);
/// Whether the bytes start as a compact recording does.
bool starts_as_compact(std::string_view bytes);
/// As many bytes as starts_as_compact needs.
inline constexpr std::size_t compact_start = 20;

/// The bytes behind the version. Throws InputError if they are no recording, or of a newer version.
std::span<const std::uint8_t> recording_blocks(std::string_view bytes, std::string_view name);

/// The next block. Nothing if the bytes end before the block does, and then `in.ok` is false; or if
/// the block does not fit its checksum.
std::optional<RecordingBlock> take_block(ByteReader& in);

/// Appends magic and version.
void begin_recording(ByteWriter& out);
void add_block(ByteWriter& out, std::string_view kind, std::span<const std::uint8_t> content);
/// Appends a block with the size of the plain bytes, and these bytes deflated.
void add_packed_block(ByteWriter& out, std::string_view kind, std::span<const std::uint8_t> plain);
/// The plain bytes of such a block; nothing if they cannot be unpacked.
std::optional<std::vector<std::uint8_t>> unpacked(const RecordingBlock& block);

}  // namespace scb::scenes
