#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "golden/compare/result.h"
#include "scb/error.h"
#include "scenes/text/json_reader.h"

namespace scb::golden {
namespace {

template <typename Read>
auto list_at(const scenes::JsonPlace& place, Read read) {
    std::vector<decltype(read(place))> values;
    const std::size_t size = scenes::array_size(place, "a list");
    values.reserve(size);
    for (std::size_t i = 0; i < size; ++i) values.push_back(read(scenes::element(place, i)));
    return values;
}

/// The result of `read` for a value that may be null.
template <typename Read>
auto optional_at(const scenes::JsonPlace& place, Read read) {
    std::optional<decltype(read(place))> value;
    if (!place.value->is_null()) value = read(place);
    return value;
}

template <typename Integer>
Integer integer_at(const scenes::JsonPlace& place, std::int64_t low = 0,
                   std::int64_t high = std::numeric_limits<Integer>::max()) {
    return static_cast<Integer>(scenes::read_integer(place, low, high));
}

std::int64_t count_at(const scenes::JsonPlace& place) {
    return integer_at<std::int64_t>(place, std::numeric_limits<std::int64_t>::min());
}

std::size_t size_at(const scenes::JsonPlace& place) {
    return integer_at<std::size_t>(place, 0, std::numeric_limits<std::int64_t>::max());
}

PixelBox box_at(const scenes::JsonPlace& place) {
    const auto sides =
        list_at(place, [](const scenes::JsonPlace& side) { return integer_at<int>(side); });
    if (sides.size() != 4) scenes::refuse_value(place, "[left, top, right, bottom]");
    return {sides[0], sides[1], sides[2], sides[3]};
}

CountChange count_change_at(const scenes::JsonPlace& place) {
    scenes::check_fields(place, {"place", "before", "after", "before_text", "after_text"});
    return {scenes::read_text(scenes::field(place, "place")),
            optional_at(scenes::field(place, "before"), count_at),
            optional_at(scenes::field(place, "after"), count_at),
            scenes::read_text(scenes::field(place, "before_text")),
            scenes::read_text(scenes::field(place, "after_text"))};
}

IdChange id_change_at(const scenes::JsonPlace& place) {
    scenes::check_fields(place, {"id", "before", "after", "moved", "box"});
    return {integer_at<std::uint32_t>(scenes::field(place, "id")),
            size_at(scenes::field(place, "before")), size_at(scenes::field(place, "after")),
            size_at(scenes::field(place, "moved")), box_at(scenes::field(place, "box"))};
}

IdDifference ids_at(const scenes::JsonPlace& place) {
    scenes::check_fields(place, {"pixels", "box", "changes"});
    return {size_at(scenes::field(place, "pixels")), box_at(scenes::field(place, "box")),
            list_at(scenes::field(place, "changes"), id_change_at)};
}

ImageDifference colors_at(const scenes::JsonPlace& place) {
    scenes::check_fields(place, {"pixels", "box", "largest", "beyond"});
    ImageDifference colors{size_at(scenes::field(place, "pixels")),
                           box_at(scenes::field(place, "box")),
                           integer_at<int>(scenes::field(place, "largest"), 0, 255),
                           {}};
    const auto beyond = list_at(scenes::field(place, "beyond"), size_at);
    if (beyond.size() > colors.beyond.size())
        scenes::refuse(scenes::field(place, "beyond"), "expected at most 256 numbers, found " +
                                                           std::to_string(beyond.size()) + ".");
    std::copy(beyond.begin(), beyond.end(), colors.beyond.begin());
    return colors;
}

ColorTolerance tolerance_at(const scenes::JsonPlace& place) {
    scenes::check_fields(place, {"max_channel_delta", "max_pixels"});
    return {integer_at<int>(scenes::field(place, "max_channel_delta"), 0, 255),
            size_at(scenes::field(place, "max_pixels"))};
}

ResultPictures pictures_at(const scenes::JsonPlace& place) {
    scenes::check_fields(place, {"baseline", "candidate", "difference"});
    return {scenes::read_text(scenes::field(place, "baseline")),
            scenes::read_text(scenes::field(place, "candidate")),
            scenes::read_text(scenes::field(place, "difference"))};
}

Verdict verdict_at(const scenes::JsonPlace& place) {
    const std::optional<Verdict> verdict = verdict_names.find(scenes::read_text(place));
    if (!verdict) scenes::refuse_value(place, "a verdict");
    return *verdict;
}

CaseResult case_at(const scenes::JsonPlace& place) {
    scenes::check_fields(
        place,
        {"name",      "verdict", "cause",  "message",          "lines",   "counts",  "ids",
         "owners",    "colors",  "focus",  "tolerance",        "variant", "picture", "id_picture",
         "reproduce", "update",  "traces", "trace_difference", "diff",    "view",    "seconds"});
    CaseResult result;
    result.name = scenes::read_text(scenes::field(place, "name"));
    result.verdict = verdict_at(scenes::field(place, "verdict"));
    result.cause = scenes::read_text(scenes::field(place, "cause"));
    result.message = scenes::read_text(scenes::field(place, "message"));
    result.lines = list_at(scenes::field(place, "lines"), scenes::read_text);
    result.counts = list_at(scenes::field(place, "counts"), count_change_at);
    result.ids = optional_at(scenes::field(place, "ids"), ids_at);
    result.owners = list_at(scenes::field(place, "owners"), scenes::read_text);
    result.colors = optional_at(scenes::field(place, "colors"), colors_at);
    result.focus = box_at(scenes::field(place, "focus"));
    result.tolerance = tolerance_at(scenes::field(place, "tolerance"));
    result.variant = integer_at<int>(scenes::field(place, "variant"));
    result.picture = pictures_at(scenes::field(place, "picture"));
    result.id_picture = pictures_at(scenes::field(place, "id_picture"));
    result.reproduce = scenes::read_text(scenes::field(place, "reproduce"));
    result.update = scenes::read_text(scenes::field(place, "update"));
    result.traces = list_at(scenes::field(place, "traces"), scenes::read_text);
    result.trace_difference = scenes::read_text(scenes::field(place, "trace_difference"));
    result.diff = scenes::read_text(scenes::field(place, "diff"));
    result.view = scenes::read_text(scenes::field(place, "view"));
    result.seconds =
        scenes::read_number(scenes::field(place, "seconds"), 0, std::numeric_limits<double>::max());
    return result;
}

std::pair<std::string, std::string> version_at(const scenes::JsonPlace& place) {
    scenes::check_fields(place, {"name", "value"});
    return {scenes::read_text(scenes::field(place, "name")),
            scenes::read_text(scenes::field(place, "value"))};
}

}  // namespace

SuiteResult result_of(const nlohmann::json& document, const std::string& path) {
    const scenes::JsonPlace place{&document, path, ""};
    scenes::check_fields(place, {"suite", "shard", "incomplete", "environment", "cases"});
    return {scenes::read_text(scenes::field(place, "suite")),
            list_at(scenes::field(place, "environment"), version_at),
            list_at(scenes::field(place, "cases"), case_at),
            scenes::read_text(scenes::field(place, "shard")),
            scenes::read_text(scenes::field(place, "incomplete"))};
}

}  // namespace scb::golden
