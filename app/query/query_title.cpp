#include "app/query/query_title.h"

#include <nlohmann/json.hpp>
#include <numeric>

#include "app/report/trace_report.h"
#include "core/base/text_format.h"
#include "core/geometry/mesh_facts.h"

namespace scb::app {
namespace {

/// The two bodies of the queries; with several pairs, all bodies of the scene.
std::vector<std::size_t> queried_bodies(const SceneQuery& query) {
    if (!is_of_many(query)) return {query.a, query.b};
    std::vector<std::size_t> all(query.scene.bodies.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

}  // namespace

bool is_of_many(const SceneQuery& query) { return query.pairs.size() > 1; }

const std::string& body_name(const SceneQuery& query, std::size_t body) {
    return query.scene.bodies[body].name;
}

std::string pair_words(const SceneQuery& query) {
    return body_name(query, query.a) + " and " + body_name(query, query.b);
}

std::string bodies_title(const SceneQuery& query) {
    const auto body = [&query](std::size_t i) {
        return body_name(query, i) + " (" +
               counted(query.mesh(i).triangles.size(), "triangle", "triangles") + ")";
    };
    const std::vector<std::size_t> bodies = queried_bodies(query);
    std::string text = query.scene.name + ": " + body(bodies[0]);
    if (query.is_self())
        text += " against itself";
    else
        for (std::size_t i = 1; i < bodies.size(); ++i)
            text += (i + 1 < bodies.size() ? ", " : " and ") + body(bodies[i]);
    if (is_of_many(query)) text += format(", %zu pairs of bodies", query.pairs.size());
    return text + ", " + std::string(volume_kind_name(query.kind)) + " hierarchies";
}

nlohmann::ordered_json bodies_json(const SceneOptions& scene, const SceneQuery& query) {
    nlohmann::ordered_json json = {
        {"version", SCB_VERSION}, {"scene", query.scene.name}, {"source", utf8_names(scene.names)}};
    for (const std::size_t i : queried_bodies(query))
        json["bodies"].push_back(body_json({body_name(query, i), fingerprint(query.mesh(i))}));
    json["volume"] = volume_kind_name(query.kind);
    return json;
}

nlohmann::ordered_json pair_json(const SceneQuery& query) {
    return {body_name(query, query.a), body_name(query, query.b)};
}

nlohmann::ordered_json build_json(const BuildOptions& build) {
    return {{"growth", ball_growth_name(build.fit.growth)},
            {"margin", build.fit.margin},
            {"split", split_method_name(build.split)}};
}

}  // namespace scb::app
