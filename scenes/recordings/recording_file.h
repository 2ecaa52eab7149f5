#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/recordings/record.h"
#include "scenes/recordings/recording_block.h"

namespace scb::scenes {

/// The bytes behind a record's tag and length. Two records of a kind are equal if their payloads
/// are, NaN included. Empty for a test.
std::vector<std::uint8_t> record_payload(const Record& record);

/// Reads the records of a file (`.scbrec`), one after the other.
///
/// A file that is cut off or damaged is read up to the last whole block before the damage, and
/// `damage` reports it. Throws InputError, one sentence that starts with `name`, if the bytes are
/// no recording, of a newer version or a compact recording, and if a whole block contradicts
/// itself. A file of n bytes takes O(n) time and the memory of its largest block. Packed blocks
/// unpack to at most 16 times their size plus 1024 bytes.
class RecordingReader {
  public:
    /// `bytes` must outlive the reader.
    RecordingReader(std::string_view bytes, std::string_view name);
    RecordingReader(const RecordingBytes& bytes, std::string_view name);

    /// The next record, which the next call overwrites; nullptr at the end.
    const Record* next();

    /// The number of bytes read.
    std::uint64_t bytes_read() const { return blocks_.position(); }
    /// What a user must know about a damaged file, as a sentence; empty if the file is whole.
    std::string damage() const;
    const std::string& name() const { return name_; }

  private:
    bool next_block();
    [[noreturn]] void contradict(const std::string& what) const;

    std::string name_;
    BlockReader blocks_;
    std::vector<std::uint8_t> unpacked_;
    ByteReader block_;
    std::uint64_t block_at_ = 0;
    std::optional<std::uint64_t> damaged_at_;
    bool ended_ = false;
    Record record_;
};

/// Makes the bytes of a file, record after record. Blocks are packed with zlib; the same records
/// give the same bytes with the same zlib.
class RecordingWriter {
  public:
    RecordingWriter();

    void add(const Record& record);
    /// The number of bytes that take() has.
    std::size_t size() const { return bytes_.size(); }
    /// The bytes that are complete since the last call.
    std::string take();
    /// The bytes that take() has not returned. Nothing may be added after it.
    std::string finish();

  private:
    void end_block();

    ByteWriter block_;
    std::string bytes_;
};

}  // namespace scb::scenes
