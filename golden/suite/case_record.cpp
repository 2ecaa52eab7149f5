#include "golden/suite/case_record.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "core/platform/json_reader.h"
#include "core/platform/output_file.h"
#include "scb/error.h"
#include "scenes/scene/pose_rows.h"

namespace scb::golden {
namespace {

using Json = nlohmann::json;

constexpr std::int64_t most_elements = std::int64_t{1} << 32;

/// "symmetric", "0.5", "none", "scb, obb"
std::string setting_text(const Json& value) {
    if (value.is_null()) return "none";
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_array()) return value.dump();
    std::string text;
    for (const Json& element : value) text += (text.empty() ? "" : ", ") + setting_text(element);
    return text;
}

/// Twelve numbers as one line.
std::string pose_text(const Json& numbers) {
    std::string text;
    for (const Json& number : numbers) text += (text.empty() ? "" : " ") + number.dump();
    return text;
}

/// The members of an object at a place.
template <typename Take>
void each_member(const JsonPlace& place, Take take) {
    if (!(*place).is_object()) refuse_value(place, "an object");
    for (const auto& member : (*place).items())
        take(member.key(), field(place, member.key().c_str()));
}

/// The number that is the whole of a word, or nothing.
template <typename Number>
std::optional<Number> number_in(std::string_view word) {
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
}

Pose pose_at(const JsonPlace& place) {
    std::istringstream words(read_text(place));
    std::vector<double> numbers;
    for (std::string word; words >> word;)
        if (const auto number = number_in<double>(word); number && std::isfinite(*number))
            numbers.push_back(*number);
        else
            refuse_value(place, "twelve numbers");
    if (numbers.size() != 12) refuse_value(place, "twelve numbers");
    scenes::PoseRows rows{};
    std::copy(numbers.begin(), numbers.end(), rows.begin());
    return scenes::pose_of(rows);
}

RecordedMesh mesh_at(const JsonPlace& body) {
    check_fields(body, {"name", "triangles", "vertices", "hash"});
    return {read_integer(field(body, "triangles"), 0, most_elements),
            read_integer(field(body, "vertices"), 0, most_elements),
            read_text(field(body, "hash"))};
}

}  // namespace

Json record_json(const std::string& command, const Json& document) {
    Json record = {{"command", command}};
    for (const char* key : {"bodies", "versions"})
        if (document.contains(key)) record[key] = document[key];
    if (document.contains("poses"))
        for (const auto& [frame, bodies] : document["poses"].items())
            for (const auto& [body, numbers] : bodies.items())
                record["poses"][frame][body] = pose_text(numbers);
    // For levels, they are among the options.
    for (const RecordedSetting& setting : recorded_settings)
        if (document.contains(setting.key))
            record["settings"][setting.key] = setting_text(document[setting.key]);
        else if (document.contains("options") && document["options"].contains(setting.key))
            record["settings"][setting.key] = setting_text(document["options"][setting.key]);
    return record;
}

CaseRecord read_record(const std::filesystem::path& file) {
    CaseRecord record;
    if (!is_there(file)) return record;
    const Json document = parse_json(read_text_file(file.string()), file.string());
    const JsonPlace all{&document, file.string(), ""};
    if (!document.is_object()) refuse_value(all, "an object");
    if (has(all, "command")) record.command = read_text(field(all, "command"));
    if (has(all, "bodies")) {
        const JsonPlace bodies = field(all, "bodies");
        const std::size_t size = array_size(bodies, "a list of bodies");
        for (std::size_t i = 0; i < size; ++i) {
            const JsonPlace body = element(bodies, i);
            record.meshes[read_text(field(body, "name"))] = mesh_at(body);
        }
    }
    if (has(all, "poses"))
        each_member(field(all, "poses"), [&](const std::string& key, const JsonPlace& at) {
            const std::optional<int> frame = number_in<int>(key);
            if (!frame) refuse(at, "its name is not the number of a frame.");
            each_member(at, [&](const std::string& body, const JsonPlace& pose) {
                record.poses[*frame][body] = pose_at(pose);
            });
        });
    if (has(all, "settings"))
        each_member(field(all, "settings"), [&](const std::string& key, const JsonPlace& value) {
            record.settings[key] = read_text(value);
        });
    return record;
}

}  // namespace scb::golden
