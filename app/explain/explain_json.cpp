#include <cmath>
#include <nlohmann/json.hpp>

#include "app/explain/explain_report.h"
#include "app/report/scene_report.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v) {
    return {v[0] + 0.0, v[1] + 0.0, v[2] + 0.0};  // -0 is 0
}

Json json_of(const Scb& s) {
    return {{"center", json_of(s.c)},
            {"radius", s.r},
            {"normal", json_of(s.n)},
            {"e", s.e},
            {"f", s.f}};
}
Json json_of(const Scb2& s) {
    Json slabs = Json::array();
    for (const Slab& slab : s.slabs)
        slabs.push_back({{"normal", json_of(slab.n)}, {"e", slab.e}, {"f", slab.f}});
    return {{"center", json_of(s.c)}, {"radius", s.r}, {"slabs", slabs}};
}
Json json_of(const Ball& ball) {
    return {{"center", json_of(ball.center)}, {"radius", ball.radius}};
}
Json json_of(const Obb& box) {
    return {{"center", json_of(box.center)},
            {"axes",
             {json_of(Vec3(box.axes.col(0))), json_of(Vec3(box.axes.col(1))),
              json_of(Vec3(box.axes.col(2)))}},
            {"half", json_of(box.half)}};
}
/// For a convex volume, the box along the axes of its frame.
Json json_of(const ConvexShape& shape) {
    Json reach = Json::array();
    for (int i = 0; i < 3; ++i)
        reach.push_back(
            {-support(shape, Vec3(-shape.axes.col(i))), support(shape, Vec3(shape.axes.col(i)))});
    return {{"center", json_of(shape.center)},
            {"rounding", shape.rounding},
            {"axes",
             {json_of(Vec3(shape.axes.col(0))), json_of(Vec3(shape.axes.col(1))),
              json_of(Vec3(shape.axes.col(2)))}},
            {"reach", reach}};
}
Json json_of(const AnyVolume& volume) {
    return std::visit([](const auto& v) { return json_of(v); }, volume);
}

Json steps_json(const OverlapSteps& steps) {
    Json list = Json::array();
    for (std::size_t i = 0; i < steps.steps.size(); ++i) {
        const OverlapStep& step = steps.steps[i];
        Json entry = {{"stage", stage_name(step.stage)},
                      {"line", step.line > 0 ? Json(step.line) : Json()},
                      {"formula", step.formula},
                      {"left", step.left},
                      {"right", step.right},
                      {"slack", step.slack},
                      {"separates", step.separates},
                      {"rejects", steps.decisive() == i},
                      {"reached",
                       step.skipped.empty() && i <= steps.decisive().value_or(steps.steps.size())}};
        if (!step.skipped.empty()) entry["not_tried"] = step.skipped;
        if (!step.error.empty()) entry["error"] = step.error;
        entry["direction"] = json_of(step.direction);
        entry["reach_a"] = step.reach_a;
        entry["reach_b"] = step.reach_b;
        if (step.effective_radius != 0) entry["effective_radius"] = step.effective_radius;
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace

Json certificate_json(const ExplainedPair& pair) {
    const ContactCertificate& certificate = pair.found.certificate;
    if (certificate.contact == Contact::touching) return nullptr;
    Json result;
    if (certificate.contact == Contact::disjoint) {
        result["direction"] = json_of(certificate.direction);
        result["gap"] = certificate.margin;
    } else {
        if (pair.found.verified)
            result["point"] = json_of(Vec3(center(pair.a) + certificate.point));
        result["depth"] = certificate.margin;
    }
    result["verified"] = pair.found.verified;
    return result;
}

void add_volumes_json(Json& json, const ExplainedPair& pair) {
    json["a"] = json_of(pair.a);
    json["b"] = json_of(pair.b);
    json["pose"] = pose_json(pair.placed.b_to_a);
    const AnyVolume b = b_seen_from_a(pair);
    json["b_in_a"] = json_of(b);
    if (pair.kind == VolumeKind::scb) {
        json["thickness"] = {thickness(std::get<Scb>(pair.a)), thickness(std::get<Scb>(b))};
        json["normal_angle"] = normal_angle(pair);
    }
    json["center_distance"] = std::sqrt(squared_norm(center(b) - center(pair.a)));
}

Json explanation_json(const ExplainedPair& pair) {
    const PairExplanation& found = pair.found;
    const std::string kind(volume_kind_name(pair.kind));
    Json result = {{"volume", kind}}, stages = Json::object(), answers = Json::object();
    if (pair.nodes)
        for (const ExplainedNode& node : *pair.nodes)
            result["nodes"].push_back({{"body", node.body},
                                       {"index", node.index},
                                       {"depth", node.depth},
                                       {"triangles", node.triangles}});
    for (const TestAnswer& test : found.tests) {
        stages[std::string(overlap_test_name(test.test))] = stage_name(test.stage);
        answers[std::string(overlap_test_name(test.test))] = answer_names[test.answer];
    }
    if (found.tests.empty()) {
        stages[kind] = stage_name(found.steps.stage());
        answers[kind] = answer_names[found.answer];
    }
    result["test"] =
        pair.kind == VolumeKind::scb ? std::string(overlap_test_name(pair.options.test)) : kind;
    if (pair.kind == VolumeKind::scb) result["threshold"] = pair.options.threshold;
    result["stage"] = std::move(stages);
    result["exact"] = contact_names[found.certificate.contact];
    result["answer"] = answer_names[found.answer];
    result["answers"] = std::move(answers);
    result["certificate"] = certificate_json(pair);
    add_volumes_json(result, pair);
    result["margin"] = found.steps.margin;
    for (const OverlapQuantity& q : found.steps.quantities)
        result["quantities"][std::string(q.key)] = q.value;
    result["steps"] = steps_json(found.steps);
    if (!pair.notes.empty()) result["notes"] = pair.notes;
    return result;
}

std::string json_text(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace scb::app
