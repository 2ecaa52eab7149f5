#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/platform/file_window.h"
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

/// The bytes of a recording, which several readers may read: in memory, or in a file of any size.
class RecordingBytes {
  public:
    /// In memory.
    explicit RecordingBytes(std::string bytes) : source_(std::move(bytes)) {}
    /// Of a file, with the size that it has now. Throws InputError if there is no such file.
    static RecordingBytes of_file(const std::string& path);

    std::uint64_t size() const;

  private:
    friend class BlockReader;
    struct OnDisk {
        std::string path;
        std::uint64_t size;
        std::filesystem::file_time_type written;
    };
    explicit RecordingBytes(OnDisk file) : source_(std::move(file)) {}

    std::variant<std::string, OnDisk> source_;
};

/// Reads the blocks of a recording, one after the other. A file is read through a window, so that
/// memory does not depend on its size.
class BlockReader {
  public:
    /// `bytes` must outlive the reader. Throws InputError, one sentence that begins with `name`, if
    /// they are no recording or of a newer version, or if a file has changed since RecordingBytes
    /// was made.
    BlockReader(const RecordingBytes& bytes, std::string_view name);
    BlockReader(std::string_view bytes, std::string_view name);

    /// The next block, valid until the next call. Nothing at the end, or if a block is cut off or
    /// does not fit its checksum.
    std::optional<RecordingBlock> next();
    /// The byte behind the last block.
    std::uint64_t position() const { return position_; }
    bool is_at_end() const { return position_ == size_; }
    std::uint64_t size() const { return size_; }

  private:
    /// The next bytes: at least `count`, or all that are left.
    std::string_view ahead(std::size_t count);
    void skip(std::size_t count);

    std::string_view left_;             ///< in memory
    std::optional<FileWindow> window_;  ///< else
    std::uint64_t position_ = 0, size_ = 0;
    std::vector<std::uint8_t> block_;  ///< of a file
};

/// Appends magic and version.
void begin_recording(ByteWriter& out);
void add_block(ByteWriter& out, std::string_view kind, std::span<const std::uint8_t> content);
/// Appends a block with the size of the plain bytes, and these bytes deflated.
void add_packed_block(ByteWriter& out, std::string_view kind, std::span<const std::uint8_t> plain);
/// The plain bytes of such a block; nothing if they cannot be unpacked.
std::optional<std::vector<std::uint8_t>> unpacked(const RecordingBlock& block);

}  // namespace scb::scenes
