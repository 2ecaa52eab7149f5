#include "scenes/recordings/trace_file.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "scb/error.h"
#include "scenes/recordings/byte_stream.h"
#include "scenes/recordings/record.h"
#include "scenes/recordings/recording_block.h"
#include "scenes/recordings/trace_block.h"
#include "scenes/scene/scene.h"

namespace scb::scenes {
namespace {

// The trace files of scb 1.0.
constexpr std::string_view magic_1_0 = "\x89scbtr\r\n";
constexpr std::uint32_t version_1_0 = 1;

std::string_view as_text(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The record that ends a recording.
constexpr std::array<std::uint8_t, 5> end_record = {static_cast<std::uint8_t>(RecordTag::end)};

constexpr std::size_t most_of_a_frame = std::size_t{1} << 31;

[[noreturn]] void refuse_large(int frame, const std::string& what) {
    throw InputError("frame " + std::to_string(frame) + " has more than 2^31 " + what +
                     ", which a trace cannot hold; choose a level to stop at.");
}

}  // namespace

bool starts_as_trace(std::span<const std::uint8_t> bytes) {
    return starts_as_compact(as_text(bytes)) || as_text(bytes).starts_with(magic_1_0);
}

TraceWriter::TraceWriter(const TraceHeader& header) : header_(header) {
    begin_recording(out_);
    add_block(out_, head_block, header_bytes(header));
}

void TraceWriter::add(const QueryTrace& frame) {
    assert(frame.frame >= 0 && frame.frame < most_frames && "no scene has such a frame");
    if (frame.steps.volumes.size() > most_of_a_frame) refuse_large(frame.frame, "tests");
    const std::vector<std::uint8_t> plain = frame_bytes(header_, frame, nodes_);
    if (plain.size() > most_of_a_frame) refuse_large(frame.frame, "bytes");
    add_packed_block(out_, step_block, plain);
}

std::vector<std::uint8_t> TraceWriter::finish() {
    add_block(out_, data_block, end_record);
    return std::move(out_.bytes);
}

TraceReader::TraceReader(std::span<const std::uint8_t> bytes, std::string_view name) : name_(name) {
    const std::string_view start = as_text(bytes).substr(0, magic_1_0.size());
    const bool is_compact = recording_magic.starts_with(start);
    if (start.empty() || (!is_compact && !magic_1_0.starts_with(start)))
        throw InputError(name_ + " is not a trace of scb; give a file that `scb trace` wrote.");
    if (start.size() < magic_1_0.size()) refuse_truncated();
    std::optional<TraceHeader> header =
        header_of(is_compact ? read_compact(as_text(bytes)) : read_version_1_0(bytes));
    if (!header) contradict("its header cannot be read");
    header_ = std::move(*header);
}

std::span<const std::uint8_t> TraceReader::read_compact(std::string_view bytes) {
    ByteReader in{recording_blocks(bytes, name_)};
    const auto next_block = [&] {
        const std::optional<RecordingBlock> block = take_block(in);
        if (!in.ok) refuse_truncated();
        if (!block) refuse_damaged();
        return *block;
    };
    const RecordingBlock head = next_block();
    if (head.kind != head_block)
        throw InputError(name_ + " is not a trace of scb, but a recording of another engine.");
    RecordingBlock block = next_block();
    for (; block.kind != data_block; block = next_block()) {
        if (block.kind != step_block) continue;
        ByteReader frame{block.content};
        const std::uint32_t plain_size = frame.fixed32();
        frames_.push_back({frame.bytes, plain_size});
    }
    if (!std::equal(block.content.begin(), block.content.end(), end_record.begin(),
                    end_record.end()))
        contradict("it has data besides its queries");
    if (!in.bytes.empty()) refuse_longer(in.bytes.size());
    return head.content;
}

std::span<const std::uint8_t> TraceReader::read_version_1_0(std::span<const std::uint8_t> bytes) {
    ByteReader in{bytes.subspan(magic_1_0.size())};
    const std::uint32_t version = in.fixed32();
    if (!in.ok) refuse_truncated();
    if (version > version_1_0)
        throw InputError(name_ + " is a trace of version " + std::to_string(version) +
                         ", and scb reads version " + std::to_string(version_1_0) +
                         " of such files; record the trace again.");
    const auto header = in.take(in.varint());
    // Check the lengths first, so that a truncated file is not called damaged.
    while (in.ok) {
        const std::uint64_t packed = in.varint();
        if (packed == 0) break;
        const std::uint64_t plain = in.varint();
        frames_.push_back({in.take(packed), plain});
    }
    const std::size_t checked = bytes.size() - in.bytes.size();
    const std::uint32_t sum = in.fixed32();
    if (!in.ok) refuse_truncated();
    if (!in.bytes.empty()) refuse_longer(in.bytes.size());
    if (sum != checksum(bytes.first(checked))) refuse_damaged();
    if (version == 0) contradict("its header cannot be read");
    return header;
}

void TraceReader::refuse_truncated() const {
    throw InputError(name_ + " is truncated; record or copy the trace again.");
}

void TraceReader::refuse_damaged() const {
    throw InputError(name_ +
                     " does not fit its checksum: it was damaged; record or copy the trace again.");
}

void TraceReader::refuse_longer(std::size_t bytes) const {
    throw InputError(name_ + " has " + std::to_string(bytes) +
                     " bytes after its end; record or copy the trace again.");
}

void TraceReader::contradict(const std::string& what) const {
    throw InputError(name_ + " is not a valid trace: " + what + "; record it again.");
}

const QueryTrace* TraceReader::next() {
    if (next_ == frames_.size()) return nullptr;
    const PackedFrame& next = frames_[next_];
    const auto plain = unpack(next.packed, static_cast<std::size_t>(next.plain_size));
    if (!plain) contradict("a block cannot be unpacked");
    const std::string failure = read_frame(header_, *plain, nodes_, frame_);
    if (!failure.empty()) contradict(failure);
    if (frame_.frame <= last_frame_) contradict("its frames are out of order");
    last_frame_ = frame_.frame;
    ++next_;
    return &frame_;
}

std::vector<std::uint8_t> encode_trace(const Trace& trace) {
    TraceWriter writer(trace.header);
    for (const QueryTrace& frame : trace.frames) writer.add(frame);
    return writer.finish();
}

Trace decode_trace(std::span<const std::uint8_t> bytes, std::string_view name) {
    TraceReader reader(bytes, name);
    Trace trace{reader.header(), {}};
    while (const QueryTrace* frame = reader.next()) trace.frames.push_back(*frame);
    return trace;
}

}  // namespace scb::scenes
