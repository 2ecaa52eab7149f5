#include "scenes/recordings/recording_block.h"

#include <string>

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
