#include "app/view/view_steps.h"

#include <nlohmann/json.hpp>

#include "app/explain/explain_report.h"

namespace scb::app {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json view_steps_json(const SceneQuery& query, const QueryTrace& frame,
                     std::span<const std::uint32_t> tests) {
    Json result = Json::object();
    for (const std::uint32_t test : tests) {
        const IndexPair nodes = frame.steps.volumes[test].nodes;
        const Json told =
            explanation_json(explained_nodes(query, frame.frame, {nodes.a, nodes.b}, "the page"));
        Json& entry = result[std::to_string(test)];
        for (const char* key : {"exact", "answer"}) entry[key] = told[key];
        if (const Json& certificate = told["certificate"]; !certificate.is_null())
            entry["room"] = certificate[certificate.contains("gap") ? "gap" : "depth"];
        for (const Json& step : told["steps"]) {
            Json& line = entry["steps"].emplace_back();
            for (const char* key : {"stage", "formula", "slack", "rejects", "not_tried", "error"})
                if (step.contains(key)) line[key] = step[key];
        }
    }
    return result;
}

}  // namespace scb::app
