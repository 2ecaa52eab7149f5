#include "scenes/recordings/recording_json.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/enum_names.h"
#include "core/base/text_format.h"
#include "core/platform/json_reader.h"
#include "core/platform/utf8.h"
#include "scb/error.h"
#include "scenes/recordings/recording_file.h"

namespace scb::scenes {
namespace {

using Json = nlohmann::ordered_json;

constexpr EnumNames<RecordedKind, recorded_kind_count> kind_names{
    "none", "aabb", "obb", "ball", "capsule", "rss", "kdop", "scb", "scb2", "hull"};

std::string hex_of(std::string_view bytes) {
    std::string text;
    for (const char c : bytes)
        text += format("%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
    return text;
}

std::string hex_of(const std::vector<std::uint8_t>& bytes) {
    return hex_of({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Json text_json(const std::string& text) {
    if (as_utf8(text) == text) return text;
    return {{"hex", hex_of(text)}};
}

Json real_json(double value) {
    if (std::isfinite(value)) return value;
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    const auto bits = std::bit_cast<std::uint64_t>(value);
    if (bits == std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN()))
        return "nan";
    return format("nan:%016llx", static_cast<unsigned long long>(bits));
}

template <class Reals>
Json reals_json(const Reals& reals) {
    Json list = Json::array();
    for (const double value : reals) list.push_back(real_json(value));
    return list;
}

/// The number, or null for record_none.
Json number_json(std::uint32_t number) { return number == record_none ? Json() : Json(number); }

Json volume_json(const RecordedVolume& volume) {
    Json list = reals_json(volume.values);
    list.insert(list.begin(), kind_names[volume.kind]);
    return list;
}

Json event_json(const RecordedEvent& event) {
    switch (static_cast<RecordTag>(event.tag)) {
        case RecordTag::items_apart:
            return {"apart", event.a, event.b};
        case RecordTag::items_meet:
            return {"meet", event.a, event.b};
        case RecordTag::pair:
            return {"pair", event.a, event.b};
        case RecordTag::parent:
            return {"parent", event.a, event.b};
        default:
            return {event.tag, event.a, event.b};
    }
}

struct LineOf {
    Json operator()(const RecordedEvent& r) { return event_json(r); }
    Json operator()(const RecordedSetting& r) {
        return {{"setting", text_json(r.key)}, {"value", text_json(r.value)}};
    }
    Json operator()(const RecordedStage& r) {
        return {{"stage", r.stage}, {"name", text_json(r.name)}};
    }
    Json operator()(const RecordedMesh& r) {
        return {{"mesh", r.mesh},
                {"name", text_json(r.name)},
                {"coordinate_bytes", r.coordinate_bytes},
                {"coordinates", reals_json(r.coordinates)},
                {"indices", r.indices}};
    }
    Json operator()(const RecordedTree& r) {
        return {{"tree", r.tree},
                {"name", text_json(r.name)},
                {"of_mesh", number_json(r.mesh)},
                {"directions", reals_json(r.directions)}};
    }
    Json operator()(const RecordedNode& r) {
        return {{"node", r.node},
                {"in_tree", r.tree},
                {"parent", number_json(r.parent)},
                {"id", r.id},
                {"name", text_json(r.name)},
                {"children", r.children},
                {"items", r.items},
                {"volume", volume_json(r.volume)}};
    }
    Json operator()(const RecordedObject& r) {
        return {{"object", r.object}, {"in_tree", r.tree}, {"volume", volume_json(r.volume)}};
    }
    Json operator()(const RecordedRefit& r) {
        return {{"refit", r.node}, {"in_tree", r.tree}, {"volume", volume_json(r.volume)}};
    }
    Json operator()(const RecordedBody& r) {
        return {{"body", r.body}, {"name", text_json(r.name)}, {"of_tree", r.tree}};
    }
    Json operator()(const RecordedFrame& r) { return {{"frame", r.frame}}; }
    Json operator()(const RecordedPose& r) {
        return {{"pose", r.body}, {"rows", reals_json(r.rows)}};
    }
    Json operator()(const RecordedQuery& r) {
        Json line = {{"query", Json::array({r.body_a, r.body_b})}};
        if (!r.has_label) return line;
        line["name"] = text_json(r.name);
        line["tags"] = Json::array();
        for (const std::string& tag : r.tags) line["tags"].push_back(text_json(tag));
        return line;
    }
    Json operator()(const RecordedQueryEnd& r) {
        const Json complete = r.complete > 1 ? Json(r.complete) : Json(r.complete == 1);
        return {{"complete", complete}, {"nanoseconds", r.nanoseconds}};
    }
    Json operator()(const RecordedEnd&) { return {{"end", true}}; }
    Json operator()(const RecordedLog& r) { return {{"log", text_json(r.text)}}; }
    Json operator()(const RecordedUnknown& r) {
        return {{"unknown", r.tag}, {"hex", hex_of(r.bytes)}};
    }
};

// Reading. A place that is missing reads as 0 or empty.

JsonPlace optional_field(const JsonPlace& object, const char* name) {
    static const nlohmann::json nothing;
    return has(object, name) ? field(object, name)
                             : JsonPlace{&nothing, object.file, object.path + name};
}

std::vector<std::uint8_t> bytes_of_hex(const JsonPlace& place) {
    const std::string text = read_text(place);
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < text.size(); i += 2) {
        std::uint8_t byte = 0;
        const char *const first = text.data() + i, *const last = first + 2;
        if (text.size() - i < 2 || std::from_chars(first, last, byte, 16).ptr != last)
            refuse_value(place, "hexadecimal digits, two for each byte");
        bytes.push_back(byte);
    }
    return bytes;
}

std::string text_at(const JsonPlace& place) {
    if (place.value->is_null()) return {};
    if (!place.value->is_object()) return read_text(place);
    check_fields(place, {"hex"});
    const std::vector<std::uint8_t> bytes = bytes_of_hex(field(place, "hex"));
    return {bytes.begin(), bytes.end()};
}

std::string text_of(const JsonPlace& object, const char* name) {
    return text_at(optional_field(object, name));
}

std::uint32_t number_of(const JsonPlace& place, std::int64_t most = UINT32_MAX) {
    return static_cast<std::uint32_t>(read_integer(place, 0, most));
}

std::uint32_t number_or_none(const JsonPlace& object, const char* name) {
    const JsonPlace place = optional_field(object, name);
    return place.value->is_null() ? record_none : number_of(place);
}

std::uint64_t long_number_of(const JsonPlace& object, const char* name) {
    const JsonPlace place = optional_field(object, name);
    if (place.value->is_null()) return 0;
    if (!place.value->is_number_unsigned()) refuse_value(place, "a whole number of 64 bits");
    return place.value->get<std::uint64_t>();
}

double real_of(const JsonPlace& place) {
    if (place.value->is_number()) return place.value->get<double>();
    const std::string text = place.value->is_string() ? place.value->get<std::string>() : "";
    if (text == "inf") return std::numeric_limits<double>::infinity();
    if (text == "-inf") return -std::numeric_limits<double>::infinity();
    if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
    constexpr std::string_view prefix = "nan:";
    if (text.size() == prefix.size() + 16 && text.starts_with(prefix)) {
        std::uint64_t bits = 0;
        const char* const last = text.data() + text.size();
        const auto read = std::from_chars(text.data() + prefix.size(), last, bits, 16);
        const auto value = std::bit_cast<double>(bits);
        if (read.ptr == last && std::isnan(value)) return value;
    }
    refuse_value(place, "a number, \"inf\", \"-inf\" or \"nan\"");
}

std::vector<double> reals_of(const JsonPlace& object, const char* name) {
    const JsonPlace place = optional_field(object, name);
    std::vector<double> reals;
    if (place.value->is_null()) return reals;
    const std::size_t size = array_size(place, "a list of numbers");
    for (std::size_t i = 0; i < size; ++i) reals.push_back(real_of(element(place, i)));
    return reals;
}

std::vector<std::uint32_t> numbers_of(const JsonPlace& object, const char* name) {
    const JsonPlace place = optional_field(object, name);
    std::vector<std::uint32_t> numbers;
    if (place.value->is_null()) return numbers;
    const std::size_t size = array_size(place, "a list of whole numbers");
    for (std::size_t i = 0; i < size; ++i) numbers.push_back(number_of(element(place, i)));
    return numbers;
}

RecordedVolume volume_of(const JsonPlace& object) {
    const JsonPlace place = optional_field(object, "volume");
    RecordedVolume volume;
    if (place.value->is_null()) return volume;
    const char* expected = "a kind of volume and its numbers: [\"ball\", 0, 0, 0, 1]";
    const std::size_t size = array_size(place, expected);
    if (size == 0) refuse_value(place, expected);
    const auto kind = kind_names.find(read_text(element(place, 0)));
    if (!kind) refuse_value(element(place, 0), "a kind of volume: " + name_list(kind_names.names));
    volume.kind = *kind;
    for (std::size_t i = 1; i < size; ++i) volume.values.push_back(real_of(element(place, i)));
    return volume;
}

void add_events(RecordingWriter& out, const JsonPlace& list) {
    const char* expected = "a test: [stage or \"apart\", \"meet\", \"pair\", \"parent\", a, b]";
    const std::size_t size = array_size(list, "a list of tests");
    for (std::size_t i = 0; i < size; ++i) {
        const JsonPlace place = element(list, i);
        if (array_size(place, expected) != 3) refuse_value(place, expected);
        const JsonPlace what = element(place, 0);
        RecordedEvent event;
        if (what.value->is_string()) {
            const std::string word = read_text(what);
            if (word != "apart" && word != "meet" && word != "pair" && word != "parent")
                refuse_value(place, expected);
            event.tag = static_cast<std::uint8_t>(word == "apart"  ? RecordTag::items_apart
                                                  : word == "meet" ? RecordTag::items_meet
                                                  : word == "pair" ? RecordTag::pair
                                                                   : RecordTag::parent);
        } else {
            event.tag = static_cast<std::uint8_t>(number_of(what, first_long_tag - 1));
        }
        event.a = number_of(element(place, 1));
        event.b = number_of(element(place, 2));
        out.add(event);
    }
}

std::uint8_t complete_of(const JsonPlace& place) {
    if (place.value->is_boolean()) return place.value->get<bool>() ? 1 : 0;
    if (!place.value->is_number_unsigned() || place.value->get<std::uint64_t>() > 255)
        refuse_value(place, "true, false, or the byte of a later version");
    return place.value->get<std::uint8_t>();
}

RecordedQuery query_of(const JsonPlace& line) {
    const JsonPlace bodies = field(line, "query");
    if (array_size(bodies, "two bodies") != 2) refuse_value(bodies, "two bodies");
    RecordedQuery query{number_of(element(bodies, 0)), number_of(element(bodies, 1))};
    query.has_label = has(line, "name") || has(line, "tags");
    query.name = text_of(line, "name");
    if (!has(line, "tags")) return query;
    const JsonPlace tags = field(line, "tags");
    const std::size_t count = array_size(tags, "a list of tags");
    for (std::size_t i = 0; i < count; ++i) query.tags.push_back(text_at(element(tags, i)));
    return query;
}

/// Whether a coordinate fits into 4 bytes. Finite ones are rounded.
bool fits_float(double value) {
    if (std::isinf(value)) return true;
    if (!std::isnan(value)) return std::abs(value) <= std::numeric_limits<float>::max();
    // A NaN keeps its sign and the first 23 bits of its fraction.
    constexpr std::uint64_t beyond = (std::uint64_t{1} << 29) - 1;
    return (std::bit_cast<std::uint64_t>(value) & beyond) == 0;
}

/// Adds the record of a line. The kind follows from a field that only this kind has.
void add_line(RecordingWriter& writer, const JsonPlace& line,
              const std::vector<std::uint8_t>& appended) {
    const auto add = [&](Record record) {
        record.appended = appended;
        writer.add(record);
    };
    const auto name = [&] { return text_of(line, "name"); };
    const auto number = [&](const char* key) { return number_of(field(line, key)); };
    if (has(line, "tests")) {
        check_fields(line, {"tests"});
        if (!appended.empty()) refuse(line, "appended: tests have a fixed size; leave it out.");
        add_events(writer, field(line, "tests"));
    } else if (has(line, "setting")) {
        check_fields(line, {"setting", "value"});
        add(RecordedSetting{text_of(line, "setting"), text_of(line, "value")});
    } else if (has(line, "stage")) {
        check_fields(line, {"stage", "name"});
        add(RecordedStage{static_cast<std::uint8_t>(number_of(field(line, "stage"), 255)), name()});
    } else if (has(line, "mesh")) {
        check_fields(line, {"mesh", "name", "coordinate_bytes", "coordinates", "indices"});
        RecordedMesh r{number("mesh"), name(), 8, reals_of(line, "coordinates"),
                       numbers_of(line, "indices")};
        if (has(line, "coordinate_bytes"))
            r.coordinate_bytes =
                static_cast<std::uint8_t>(number_of(field(line, "coordinate_bytes"), 8));
        if (r.coordinate_bytes != 4 && r.coordinate_bytes != 8)
            refuse_value(field(line, "coordinate_bytes"), "4 or 8");
        for (const double value : r.coordinates)
            if (r.coordinate_bytes == 4 && !fits_float(value))
                refuse(line,
                       "coordinates: one does not fit into 4 bytes; set coordinate_bytes to 8.");
        if (r.coordinates.size() % 3 != 0)
            refuse(line, "coordinates: there are not three of each vertex.");
        if (r.indices.size() % 3 != 0)
            refuse(line, "indices: there are not three of each triangle.");
        add(r);
    } else if (has(line, "tree")) {
        check_fields(line, {"tree", "name", "of_mesh", "directions"});
        RecordedTree r{number("tree"), number_or_none(line, "of_mesh"), name(),
                       reals_of(line, "directions")};
        if (r.directions.size() % 3 != 0)
            refuse(line, "directions: there are not three numbers of each.");
        add(r);
    } else if (has(line, "node")) {
        check_fields(line,
                     {"node", "in_tree", "parent", "id", "name", "children", "items", "volume"});
        add(RecordedNode{number("in_tree"), number("node"), number_or_none(line, "parent"),
                         long_number_of(line, "id"), name(), numbers_of(line, "children"),
                         numbers_of(line, "items"), volume_of(line)});
    } else if (has(line, "object")) {
        check_fields(line, {"object", "in_tree", "volume"});
        add(RecordedObject{number("in_tree"), number("object"), volume_of(line)});
    } else if (has(line, "refit")) {
        check_fields(line, {"refit", "in_tree", "volume"});
        add(RecordedRefit{number("in_tree"), number("refit"), volume_of(line)});
    } else if (has(line, "body")) {
        check_fields(line, {"body", "name", "of_tree"});
        add(RecordedBody{number("body"), number("of_tree"), name()});
    } else if (has(line, "frame")) {
        check_fields(line, {"frame"});
        add(RecordedFrame{number("frame")});
    } else if (has(line, "pose")) {
        check_fields(line, {"pose", "rows"});
        const std::vector<double> rows = reals_of(line, "rows");
        RecordedPose r;
        r.body = number("pose");
        if (rows.size() != r.rows.size())
            refuse(line, "rows: a pose has twelve numbers, the rows of [R|t].");
        std::copy(rows.begin(), rows.end(), r.rows.begin());
        add(r);
    } else if (has(line, "query")) {
        check_fields(line, {"query", "name", "tags"});
        RecordedQuery query = query_of(line);
        query.has_label |= !appended.empty();  // what is appended stands behind name and tags
        add(query);
    } else if (has(line, "complete")) {
        check_fields(line, {"complete", "nanoseconds"});
        add(RecordedQueryEnd{complete_of(field(line, "complete")),
                             long_number_of(line, "nanoseconds")});
    } else if (has(line, "log")) {
        check_fields(line, {"log"});
        add(RecordedLog{text_of(line, "log")});
    } else if (has(line, "end")) {
        check_fields(line, {"end"});
        add(RecordedEnd{});
    } else if (has(line, "unknown")) {
        check_fields(line, {"unknown", "hex"});
        const std::uint32_t tag = number_of(field(line, "unknown"), 255);
        if (tag <= static_cast<std::uint32_t>(RecordTag::log))
            refuse_value(field(line, "unknown"),
                         "a kind of record that this version does not know");
        add(RecordedUnknown{static_cast<std::uint8_t>(tag), bytes_of_hex(field(line, "hex"))});
    } else {
        refuse(line, "this is no record of a recording; scenes/recordings/README.md lists them.");
    }
}

}  // namespace

void RecordingJsonWriter::add(const Record& record) {
    constexpr std::size_t most_tests = 100;
    const auto* event = std::get_if<RecordedEvent>(&record);
    if (!event || test_count_ == most_tests) end_tests();
    if (event) {
        tests_ += (test_count_++ == 0 ? "" : ",") + event_json(*event).dump();
        return;
    }
    Json line = std::visit(LineOf{}, record);
    if (!record.appended.empty()) line["appended"] = hex_of(record.appended);
    text_ += line.dump() + '\n';
}

void RecordingJsonWriter::end_tests() {
    if (test_count_ != 0) text_ += "{\"tests\":[" + tests_ + "]}\n";
    tests_.clear();
    test_count_ = 0;
}

std::string RecordingJsonWriter::finish() {
    end_tests();
    return std::move(text_);
}

std::string recording_as_json(std::string_view bytes, std::string_view name) {
    RecordingReader reader(bytes, name);
    RecordingJsonWriter out;
    while (const Record* record = reader.next()) out.add(*record);
    return out.finish();
}

std::string recording_of_json(std::string_view text, const std::string& name) {
    RecordingWriter out;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t length = text.find('\n');
        const std::string_view line = text.substr(0, length);
        text.remove_prefix(length == std::string_view::npos ? text.size() : length + 1);
        if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
        const std::string place = name + ": line " + std::to_string(number);
        nlohmann::json document = parse_json(line, place);
        const JsonPlace whole{&document, place, ""};
        if (!document.is_object()) refuse_value(whole, "a record as a JSON object");
        std::vector<std::uint8_t> appended;
        if (has(whole, "appended")) appended = bytes_of_hex(field(whole, "appended"));
        document.erase("appended");
        add_line(out, whole, appended);
    }
    return out.finish();
}

}  // namespace scb::scenes
