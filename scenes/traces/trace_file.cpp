#include "scenes/traces/trace_file.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "scb/error.h"
#include "scenes/scene/scene.h"
#include "scenes/traces/byte_stream.h"
#include "scenes/traces/trace_block.h"

namespace scb::scenes {
namespace {

// Begins with a byte that no text has, and ends with a line end that a transfer as text would
// change.
constexpr std::array<std::uint8_t, 8> magic = {0x89, 's', 'c', 'b', 't', 'r', '\r', '\n'};

[[noreturn]] void refuse_truncated(const std::string& name) {
    throw InputError(name + " is truncated; record or copy the trace again.");
}

}  // namespace

bool starts_as_trace(std::span<const std::uint8_t> bytes) {
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

TraceWriter::TraceWriter(const TraceHeader& header) : header_(header) {
    ByteWriter out;
    out.append(magic);
    out.fixed32(trace_version);
    const std::vector<std::uint8_t> asked = header_bytes(header);
    out.varint(asked.size());
    out.append(asked);
    bytes_ = std::move(out.bytes);
}

void TraceWriter::add(const TraceFrame& frame) {
    assert(frame.frame >= 0 && frame.frame < most_frames && "no scene has such a frame");
    if (frame.steps.volumes.size() > std::size_t{1} << 31)
        throw InputError("frame " + std::to_string(frame.frame) +
                         " has more than 2^31 tests, which a trace cannot hold; choose a level to "
                         "stop at.");
    const std::vector<std::uint8_t> plain = frame_bytes(header_, frame, nodes_);
    const std::vector<std::uint8_t> packed = pack(plain);
    ByteWriter out{std::move(bytes_)};
    out.varint(packed.size());
    out.varint(plain.size());
    out.append(packed);
    bytes_ = std::move(out.bytes);
}

std::vector<std::uint8_t> TraceWriter::finish() {
    ByteWriter out{std::move(bytes_)};
    out.varint(0);
    out.fixed32(checksum(out.bytes));
    return std::move(out.bytes);
}

TraceReader::TraceReader(std::span<const std::uint8_t> bytes, std::string_view name) : name_(name) {
    const std::size_t start = std::min(bytes.size(), magic.size());
    if (start == 0 || !std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(start),
                                  magic.begin()))
        throw InputError(name_ + " is not a trace of scb; give a file that `scb trace` wrote.");
    ByteReader in{bytes};
    in.take(magic.size());
    const std::uint32_t version = in.fixed32();
    if (!in.ok) refuse_truncated(name_);
    if (version > trace_version)
        throw InputError(name_ + " was written by a newer scb (version " + std::to_string(version) +
                         "; this one reads up to " + std::to_string(trace_version) +
                         "); use that scb, or record the trace again.");
    const auto asked = in.take(in.varint());
    // Check the lengths first, so that a truncated file is not called damaged.
    blocks_ = in.bytes;
    while (in.ok) {
        const std::uint64_t packed = in.varint();
        if (packed == 0) break;
        in.varint();
        in.take(packed);
    }
    blocks_ = blocks_.first(blocks_.size() - in.bytes.size());
    const std::size_t checked = bytes.size() - in.bytes.size();
    const std::uint32_t sum = in.fixed32();
    if (!in.ok) refuse_truncated(name_);
    if (!in.bytes.empty())
        throw InputError(name_ + " has " + std::to_string(in.bytes.size()) +
                         " bytes after its end; record or copy the trace again.");
    if (sum != checksum(bytes.first(checked)))
        throw InputError(name_ +
                         " does not fit its checksum: it was damaged; record or copy the trace "
                         "again.");
    std::optional<TraceHeader> header = header_of(asked);
    if (version == 0 || !header) contradict("its header cannot be read");
    header_ = std::move(*header);
}

void TraceReader::contradict(const std::string& what) const {
    throw InputError(name_ + " is not a valid trace: " + what + "; record it again.");
}

const TraceFrame* TraceReader::next() {
    ByteReader in{blocks_};
    const std::uint64_t packed_size = in.varint();
    if (packed_size == 0) return nullptr;
    const std::uint64_t plain_size = in.varint();
    const auto packed = in.take(packed_size);
    const auto plain = unpack(packed, static_cast<std::size_t>(plain_size));
    if (!plain) contradict("a block cannot be unpacked");
    const std::string failure = read_frame(header_, *plain, nodes_, frame_);
    if (!failure.empty()) contradict(failure);
    if (frame_.frame <= last_frame_) contradict("its frames are out of order");
    last_frame_ = frame_.frame;
    blocks_ = in.bytes;
    return &frame_;
}

std::vector<std::uint8_t> encode_trace(const Trace& trace) {
    TraceWriter writer(trace.header);
    for (const TraceFrame& frame : trace.frames) writer.add(frame);
    return writer.finish();
}

Trace decode_trace(std::span<const std::uint8_t> bytes, std::string_view name) {
    TraceReader reader(bytes, name);
    Trace trace{reader.header(), {}};
    while (const TraceFrame* frame = reader.next()) trace.frames.push_back(*frame);
    return trace;
}

}  // namespace scb::scenes
