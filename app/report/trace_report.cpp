#include "app/report/trace_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/analysis/trace_words.h"
#include "core/base/text_format.h"
#include "core/collide/index_pairs.h"
#include "core/platform/utf8.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string trace_header_text(const TraceHeader& header) {
    std::string text;
    for (const TraceField& field : fields_of(header))
        text += format("%-10s ", field.name.c_str()) + printable(field.value) + "\n";
    std::string files;
    for (const std::string& name : header.source) files += (files.empty() ? "" : " ") + name;
    text += format("%-10s ", "named") + printable(files) + "\n";
    if (header.engine) return text;
    return text + "recorded by scb " + printable(header.scb_version) + "\n";
}

Json body_json(const TraceBody& body) {
    return {{"name", body.name},
            {"triangles", body.mesh.triangles},
            {"vertices", body.mesh.vertices},
            {"hash", hash_text(body.mesh.hash)}};
}

Json limits_json(const DistanceOptions& limits) {
    return {{"order", distance_order_name(limits.order)},
            {"relative_error", limits.relative_error},
            {"limit", std::isfinite(limits.limit) ? Json(limits.limit) : Json()}};
}

Json trace_header_json(const TraceHeader& header) {
    Json bodies = Json::array();
    for (const TraceBody& body : header.bodies) bodies.push_back(body_json(body));
    Json result;
    if (!header.engine) result["version"] = header.scb_version;
    result["source"] = header.source;
    result["scene"] = header.scene;
    result["bodies"] = bodies;
    if (header.engine) {
        result["engine"] = header.engine->name;
        result["volume"] = header.engine->volumes;
        result["settings"] = Json::object();
        for (const TraceField& setting : header.engine->settings)
            result["settings"][setting.name] = setting.value;
        if (header.engine->left_out > 0) result["left_out"] = header.engine->left_out;
        return result;
    }
    result["volume"] = volume_kind_name(header.volume);
    result["growth"] = ball_growth_name(header.growth);
    result["margin"] = header.margin;
    result["split"] = split_method_name(header.split);
    if (is_of_distance(header.kind)) {
        result["query"] = query_kind_name(header.kind);
        result["descent"] = descent_rule_name(header.options.descent);
        if (header.kind == QueryKind::within) {
            result["tolerance"] = header.tolerance;
            return result;
        }
        result.update(limits_json(header.distance));
        if (header.distance.enough >= 0) result["ends_at"] = header.distance.enough;
        return result;
    }
    if (header.volume == VolumeKind::scb) {
        result["test"] = overlap_test_name(header.options.overlap.test);
        if (has_threshold(header.options.overlap.test))
            result["threshold"] = header.options.overlap.threshold;
    }
    result["descent"] = descent_rule_name(header.options.descent);
    result["max_pairs"] = header.options.max_pairs;
    result["level"] = header.options.stop_level >= 0 ? Json(header.options.stop_level) : Json();
    return result;
}

Json traced_test_json(const TracedTest& test, const BodyNames& bodies) {
    const auto nodes = [](const Step& t) -> Json {
        return {{"nodes", {t.nodes.a, t.nodes.b}}, {"depths", {t.depth_a, t.depth_b}}};
    };
    Json result = nodes(test.test);
    result["stage"] = test.stage;
    result["outcome"] = words_of(test, bodies);
    if (test.triangles) {
        const bool of_distance = is_of_distance(test.kind);
        result["triangles"] = {test.triangles->items.a, test.triangles->items.b};
        result[of_distance ? "hit" : "intersect"] = test.triangles->hit;
        if (test.triangle_tests > 1) {
            result["triangle_tests"] = test.triangle_tests;
            result[of_distance ? "hits" : "intersecting"] = test.intersecting;
        }
    }
    if (test.parent) {
        result["parent"] = nodes(*test.parent);
        result["parent"]["divided"] = test.parent_outcome == Stage::divided_both
                                          ? "both"
                                          : bodies[test.parent_outcome == Stage::divided_a ? 0 : 1];
    }
    return result;
}

}  // namespace scb::app
