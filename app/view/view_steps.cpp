#include "app/view/view_steps.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <utility>

#include "app/explain/explain_report.h"

namespace scb::app {

using Json = nlohmann::ordered_json;

std::vector<std::uint32_t> explained_tests(const TraversalTree& tree,
                                           std::span<const std::uint32_t> first, std::size_t most) {
    const std::vector<std::uint32_t> sizes = subtree_sizes(tree);
    std::vector<std::uint32_t> others(sizes.size());
    std::iota(others.begin(), others.end(), 0);
    std::partial_sort(others.begin(),
                      others.begin() + static_cast<std::ptrdiff_t>(std::min(most, others.size())),
                      others.end(), [&sizes](std::uint32_t x, std::uint32_t y) {
                          return sizes[x] != sizes[y] ? sizes[x] > sizes[y] : x < y;
                      });
    std::set<std::uint32_t> chosen;
    for (const std::span<const std::uint32_t> tests : {first, std::span(std::as_const(others))})
        for (const std::uint32_t test : tests)
            if (chosen.size() < most) chosen.insert(test);
    return {chosen.begin(), chosen.end()};
}

Json view_steps_json(const SceneQuery& query, const TraceFrame& frame,
                     std::span<const std::uint32_t> tests) {
    Json result = Json::object();
    for (const std::uint32_t test : tests) {
        const IndexPair nodes = frame.events.volume_tests[test].nodes;
        const Json told =
            explanation_json(explained_nodes(query, frame.frame, {nodes.a, nodes.b}, "the page"));
        Json& entry = result[std::to_string(test)];
        for (const char* key : {"exact", "answer", "margin"}) entry[key] = told[key];
        if (const Json& certificate = told["certificate"]; !certificate.is_null())
            entry["room"] = certificate[certificate.contains("gap") ? "gap" : "depth"];
        for (const Json& step : told["steps"]) {
            Json& line = entry["steps"].emplace_back();
            for (const char* key : {"stage", "line", "formula", "left", "right", "slack",
                                    "separates", "rejects", "not_tried", "error"})
                if (step.contains(key)) line[key] = step[key];
        }
    }
    return result;
}

}  // namespace scb::app
