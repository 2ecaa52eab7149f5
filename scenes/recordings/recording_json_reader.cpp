#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/text_format.h"
#include "core/platform/json_reader.h"
#include "scenes/recordings/recording_file.h"
#include "scenes/recordings/recording_json.h"

namespace scb::scenes {
namespace {

// A place that is missing reads as 0 or empty.

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

std::string required_text(const JsonPlace& place) {
    if (!place.value->is_object()) return read_text(place);
    check_fields(place, {"hex"});
    const std::vector<std::uint8_t> bytes = bytes_of_hex(field(place, "hex"));
    return {bytes.begin(), bytes.end()};
}

std::string text_of(const JsonPlace& object, const char* name) {
    const JsonPlace place = optional_field(object, name);
    return place.value->is_null() ? std::string() : required_text(place);
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
    const auto kind = recorded_kind_names.find(read_text(element(place, 0)));
    if (!kind)
        refuse_value(element(place, 0),
                     "a kind of volume: " + name_list(recorded_kind_names.names));
    volume.kind = *kind;
    for (std::size_t i = 1; i < size; ++i) volume.values.push_back(real_of(element(place, i)));
    return volume;
}

void add_events(RecordingWriter& out, const JsonPlace& list) {
    const char* expected =
        "a test: [stage or \"apart\", \"meet\", \"pair\", \"parent\", a, b], or [\"length\", a "
        "number]";
    const std::size_t size = array_size(list, "a list of tests");
    for (std::size_t i = 0; i < size; ++i) {
        const JsonPlace place = element(list, i);
        const std::size_t fields = array_size(place, expected);
        if (fields != 2 && fields != 3) refuse_value(place, expected);
        const JsonPlace what = element(place, 0);
        if (fields == 2) {
            if (!what.value->is_string() || read_text(what) != "length")
                refuse_value(place, expected);
            out.add(recorded_length(real_of(element(place, 1))));
            continue;
        }
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

Record query_of(const JsonPlace& line) {
    check_fields(line, {"query", "name", "tags"});
    const JsonPlace bodies = field(line, "query");
    if (array_size(bodies, "two bodies") != 2) refuse_value(bodies, "two bodies");
    RecordedQuery query{number_of(element(bodies, 0)), number_of(element(bodies, 1))};
    query.has_label = has(line, "name") || has(line, "tags");
    query.name = text_of(line, "name");
    if (!has(line, "tags")) return query;
    const JsonPlace tags = field(line, "tags");
    const std::size_t count = array_size(tags, "a list of tags");
    for (std::size_t i = 0; i < count; ++i) query.tags.push_back(required_text(element(tags, i)));
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

std::uint32_t number_of(const JsonPlace& line, const char* name) {
    return number_of(field(line, name));
}

Record mesh_of(const JsonPlace& line) {
    check_fields(line, {"mesh", "name", "coordinate_bytes", "coordinates", "indices"});
    RecordedMesh r{number_of(line, "mesh"), text_of(line, "name"), 8, reals_of(line, "coordinates"),
                   numbers_of(line, "indices")};
    if (has(line, "coordinate_bytes"))
        r.coordinate_bytes =
            static_cast<std::uint8_t>(number_of(field(line, "coordinate_bytes"), 8));
    if (r.coordinate_bytes != 4 && r.coordinate_bytes != 8)
        refuse_value(field(line, "coordinate_bytes"), "4 or 8");
    for (const double value : r.coordinates)
        if (r.coordinate_bytes == 4 && !fits_float(value))
            refuse(line, "coordinates: one does not fit into 4 bytes; set coordinate_bytes to 8.");
    if (r.coordinates.size() % 3 != 0)
        refuse(line, "coordinates: there are not three of each vertex.");
    if (r.indices.size() % 3 != 0) refuse(line, "indices: there are not three of each triangle.");
    return r;
}

Record tree_of(const JsonPlace& line) {
    check_fields(line, {"tree", "name", "of_mesh", "directions"});
    RecordedTree r{number_of(line, "tree"), number_or_none(line, "of_mesh"), text_of(line, "name"),
                   reals_of(line, "directions")};
    if (r.directions.size() % 3 != 0)
        refuse(line, "directions: there are not three numbers of each.");
    return r;
}

Record node_of(const JsonPlace& line) {
    check_fields(line, {"node", "in_tree", "parent", "id", "name", "children", "items", "volume"});
    return RecordedNode{number_of(line, "in_tree"),     number_of(line, "node"),
                        number_or_none(line, "parent"), long_number_of(line, "id"),
                        text_of(line, "name"),          numbers_of(line, "children"),
                        numbers_of(line, "items"),      volume_of(line)};
}

Record pose_of_body(const JsonPlace& line) {
    check_fields(line, {"pose", "rows"});
    const std::vector<double> rows = reals_of(line, "rows");
    RecordedPose r{number_of(line, "pose"), {}};
    if (rows.size() != r.rows.size())
        refuse(line, "rows: a pose has twelve numbers, the rows of [R|t].");
    std::copy(rows.begin(), rows.end(), r.rows.begin());
    return r;
}

Record measure_of(const JsonPlace& line) {
    check_fields(line, {"measure", "limit", "relative_error"});
    const JsonPlace place = field(line, "measure");
    RecordedMeasure r;
    if (place.value->is_string()) {
        const auto aim = recorded_aim_names.find(read_text(place));
        if (!aim) refuse_value(place, name_list(recorded_aim_names.names));
        r.aim = static_cast<std::uint8_t>(*aim);
    } else {
        r.aim = static_cast<std::uint8_t>(number_of(place, 255));
    }
    if (has(line, "limit")) r.limit = real_of(field(line, "limit"));
    if (has(line, "relative_error")) r.relative_error = real_of(field(line, "relative_error"));
    return r;
}

Record answer_of(const JsonPlace& line) {
    check_fields(line, {"distance", "items", "points"});
    RecordedAnswer r{real_of(field(line, "distance")), record_none, record_none,
                     reals_of(line, "points")};
    if (!has(line, "items")) return r;
    const JsonPlace items = field(line, "items");
    if (array_size(items, "two items") != 2) refuse_value(items, "two items");
    const auto item = [&items](std::size_t i) {
        const JsonPlace place = element(items, i);
        return place.value->is_null() ? record_none : number_of(place);
    };
    r.item_a = item(0);
    r.item_b = item(1);
    return r;
}

Record unknown_of(const JsonPlace& line) {
    check_fields(line, {"unknown", "hex"});
    const std::uint32_t tag = number_of(field(line, "unknown"), 255);
    if (tag <= static_cast<std::uint32_t>(RecordTag::answer))
        refuse_value(field(line, "unknown"), "a kind of record that this version does not know");
    return RecordedUnknown{static_cast<std::uint8_t>(tag), bytes_of_hex(field(line, "hex"))};
}

/// A kind of line: the field that only this kind has, and its record.
struct LineKind {
    const char* key;
    Record (*read)(const JsonPlace& line);
};

constexpr LineKind line_kinds[] = {
    {"setting",
     [](const JsonPlace& line) -> Record {
         check_fields(line, {"setting", "value"});
         return RecordedSetting{text_of(line, "setting"), text_of(line, "value")};
     }},
    {"stage",
     [](const JsonPlace& line) -> Record {
         check_fields(line, {"stage", "name"});
         return RecordedStage{static_cast<std::uint8_t>(number_of(field(line, "stage"), 255)),
                              text_of(line, "name")};
     }},
    {"mesh", mesh_of},
    {"tree", tree_of},
    {"node", node_of},
    {"object",
     [](const JsonPlace& line) -> Record {
         check_fields(line, {"object", "in_tree", "volume"});
         return RecordedObject{number_of(line, "in_tree"), number_of(line, "object"),
                               volume_of(line)};
     }},
    {"refit",
     [](const JsonPlace& line) -> Record {
         check_fields(line, {"refit", "in_tree", "volume"});
         return RecordedRefit{number_of(line, "in_tree"), number_of(line, "refit"),
                              volume_of(line)};
     }},
    {"body",
     [](const JsonPlace& line) -> Record {
         check_fields(line, {"body", "name", "of_tree"});
         return RecordedBody{number_of(line, "body"), number_of(line, "of_tree"),
                             text_of(line, "name")};
     }},
    {"frame",
     [](const JsonPlace& line) -> Record {
         check_fields(line, {"frame"});
         return RecordedFrame{number_of(line, "frame")};
     }},
    {"pose", pose_of_body},
    {"query", query_of},
    {"complete",
     [](const JsonPlace& line) -> Record {
         check_fields(line, {"complete", "nanoseconds"});
         return RecordedQueryEnd{complete_of(field(line, "complete")),
                                 long_number_of(line, "nanoseconds")};
     }},
    {"log",
     [](const JsonPlace& line) -> Record {
         check_fields(line, {"log"});
         return RecordedLog{text_of(line, "log")};
     }},
    {"measure", measure_of},
    {"distance", answer_of},
    {"end",
     [](const JsonPlace& line) -> Record {
         check_fields(line, {"end"});
         return RecordedEnd{};
     }},
    {"unknown", unknown_of},
};

/// Adds the record of a line.
void add_line(RecordingWriter& writer, const JsonPlace& line,
              const std::vector<std::uint8_t>& appended) {
    if (has(line, "tests")) {
        check_fields(line, {"tests"});
        if (!appended.empty()) refuse(line, "appended: tests have a fixed size; leave it out.");
        return add_events(writer, field(line, "tests"));
    }
    const auto* const kind =
        std::find_if(std::begin(line_kinds), std::end(line_kinds),
                     [&line](const LineKind& each) { return has(line, each.key); });
    if (kind == std::end(line_kinds))
        refuse(line, "this is no record of a recording; scenes/recordings/README.md lists them.");
    Record record = kind->read(line);
    record.appended = appended;
    // What is appended to a query stands behind its name and tags.
    if (auto* query = std::get_if<RecordedQuery>(&record)) query->has_label |= !appended.empty();
    writer.add(record);
}

}  // namespace

std::string recording_of_json(std::string_view text, const std::string& name) {
    std::istringstream lines{std::string(text)};
    return recording_of_json(lines, name);
}

std::string recording_of_json(std::istream& text, const std::string& name) {
    RecordingWriter out;
    std::string line;
    for (std::size_t number = 1; std::getline(text, line); ++number) {
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
