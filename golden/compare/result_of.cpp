#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/platform/json_reader.h"
#include "golden/compare/result.h"
#include "scb/error.h"

namespace scb::golden {
namespace {

template <typename Read>
auto list_at(const JsonPlace& place, Read read) {
    std::vector<decltype(read(place))> values;
    const std::size_t size = array_size(place, "a list");
    values.reserve(size);
    for (std::size_t i = 0; i < size; ++i) values.push_back(read(element(place, i)));
    return values;
}

/// The result of `read` for a value that may be null.
template <typename Read>
auto optional_at(const JsonPlace& place, Read read) {
    std::optional<decltype(read(place))> value;
    if (!place.value->is_null()) value = read(place);
    return value;
}

template <typename Integer>
Integer integer_at(const JsonPlace& place, std::int64_t low = 0,
                   std::int64_t high = std::numeric_limits<Integer>::max()) {
    return static_cast<Integer>(read_integer(place, low, high));
}

std::int64_t count_at(const JsonPlace& place) {
    return integer_at<std::int64_t>(place, std::numeric_limits<std::int64_t>::min());
}

std::size_t size_at(const JsonPlace& place) {
    return integer_at<std::size_t>(place, 0, std::numeric_limits<std::int64_t>::max());
}

PixelBox box_at(const JsonPlace& place) {
    const auto sides = list_at(place, [](const JsonPlace& side) { return integer_at<int>(side); });
    if (sides.size() != 4) refuse_value(place, "[left, top, right, bottom]");
    return {sides[0], sides[1], sides[2], sides[3]};
}

CountChange count_change_at(const JsonPlace& place) {
    check_fields(place, {"place", "before", "after", "before_text", "after_text", "bound"});
    return {read_text(field(place, "place")),
            optional_at(field(place, "before"), count_at),
            optional_at(field(place, "after"), count_at),
            read_text(field(place, "before_text")),
            read_text(field(place, "after_text")),
            read_text(field(place, "bound"))};
}

IdChange id_change_at(const JsonPlace& place) {
    check_fields(place, {"id", "before", "after", "moved", "box"});
    return {integer_at<std::uint32_t>(field(place, "id")), size_at(field(place, "before")),
            size_at(field(place, "after")), size_at(field(place, "moved")),
            box_at(field(place, "box"))};
}

IdDifference ids_at(const JsonPlace& place) {
    check_fields(place, {"pixels", "box", "changes"});
    return {size_at(field(place, "pixels")), box_at(field(place, "box")),
            list_at(field(place, "changes"), id_change_at)};
}

ImageDifference colors_at(const JsonPlace& place) {
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

ColorTolerance tolerance_at(const JsonPlace& place) {
    check_fields(place, {"max_channel_delta", "max_pixels"});
    return {integer_at<int>(field(place, "max_channel_delta"), 0, 255),
            size_at(field(place, "max_pixels"))};
}

ResultPictures pictures_at(const JsonPlace& place) {
    check_fields(place, {"baseline", "candidate", "difference"});
    return {read_text(field(place, "baseline")), read_text(field(place, "candidate")),
            read_text(field(place, "difference"))};
}

Verdict verdict_at(const JsonPlace& place) {
    const std::optional<Verdict> verdict = verdict_names.find(read_text(place));
    if (!verdict) refuse_value(place, "a verdict");
    return *verdict;
}

CaseResult case_at(const JsonPlace& place) {
    check_fields(
        place,
        {"name",      "verdict", "cause",  "message",          "lines",   "counts",  "ids",
         "owners",    "colors",  "focus",  "tolerance",        "variant", "picture", "id_picture",
         "reproduce", "update",  "traces", "trace_difference", "diff",    "view",    "seconds"});
    CaseResult result;
    result.name = read_text(field(place, "name"));
    result.verdict = verdict_at(field(place, "verdict"));
    result.cause = read_text(field(place, "cause"));
    result.message = read_text(field(place, "message"));
    result.lines = list_at(field(place, "lines"), read_text);
    result.counts = list_at(field(place, "counts"), count_change_at);
    result.ids = optional_at(field(place, "ids"), ids_at);
    result.owners = list_at(field(place, "owners"), read_text);
    result.colors = optional_at(field(place, "colors"), colors_at);
    result.focus = box_at(field(place, "focus"));
    result.tolerance = tolerance_at(field(place, "tolerance"));
    result.variant = integer_at<int>(field(place, "variant"));
    result.picture = pictures_at(field(place, "picture"));
    result.id_picture = pictures_at(field(place, "id_picture"));
    result.reproduce = read_text(field(place, "reproduce"));
    result.update = read_text(field(place, "update"));
    result.traces = list_at(field(place, "traces"), read_text);
    result.trace_difference = read_text(field(place, "trace_difference"));
    result.diff = read_text(field(place, "diff"));
    result.view = read_text(field(place, "view"));
    result.seconds = read_number(field(place, "seconds"), 0, std::numeric_limits<double>::max());
    return result;
}

std::pair<std::string, std::string> version_at(const JsonPlace& place) {
    check_fields(place, {"name", "value"});
    return {read_text(field(place, "name")), read_text(field(place, "value"))};
}

}  // namespace

SuiteResult result_of(const nlohmann::json& document, const std::string& path) {
    const JsonPlace place{&document, path, ""};
    check_fields(place, {"suite", "shard", "incomplete", "environment", "cases"});
    return {read_text(field(place, "suite")), list_at(field(place, "environment"), version_at),
            list_at(field(place, "cases"), case_at), read_text(field(place, "shard")),
            read_text(field(place, "incomplete"))};
}

}  // namespace scb::golden
