#include <algorithm>
#include <initializer_list>
#include <limits>
#include <type_traits>

#include "core/error.h"
#include "golden/result.h"

namespace scb {
namespace {

using nlohmann::json;

/// A value and where it stands, for refusals: "cases[3].verdict" of a file.
struct Place {
    const json& value;
    const std::string& file;
    std::string path;
};

[[noreturn]] void refuse(const Place& place, const std::string& sentence) {
    throw InputError(place.file + ": " + (place.path.empty() ? "" : place.path + ": ") + sentence);
}

[[noreturn]] void refuse_value(const Place& place, const std::string& expected) {
    std::string found = place.value.dump(-1, ' ', true, json::error_handler_t::replace);
    if (found.size() > 60) found = found.substr(0, 57) + "...";
    refuse(place, "expected " + expected + ", found " + found + ".");
}

void check_fields(const Place& place, std::initializer_list<const char*> fields) {
    if (!place.value.is_object()) refuse_value(place, "an object");
    for (const char* field : fields)
        if (!place.value.contains(field))
            refuse(place, std::string("the field \"") + field +
                              "\" is missing; no `scb golden check` wrote this.");
    for (const auto& [key, value] : place.value.items()) {
        const auto is_key = [&key = key](const char* field) { return key == field; };
        if (std::none_of(fields.begin(), fields.end(), is_key))
            refuse(place, "unknown field " +
                              json(key).dump(-1, ' ', true, json::error_handler_t::replace) +
                              "; was it written by another version of scb?");
    }
}

Place field(const Place& object, const char* name) {
    return {object.value.at(name), object.file,
            object.path + (object.path.empty() ? "" : ".") + name};
}

std::string text_at(const Place& place) {
    if (!place.value.is_string()) refuse_value(place, "a text");
    return place.value.get<std::string>();
}

/// A whole number that the type can hold, from `low` on.
template <typename Integer>
Integer integer_at(const Place& place, Integer low = 0,
                   Integer high = std::numeric_limits<Integer>::max()) {
    const json& value = place.value;
    // JSON that was made, not parsed, may hold a number that is not negative with a sign.
    const bool fits =
        value.is_number_unsigned()
            ? value.get<std::uint64_t>() <= static_cast<std::uint64_t>(high)
            : value.is_number_integer() &&
                  (value.get<std::int64_t>() >= 0
                       ? static_cast<std::uint64_t>(value.get<std::int64_t>()) <=
                             static_cast<std::uint64_t>(high)
                       : std::is_signed_v<Integer> &&
                             value.get<std::int64_t>() >= static_cast<std::int64_t>(low));
    if (!fits)
        refuse_value(place,
                     "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return value.get<Integer>();
}

template <typename Read>
auto list_at(const Place& place, Read read) {
    if (!place.value.is_array()) refuse_value(place, "a list");
    std::vector<decltype(read(place))> values;
    values.reserve(place.value.size());
    for (std::size_t i = 0; i < place.value.size(); ++i)
        values.push_back(
            read(Place{place.value[i], place.file, place.path + "[" + std::to_string(i) + "]"}));
    return values;
}

/// What `read` makes of a value that may be null.
template <typename Read>
auto optional_at(const Place& place, Read read) {
    std::optional<decltype(read(place))> value;
    if (!place.value.is_null()) value = read(place);
    return value;
}

std::int64_t count_at(const Place& place) {
    return integer_at<std::int64_t>(place, std::numeric_limits<std::int64_t>::min());
}

std::size_t size_at(const Place& place) { return integer_at<std::size_t>(place); }

PixelBox box_at(const Place& place) {
    const auto sides = list_at(place, [](const Place& side) { return integer_at<int>(side); });
    if (sides.size() != 4) refuse_value(place, "[left, top, right, bottom]");
    return {sides[0], sides[1], sides[2], sides[3]};
}

CountChange count_change_at(const Place& place) {
    check_fields(place, {"place", "before", "after", "before_text", "after_text"});
    return {text_at(field(place, "place")), optional_at(field(place, "before"), count_at),
            optional_at(field(place, "after"), count_at), text_at(field(place, "before_text")),
            text_at(field(place, "after_text"))};
}

IdChange id_change_at(const Place& place) {
    check_fields(place, {"id", "before", "after", "moved", "box"});
    return {integer_at<std::uint32_t>(field(place, "id")), size_at(field(place, "before")),
            size_at(field(place, "after")), size_at(field(place, "moved")),
            box_at(field(place, "box"))};
}

IdDifference ids_at(const Place& place) {
    check_fields(place, {"pixels", "box", "changes"});
    return {size_at(field(place, "pixels")), box_at(field(place, "box")),
            list_at(field(place, "changes"), id_change_at)};
}

ImageDifference colors_at(const Place& place) {
    check_fields(place, {"pixels", "box", "largest", "beyond"});
    ImageDifference colors{size_at(field(place, "pixels")),
                           box_at(field(place, "box")),
                           integer_at<int>(field(place, "largest"), 0, 255),
                           {}};
    const auto beyond = list_at(field(place, "beyond"), size_at);
    if (beyond.size() > colors.beyond.size())
        refuse(field(place, "beyond"),
               "expected at most 256 numbers, found " + std::to_string(beyond.size()) + ".");
    std::copy(beyond.begin(), beyond.end(), colors.beyond.begin());
    return colors;
}

ColorTolerance tolerance_at(const Place& place) {
    check_fields(place, {"max_channel_delta", "max_pixels"});
    return {integer_at<int>(field(place, "max_channel_delta"), 0, 255),
            size_at(field(place, "max_pixels"))};
}

ResultPictures pictures_at(const Place& place) {
    check_fields(place, {"baseline", "candidate", "difference"});
    return {text_at(field(place, "baseline")), text_at(field(place, "candidate")),
            text_at(field(place, "difference"))};
}

Verdict verdict_at(const Place& place) {
    const std::optional<Verdict> verdict = verdict_of(text_at(place));
    if (!verdict) refuse_value(place, "a verdict");
    return *verdict;
}

double seconds_at(const Place& place) {
    if (!place.value.is_number() || !(place.value.get<double>() >= 0))
        refuse_value(place, "a number from 0 on");
    return place.value.get<double>();
}

CaseResult case_at(const Place& place) {
    check_fields(place,
                 {"name", "verdict", "message", "lines", "counts", "ids", "colors", "tolerance",
                  "variant", "picture", "id_picture", "reproduce", "update", "traces", "seconds"});
    CaseResult result;
    result.name = text_at(field(place, "name"));
    result.verdict = verdict_at(field(place, "verdict"));
    result.message = text_at(field(place, "message"));
    result.lines = list_at(field(place, "lines"), text_at);
    result.counts = list_at(field(place, "counts"), count_change_at);
    result.ids = optional_at(field(place, "ids"), ids_at);
    result.colors = optional_at(field(place, "colors"), colors_at);
    result.tolerance = tolerance_at(field(place, "tolerance"));
    result.variant = integer_at<int>(field(place, "variant"));
    result.picture = pictures_at(field(place, "picture"));
    result.id_picture = pictures_at(field(place, "id_picture"));
    result.reproduce = text_at(field(place, "reproduce"));
    result.update = text_at(field(place, "update"));
    result.traces = list_at(field(place, "traces"), text_at);
    result.seconds = seconds_at(field(place, "seconds"));
    return result;
}

std::pair<std::string, std::string> version_at(const Place& place) {
    check_fields(place, {"name", "value"});
    return {text_at(field(place, "name")), text_at(field(place, "value"))};
}

}  // namespace

SuiteResult result_of(const json& document, const std::string& path) {
    const Place place{document, path, ""};
    check_fields(place, {"suite", "shard", "incomplete", "environment", "cases"});
    return {text_at(field(place, "suite")), list_at(field(place, "environment"), version_at),
            list_at(field(place, "cases"), case_at), text_at(field(place, "shard")),
            text_at(field(place, "incomplete"))};
}

}  // namespace scb
