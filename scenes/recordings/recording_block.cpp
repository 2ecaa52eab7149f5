#include "scenes/recordings/recording_block.h"

#include <algorithm>
#include <string>

#include "core/platform/file_bytes.h"
#include "scb/error.h"
#include "scenes/recordings/trace_block.h"

namespace scb::scenes {
namespace {

constexpr std::size_t kind_size = 4;

}  // namespace

bool starts_as_recording(std::string_view bytes) { return bytes.starts_with(recording_magic); }

bool starts_as_compact(std::string_view bytes) {
    return starts_as_recording(bytes) && bytes.size() >= compact_start &&
           bytes.substr(compact_start - kind_size, kind_size) == head_block;
}

std::span<const std::uint8_t> recording_blocks(std::string_view bytes, std::string_view name) {
    const std::string path(name);
    if (!starts_as_recording(bytes))
        throw InputError(path + " is no recording, which scb_record.h writes; name one (.scbrec).");
    ByteReader in{as_bytes(bytes).subspan(recording_magic.size())};
    const std::uint32_t version = in.fixed32();
    if (!in.ok) throw InputError(path + " is truncated before its version; record it again.");
    if (version > recording_version || version == 0)
        throw InputError(path + " is a recording of version " + std::to_string(version) +
                         "; this scb reads versions up to " + std::to_string(recording_version) +
                         ": update it.");
    return in.bytes;
}

std::optional<RecordingBlock> take_block(ByteReader& in) {
    const std::uint64_t length = in.fixed32();
    const std::span<const std::uint8_t> checked = in.take(kind_size + length);
    const std::uint32_t sum = in.fixed32();
    if (!in.ok || sum != checksum(checked)) return std::nullopt;
    return RecordingBlock{{reinterpret_cast<const char*>(checked.data()), kind_size},
                          checked.subspan(kind_size)};
}

RecordingBytes RecordingBytes::of_file(const std::string& path) {
    check_is_file(path);
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path, error);
    const auto written = std::filesystem::last_write_time(path, error);
    if (error) refuse_to_open(path, error.value());
    return RecordingBytes(OnDisk{path, size, written});
}

std::uint64_t RecordingBytes::size() const {
    if (const auto* file = std::get_if<OnDisk>(&source_)) return file->size;
    return std::get<std::string>(source_).size();
}

BlockReader::BlockReader(std::string_view bytes, std::string_view name)
    : left_(bytes), size_(bytes.size()) {
    skip(bytes.size() - recording_blocks(bytes, name).size());
}

BlockReader::BlockReader(const RecordingBytes& bytes, std::string_view name) : size_(bytes.size()) {
    if (const auto* file = std::get_if<RecordingBytes::OnDisk>(&bytes.source_)) {
        std::error_code error;
        window_.emplace(file->path);
        if (window_->left() != file->size ||
            std::filesystem::last_write_time(file->path, error) != file->written)
            throw InputError(std::string(name) +
                             " changed while it was read; wait until its recorder is done.");
    } else {
        left_ = std::get<std::string>(bytes.source_);
    }
    const std::string_view start = ahead(compact_start);
    skip(start.size() - recording_blocks(start, name).size());
}

std::string_view BlockReader::ahead(std::size_t count) {
    return window_ ? window_->ahead(count) : left_;
}

void BlockReader::skip(std::size_t count) {
    position_ += count;
    if (window_)
        window_->skip(count);
    else
        left_.remove_prefix(count);
}

std::optional<RecordingBlock> BlockReader::next() {
    constexpr std::size_t length_size = 4, sum_size = 4;
    ByteReader start{as_bytes(ahead(length_size))};
    const std::uint64_t length = length_size + kind_size + start.fixed32() + sum_size;
    if (!start.ok || length > size_ - position_) return std::nullopt;
    ByteReader in{as_bytes(left_)};
    if (window_) {
        // A block may be longer than the window.
        block_.clear();
        while (block_.size() < length) {
            const std::string_view part = ahead(1).substr(0, length - block_.size());
            if (part.empty()) return std::nullopt;  // the file became shorter
            const auto bytes = as_bytes(part);
            block_.insert(block_.end(), bytes.begin(), bytes.end());
            skip(part.size());
        }
        in = {block_};
    }
    const std::optional<RecordingBlock> block = take_block(in);
    if (!window_ && block) skip(static_cast<std::size_t>(length));
    return block;
}

void begin_recording(ByteWriter& out) {
    out.append(as_bytes(recording_magic));
    out.fixed32(recording_version);
}

void add_block(ByteWriter& out, std::string_view kind, std::span<const std::uint8_t> content) {
    ByteWriter checked;
    checked.append(as_bytes(kind));
    checked.append(content);
    out.fixed32(static_cast<std::uint32_t>(content.size()));
    out.append(checked.bytes);
    out.fixed32(checksum(checked.bytes));
}

void add_packed_block(ByteWriter& out, std::string_view kind, std::span<const std::uint8_t> plain) {
    ByteWriter content;
    content.fixed32(static_cast<std::uint32_t>(plain.size()));
    content.append(pack(plain));
    add_block(out, kind, content.bytes);
}

std::optional<std::vector<std::uint8_t>> unpacked(const RecordingBlock& block) {
    ByteReader in{block.content};
    const std::uint32_t size = in.fixed32();
    return in.ok ? unpack(in.bytes, size) : std::nullopt;
}

}  // namespace scb::scenes
