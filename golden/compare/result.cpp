#include "golden/compare/result.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace scb::golden {
namespace {

using Json = nlohmann::ordered_json;

Json integer_json(const std::optional<std::int64_t>& value) {
    return value ? Json(*value) : Json();
}

Json box_json(const PixelBox& box) {
    return Json::array({box.left, box.top, box.right, box.bottom});
}

template <typename Value, typename ToJson>
Json list_json(const std::vector<Value>& values, ToJson to_json) {
    Json list = Json::array();
    for (const Value& value : values) list.push_back(to_json(value));
    return list;
}

Json count_json(const CountChange& change) {
    return {{"place", change.place},
            {"before", integer_json(change.before)},
            {"after", integer_json(change.after)},
            {"before_text", change.before_text},
            {"after_text", change.after_text},
            {"bound", change.bound}};
}

Json id_change_json(const IdChange& change) {
    return {{"id", change.id},
            {"before", change.before},
            {"after", change.after},
            {"moved", change.moved},
            {"box", box_json(change.box)}};
}

Json ids_json(const IdDifference& ids) {
    return {{"pixels", ids.pixels},
            {"box", box_json(ids.box)},
            {"changes", list_json(ids.changes, id_change_json)}};
}

Json colors_json(const ImageDifference& colors) {
    std::size_t size = colors.beyond.size();
    while (size > 0 && colors.beyond[size - 1] == 0) --size;
    Json beyond = Json::array();
    for (std::size_t d = 0; d < size; ++d) beyond.push_back(colors.beyond[d]);
    return {{"pixels", colors.pixels},
            {"box", box_json(colors.box)},
            {"largest", colors.largest},
            {"beyond", beyond}};
}

Json pictures_json(const ResultPictures& pictures) {
    return {{"baseline", pictures.baseline},
            {"candidate", pictures.candidate},
            {"difference", pictures.difference}};
}

Json case_json(const CaseResult& result) {
    return {{"name", result.name},
            {"verdict", verdict_names[result.verdict]},
            {"cause", result.cause},
            {"message", result.message},
            {"lines", result.lines},
            {"counts", list_json(result.counts, count_json)},
            {"ids", result.ids ? ids_json(*result.ids) : Json()},
            {"owners", result.owners},
            {"colors", result.colors ? colors_json(*result.colors) : Json()},
            {"focus", box_json(result.focus)},
            {"tolerance",
             {{"max_channel_delta", result.tolerance.max_channel_delta},
              {"max_pixels", result.tolerance.max_pixels}}},
            {"variant", result.variant},
            {"picture", pictures_json(result.picture)},
            {"id_picture", pictures_json(result.id_picture)},
            {"reproduce", result.reproduce},
            {"update", result.update},
            {"traces", result.traces},
            {"trace_difference", result.trace_difference},
            {"diff", result.diff},
            {"view", result.view},
            {"seconds", result.seconds}};
}

}  // namespace

bool is_of_trace(const CountChange& change) {
    return change.place.find("/" + std::string(tests_by_depth_key) + "/") != std::string::npos;
}

std::string first_words(const CaseResult& result) {
    if (result.cause.empty() || result.message.empty()) return result.cause + result.message;
    return result.cause + " " + result.message;
}

bool is_tolerated(const CaseResult& result) {
    return result.verdict == Verdict::same && result.colors.has_value();
}

std::vector<std::string> files_of(const CaseResult& result) {
    std::vector<std::string> names = result.traces;
    for (const ResultPictures* pictures : {&result.picture, &result.id_picture})
        for (const std::string* name :
             {&pictures->baseline, &pictures->candidate, &pictures->difference})
            if (!name->empty()) names.push_back(*name);
    if (const std::string page = result.view.substr(0, result.view.find('#')); !page.empty())
        names.push_back(page);
    return names;
}

bool has_failed(const SuiteResult& result) {
    return !result.incomplete.empty() ||
           std::any_of(result.cases.begin(), result.cases.end(),
                       [](const CaseResult& c) { return is_failure(c.verdict); });
}

Json result_json(const SuiteResult& result) {
    // A list, since an object would not keep the order of the versions.
    const auto version_json = [](const std::pair<std::string, std::string>& version) {
        return Json{{"name", version.first}, {"value", version.second}};
    };
    return {{"suite", result.suite},
            {"shard", result.shard},
            {"incomplete", result.incomplete},
            {"environment", list_json(result.environment, version_json)},
            {"cases", list_json(result.cases, case_json)}};
}

}  // namespace scb::golden
