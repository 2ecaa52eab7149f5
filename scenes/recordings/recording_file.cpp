#include "scenes/recordings/recording_file.h"

#include <bit>
#include <cmath>
#include <utility>

#include "scb/error.h"

namespace scb::scenes {
namespace {

/// The size of a block; a longer one is a single record.
constexpr std::size_t block_size = 1 << 20;

std::string read_text(ByteReader& in) {
    const auto taken = in.take(in.fixed32());
    return {taken.begin(), taken.end()};
}

/// `count` if so many elements of this size are left; else 0, and reading fails.
std::size_t counted(ByteReader& in, std::uint64_t count, std::size_t bytes_of_each) {
    if (count <= in.bytes.size() / bytes_of_each) return static_cast<std::size_t>(count);
    in.take(UINT64_MAX);
    return 0;
}

std::vector<std::uint32_t> read_numbers(ByteReader& in, std::uint64_t count) {
    std::vector<std::uint32_t> numbers(counted(in, count, 4));
    for (std::uint32_t& number : numbers) number = in.fixed32();
    return numbers;
}

std::vector<double> read_reals(ByteReader& in, std::uint64_t count) {
    std::vector<double> reals(counted(in, count, 8));
    for (double& real : reals) real = in.real();
    return reals;
}

// A conversion by the processor makes each NaN a quiet one; these functions keep its bits.
constexpr std::uint32_t float_nan = 0x7f800000, float_fraction = 0x007fffff;
constexpr std::uint64_t double_nan = 0x7ff0000000000000;
constexpr int more_fraction_bits = 29;

double widened(std::uint32_t bits) {
    const auto value = std::bit_cast<float>(bits);
    if (!std::isnan(value)) return static_cast<double>(value);
    const std::uint64_t sign = bits >> 31, fraction = bits & float_fraction;
    return std::bit_cast<double>(sign << 63 | double_nan | fraction << more_fraction_bits);
}

std::uint32_t narrowed(double value) {
    if (!std::isnan(value)) return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const auto fraction = static_cast<std::uint32_t>(bits >> more_fraction_bits) & float_fraction;
    constexpr std::uint32_t quiet = 0x00400000;
    return static_cast<std::uint32_t>(bits >> 63) << 31 | float_nan |
           (fraction == 0 ? quiet : fraction);
}

RecordedVolume read_volume(ByteReader& in) {
    RecordedVolume volume;
    const std::uint8_t kind = in.byte();
    if (kind >= recorded_kind_count) in.take(UINT64_MAX);
    volume.kind = static_cast<RecordedKind>(kind);
    volume.values = read_reals(in, in.fixed32());
    return volume;
}

RecordedMesh read_mesh(ByteReader& in) {
    RecordedMesh mesh;
    mesh.mesh = in.fixed32();
    mesh.name = read_text(in);
    mesh.coordinate_bytes = in.byte();
    const std::uint64_t vertices = in.fixed32(), triangles = in.fixed32();
    if (mesh.coordinate_bytes == 4) {
        mesh.coordinates.resize(counted(in, 3 * vertices, 4));
        for (double& c : mesh.coordinates) c = widened(in.fixed32());
    } else if (mesh.coordinate_bytes == 8) {
        mesh.coordinates = read_reals(in, 3 * vertices);
    } else {
        in.take(UINT64_MAX);
    }
    mesh.indices = read_numbers(in, 3 * triangles);
    return mesh;
}

RecordedQuery read_query(ByteReader& in) {
    RecordedQuery query{in.fixed32(), in.fixed32()};
    // Recorders of scb 1.0 wrote no more.
    query.has_label = !in.bytes.empty();
    if (!query.has_label) return query;
    query.name = read_text(in);
    // A tag has at least the bytes of its length.
    const std::size_t tags = counted(in, in.fixed32(), 4);
    for (std::size_t i = 0; i < tags && in.ok; ++i) query.tags.push_back(read_text(in));
    return query;
}

// Initializers in braces run in their order, which is the order of the members and of the file.
Record read_record(RecordTag tag, ByteReader& in) {
    switch (tag) {
        case RecordTag::setting:
            return RecordedSetting{read_text(in), read_text(in)};
        case RecordTag::stage:
            return RecordedStage{in.byte(), read_text(in)};
        case RecordTag::mesh:
            return read_mesh(in);
        case RecordTag::tree:
            return RecordedTree{in.fixed32(), in.fixed32(), read_text(in),
                                read_reals(in, 3 * std::uint64_t{in.fixed32()})};
        case RecordTag::node:
            return RecordedNode{in.fixed32(),
                                in.fixed32(),
                                in.fixed32(),
                                in.fixed64(),
                                read_text(in),
                                read_numbers(in, in.fixed32()),
                                read_numbers(in, in.fixed32()),
                                read_volume(in)};
        case RecordTag::refit:
            return RecordedRefit{in.fixed32(), in.fixed32(), read_volume(in)};
        case RecordTag::object:
            return RecordedObject{in.fixed32(), in.fixed32(), read_volume(in)};
        case RecordTag::body:
            return RecordedBody{in.fixed32(), in.fixed32(), read_text(in)};
        case RecordTag::frame:
            return RecordedFrame{in.fixed32()};
        case RecordTag::pose: {
            RecordedPose r{in.fixed32(), {}};
            for (double& value : r.rows) value = in.real();
            return r;
        }
        case RecordTag::query:
            return read_query(in);
        case RecordTag::query_end:
            return RecordedQueryEnd{in.byte(), in.fixed64()};
        case RecordTag::end:
            return RecordedEnd{};
        case RecordTag::log:
            return RecordedLog{read_text(in)};
        case RecordTag::measure:
            return RecordedMeasure{in.byte(), in.real(), in.real()};
        case RecordTag::answer:
            return RecordedAnswer{in.real(), in.fixed32(), in.fixed32(),
                                  read_reals(in, in.fixed32())};
        default:
            break;
    }
    const auto all = in.take(in.bytes.size());
    return RecordedUnknown{static_cast<std::uint8_t>(tag), {all.begin(), all.end()}};
}

void write_text(ByteWriter& out, const std::string& text) {
    out.fixed32(static_cast<std::uint32_t>(text.size()));
    out.append(as_bytes(text));
}

void write_numbers(ByteWriter& out, const std::vector<std::uint32_t>& numbers) {
    out.fixed32(static_cast<std::uint32_t>(numbers.size()));
    for (const std::uint32_t number : numbers) out.fixed32(number);
}

void write_volume(ByteWriter& out, const RecordedVolume& volume) {
    out.byte(static_cast<std::uint8_t>(volume.kind));
    out.fixed32(static_cast<std::uint32_t>(volume.values.size()));
    for (const double value : volume.values) out.real(value);
}

/// Writes the payload of a record, and returns its tag.
struct WriteRecord {
    ByteWriter& out;

    RecordTag operator()(const RecordedEvent& r) { return static_cast<RecordTag>(r.tag); }
    RecordTag operator()(const RecordedSetting& r) {
        write_text(out, r.key);
        write_text(out, r.value);
        return RecordTag::setting;
    }
    RecordTag operator()(const RecordedStage& r) {
        out.byte(r.stage);
        write_text(out, r.name);
        return RecordTag::stage;
    }
    RecordTag operator()(const RecordedMesh& r) {
        out.fixed32(r.mesh);
        write_text(out, r.name);
        out.byte(r.coordinate_bytes);
        out.fixed32(static_cast<std::uint32_t>(r.coordinates.size() / 3));
        out.fixed32(static_cast<std::uint32_t>(r.indices.size() / 3));
        for (const double c : r.coordinates)
            if (r.coordinate_bytes == 4)
                out.fixed32(narrowed(c));
            else
                out.real(c);
        for (const std::uint32_t index : r.indices) out.fixed32(index);
        return RecordTag::mesh;
    }
    RecordTag operator()(const RecordedTree& r) {
        out.fixed32(r.tree);
        out.fixed32(r.mesh);
        write_text(out, r.name);
        out.fixed32(static_cast<std::uint32_t>(r.directions.size() / 3));
        for (const double value : r.directions) out.real(value);
        return RecordTag::tree;
    }
    RecordTag operator()(const RecordedNode& r) {
        out.fixed32(r.tree);
        out.fixed32(r.node);
        out.fixed32(r.parent);
        out.fixed64(r.id);
        write_text(out, r.name);
        write_numbers(out, r.children);
        write_numbers(out, r.items);
        write_volume(out, r.volume);
        return RecordTag::node;
    }
    RecordTag operator()(const RecordedRefit& r) {
        out.fixed32(r.tree);
        out.fixed32(r.node);
        write_volume(out, r.volume);
        return RecordTag::refit;
    }
    RecordTag operator()(const RecordedObject& r) {
        out.fixed32(r.tree);
        out.fixed32(r.object);
        write_volume(out, r.volume);
        return RecordTag::object;
    }
    RecordTag operator()(const RecordedBody& r) {
        out.fixed32(r.body);
        out.fixed32(r.tree);
        write_text(out, r.name);
        return RecordTag::body;
    }
    RecordTag operator()(const RecordedFrame& r) {
        out.fixed32(r.frame);
        return RecordTag::frame;
    }
    RecordTag operator()(const RecordedPose& r) {
        out.fixed32(r.body);
        for (const double value : r.rows) out.real(value);
        return RecordTag::pose;
    }
    RecordTag operator()(const RecordedQuery& r) {
        out.fixed32(r.body_a);
        out.fixed32(r.body_b);
        if (!r.has_label) return RecordTag::query;
        write_text(out, r.name);
        out.fixed32(static_cast<std::uint32_t>(r.tags.size()));
        for (const std::string& tag : r.tags) write_text(out, tag);
        return RecordTag::query;
    }
    RecordTag operator()(const RecordedQueryEnd& r) {
        out.byte(r.complete);
        out.fixed64(r.nanoseconds);
        return RecordTag::query_end;
    }
    RecordTag operator()(const RecordedEnd&) { return RecordTag::end; }
    RecordTag operator()(const RecordedLog& r) {
        write_text(out, r.text);
        return RecordTag::log;
    }
    RecordTag operator()(const RecordedMeasure& r) {
        out.byte(r.aim);
        out.real(r.limit);
        out.real(r.relative_error);
        return RecordTag::measure;
    }
    RecordTag operator()(const RecordedAnswer& r) {
        out.real(r.distance);
        out.fixed32(r.item_a);
        out.fixed32(r.item_b);
        out.fixed32(static_cast<std::uint32_t>(r.points.size()));
        for (const double value : r.points) out.real(value);
        return RecordTag::answer;
    }
    RecordTag operator()(const RecordedUnknown& r) {
        out.append(r.bytes);
        return static_cast<RecordTag>(r.tag);
    }
};

}  // namespace

std::vector<std::uint8_t> record_payload(const Record& record) {
    ByteWriter payload;
    std::visit(WriteRecord{payload}, record);
    payload.append(record.appended);
    return payload.bytes;
}

RecordingReader::RecordingReader(std::string_view bytes, std::string_view name)
    : name_(name), blocks_(bytes, name) {}
RecordingReader::RecordingReader(const RecordingBytes& bytes, std::string_view name)
    : name_(name), blocks_(bytes, name) {}

void RecordingReader::contradict(const std::string& what) const {
    throw InputError(name_ + ": " + what + " in the block at byte " + std::to_string(block_at_) +
                     "; its recorder did not write what scb_record.h does.");
}

bool RecordingReader::next_block() {
    while (!blocks_.is_at_end() && !damaged_at_) {
        block_at_ = blocks_.position();
        const std::optional<RecordingBlock> block = blocks_.next();
        if (!block) {
            damaged_at_ = block_at_;
            return false;
        }
        if (block->kind == head_block)
            throw InputError(name_ +
                             " is compact: it has this program's own queries, without the meshes "
                             "and hierarchies; record it again with `scb trace --records`.");
        if (block->kind == packed_block) {
            auto plain = unpacked(*block);
            if (!plain) contradict("no data can be unpacked");
            unpacked_ = std::move(*plain);
            block_ = {unpacked_};
        } else if (block->kind == data_block) {
            block_ = {block->content};
        } else {
            continue;  // of a newer version, which may be skipped
        }
        if (!block_.bytes.empty()) return true;
    }
    return false;
}

const Record* RecordingReader::next() {
    if (block_.bytes.empty() && !next_block()) return nullptr;
    const std::uint8_t tag = block_.byte();
    if (tag < first_long_tag) {
        RecordedEvent event{tag, 0, 0};
        event.a = block_.fixed32();
        event.b = block_.fixed32();
        record_ = event;
        if (!block_.ok) contradict("a test is cut off");
        return &record_;
    }
    ByteReader payload{block_.take(block_.fixed32())};
    if (!block_.ok) contradict("a record is cut off");
    record_ = read_record(static_cast<RecordTag>(tag), payload);
    if (!payload.ok) contradict("a record of kind " + std::to_string(tag) + " makes no sense");
    record_.appended.assign(payload.bytes.begin(), payload.bytes.end());
    ended_ = std::holds_alternative<RecordedEnd>(record_);
    return &record_;
}

std::string RecordingReader::damage() const {
    if (damaged_at_)
        return name_ + " is damaged or cut off at byte " + std::to_string(*damaged_at_) + " of " +
               std::to_string(blocks_.size()) + "; what stands before was read.";
    if (blocks_.is_at_end() && block_.bytes.empty() && !ended_)
        return name_ +
               " ends without the record that scb_record_close writes; all whole blocks were read.";
    return {};
}

RecordingWriter::RecordingWriter() {
    ByteWriter out;
    begin_recording(out);
    bytes_.assign(out.bytes.begin(), out.bytes.end());
}

void RecordingWriter::add(const Record& record) {
    ByteWriter payload;
    const auto tag = static_cast<std::uint8_t>(std::visit(WriteRecord{payload}, record));
    payload.append(record.appended);
    if (payload.bytes.size() > UINT32_MAX - 64)
        throw InputError("a record of " + std::to_string(payload.bytes.size()) +
                         " bytes is more than a recording holds; record a smaller mesh.");
    if (!block_.bytes.empty() && block_.bytes.size() + payload.bytes.size() > block_size)
        end_block();
    block_.byte(tag);
    if (const auto* event = std::get_if<RecordedEvent>(&record)) {
        block_.fixed32(event->a);
        block_.fixed32(event->b);
        return;
    }
    block_.fixed32(static_cast<std::uint32_t>(payload.bytes.size()));
    block_.append(payload.bytes);
}

void RecordingWriter::end_block() {
    ByteWriter out;
    add_packed_block(out, packed_block, block_.bytes);
    bytes_.append(out.bytes.begin(), out.bytes.end());
    block_.bytes.clear();
}

std::string RecordingWriter::take() { return std::exchange(bytes_, {}); }

std::string RecordingWriter::finish() {
    if (!block_.bytes.empty()) end_block();
    return take();
}

}  // namespace scb::scenes
