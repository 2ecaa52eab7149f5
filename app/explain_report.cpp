#include "app/explain_report.h"

#include <algorithm>
#include <cmath>

#include "app/console.h"
#include "app/text_format.h"
#include "render/volume_titles.h"

namespace scb {
namespace {

using Json = nlohmann::ordered_json;

constexpr double degrees_per_radian = 57.29577951308232;

std::string number(double value) { return format("%.6g", value); }

std::string point(const Vec3& v) {
    return "(" + number(v[0]) + ", " + number(v[1]) + ", " + number(v[2]) + ")";
}

/// With blanks up to the width; characters of UTF-8 count once.
std::string padded(std::string text, std::size_t width) {
    const auto characters =
        static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
            return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
        }));
    if (characters < width) text.append(width - characters, ' ');
    return text;
}

std::string alarming(const std::string& text, bool colored) {
    return colored ? "\033[1;31m" + text + "\033[0m" : text;
}

/// The angle between two unit vectors, accurate where it is small. Degrees, without the digits in
/// which C libraries differ.
double angle(const Vec3& a, const Vec3& b) {
    const double degrees =
        std::atan2(std::sqrt(squared_norm(cross(a, b))), dot(a, b)) * degrees_per_radian;
    return std::round(degrees * 1e9) / 1e9;
}

/// Shape and place of a volume.
std::string volume_text(const Scb& s) {
    return "center " + point(s.c) + ", normal " + point(s.n) + "\n     radius " + number(s.r) +
           ", e " + number(s.e) + ", f " + number(s.f) + ", thickness " + number(thickness(s));
}
std::string volume_text(const Ball& ball) {
    return "center " + point(ball.center) + ", radius " + number(ball.radius);
}
std::string volume_text(const Obb& box) {
    return "center " + point(box.center) + ", half lengths " + point(box.half) + "\n     axes " +
           point(box.axes.col(0)) + ", " + point(box.axes.col(1)) + ", " + point(box.axes.col(2));
}

/// Where B is, where that is not where it is in its own frame.
std::string place_text(const Scb& s) { return "center " + point(s.c) + ", normal " + point(s.n); }
std::string place_text(const Ball& ball) { return "center " + point(ball.center); }
std::string place_text(const Obb& box) { return "center " + point(box.center); }

std::string volumes_text(const ExplainedPair& pair) {
    std::string text;
    const AnyVolume* volumes[] = {&pair.a, &pair.b};
    for (std::size_t side = 0; side < 2; ++side) {
        text += side == 0 ? "  A: " : "  B: ";
        if (pair.nodes) {
            const ExplainedNode& node = (*pair.nodes)[side];
            text += "node " + std::to_string(node.index) + " of " + printable(node.body) +
                    ", depth " + std::to_string(node.depth) + ", " +
                    std::to_string(node.triangles) +
                    (node.triangles == 1 ? " triangle\n     " : " triangles\n     ");
        }
        text += std::visit([](const auto& v) { return volume_text(v); }, *volumes[side]) + "\n";
    }
    const AnyVolume b = b_seen_from_a(pair);
    const bool same_frame = pair.placed.b_to_a.rotation == Mat3::Identity() &&
                            pair.placed.b_to_a.translation == Vec3::Zero();
    if (!same_frame)
        text += "     in A's frame: " + std::visit([](const auto& v) { return place_text(v); }, b) +
                "\n";
    text += "  The centers are " + number(std::sqrt(squared_norm(center(b) - center(pair.a)))) +
            " apart";
    if (pair.kind == VolumeKind::scb)
        text +=
            ", the normals at " + number(angle(std::get<Scb>(pair.a).n, std::get<Scb>(b).n)) + "°";
    text += ".\n";
    for (const std::string& note : pair.notes) text += "  " + printable(note) + "\n";
    return text;
}

/// What becomes of a step, once it is known which one decides.
std::string fate(const OverlapSteps& steps, std::size_t i) {
    const OverlapStep& step = steps.steps[i];
    const std::optional<std::size_t> decisive = steps.decisive();
    std::string text;
    if (!step.skipped.empty())
        text = "not tried: " + step.skipped + (step.separates ? "; it would separate" : "");
    else if (decisive == i)
        text = "rejects";
    else if (decisive && i > *decisive)
        text = step.separates ? "not reached; it would also separate" : "not reached";
    if (!step.error.empty()) text += (text.empty() ? "" : "; ") + step.error;
    return text;
}

std::string steps_text(const OverlapSteps& steps) {
    std::string text;
    for (const OverlapQuantity& q : steps.quantities)
        text += (text.empty() ? "  " : ", ") + std::string(q.name) + " = " + number(q.value);
    text += "\n\n  line  " + padded("stage", 15);
    std::size_t width = 10;
    for (const OverlapStep& step : steps.steps)
        width = std::max(width, step.formula.size() + 2 -
                                    static_cast<std::size_t>(std::count_if(
                                        step.formula.begin(), step.formula.end(), [](char c) {
                                            return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
                                        })));
    text += padded("separates if", width) + format("%13s %13s %13s\n", "left", "right", "slack");
    for (std::size_t i = 0; i < steps.steps.size(); ++i) {
        const OverlapStep& step = steps.steps[i];
        const std::string how = fate(steps, i);
        text += "  " + padded(step.line > 0 ? format("%4d", step.line) : "   -", 6) +
                padded(std::string(stage_name(step.stage)), 15) + padded(step.formula, width) +
                format("%13.6g %13.6g %+13.6g", step.left, step.right, step.slack) +
                (how.empty() ? "" : "  " + how) + "\n";
    }
    const bool has_lines = std::any_of(steps.steps.begin(), steps.steps.end(),
                                       [](const OverlapStep& step) { return step.line > 0; });
    return text + (has_lines ? "  Lines are those of the paper's Figure 8. " : "  ") +
           "Of every slack, " + format("%.2g", steps.margin) + " is left for rounding.\n";
}

std::string exact_text(const ExplainedPair& pair) {
    const ContactProof& proof = pair.found.proof;
    const std::string checked = pair.found.proven ? ", verified" : "";
    switch (proof.contact) {
        case Contact::disjoint:
            return "disjoint: at least " + number(proof.margin) + " apart along " +
                   point(proof.direction) + checked;
        case Contact::overlapping:
            return "overlapping: " + point(Vec3(center(pair.a) + proof.point)) +
                   " is in both, and B is at least " + number(proof.margin) + " deep in A" +
                   checked;
        case Contact::touching:
            break;
    }
    return "touching: neither apart nor in each other by more than rounding or 1e-9 of the larger";
}

std::string answer_text(Answer answer, bool colored) {
    switch (answer) {
        case Answer::false_positive:
            return "FALSE POSITIVE: the test let disjoint volumes pass";
        case Answer::false_negative:
            return alarming("FALSE NEGATIVE: the test rejected volumes that overlap", colored);
        case Answer::correct:
            break;
    }
    return "correct";
}

std::string asked_text(const ExplainedPair& pair) {
    if (pair.kind != VolumeKind::scb) return "test";
    const OverlapOptions& options = pair.options;
    std::string text(overlap_test_name(options.test));
    if (has_threshold(options.test)) text += format(", a = %g", options.threshold);
    return text;
}

Json json_of(const Vec3& v) { return {v[0], v[1], v[2]}; }

Json json_of(const Scb& s) {
    return {{"center", json_of(s.c)},
            {"radius", s.r},
            {"normal", json_of(s.n)},
            {"e", s.e},
            {"f", s.f}};
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
Json json_of(const AnyVolume& volume) {
    return std::visit([](const auto& v) { return json_of(v); }, volume);
}

Json json_of(const Pose& pose) {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) rows.push_back(pose.rotation(row, column));
        rows.push_back(pose.translation[row]);
    }
    return rows;
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

Json proof_json(const ExplainedPair& pair) {
    const ContactProof& proof = pair.found.proof;
    if (proof.contact == Contact::touching) return nullptr;
    Json result;
    if (proof.contact == Contact::disjoint) {
        result["direction"] = json_of(proof.direction);
        result["gap"] = proof.margin;
    } else {
        result["point"] = json_of(Vec3(center(pair.a) + proof.point));
        result["depth"] = proof.margin;
    }
    result["verified"] = pair.found.proven;
    return result;
}

}  // namespace

std::string node_names(const ExplainedPair& pair) {
    if (!pair.nodes) return {};
    const auto name = [](const ExplainedNode& node) {
        return node.body + " " + std::to_string(node.index);
    };
    return name((*pair.nodes)[0]) + ", " + name((*pair.nodes)[1]);
}

std::string explanation_text(const ExplainedPair& pair, bool colored) {
    std::string text = volumes_text(pair) + "\n" + steps_text(pair.found.steps) + "\n";
    const auto row = [&text](const std::string& name, const std::string& value) {
        text += "  " + padded(name, 20) + value + "\n";
    };
    row(asked_text(pair), ending_words(pair.found.steps.stage()));
    row("exact", exact_text(pair));
    row("answer", answer_text(pair.found.answer, colored));
    if (pair.found.tests.empty()) return text;
    text += "\n  The other tests:\n";
    for (const TestAnswer& test : pair.found.tests) {
        if (test.test == pair.options.test) continue;
        std::string words = padded(ending_words(test.stage), 28);
        if (test.answer == Answer::false_negative)
            words += alarming("FALSE NEGATIVE", colored);
        else
            words += test.answer == Answer::false_positive ? "FALSE POSITIVE" : "correct";
        row(std::string(overlap_test_name(test.test)), words);
    }
    return text;
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
        answers[std::string(overlap_test_name(test.test))] = answer_name(test.answer);
    }
    if (found.tests.empty()) {
        stages[kind] = stage_name(found.steps.stage());
        answers[kind] = answer_name(found.answer);
    }
    result["test"] =
        pair.kind == VolumeKind::scb ? std::string(overlap_test_name(pair.options.test)) : kind;
    if (pair.kind == VolumeKind::scb) result["threshold"] = pair.options.threshold;
    result["stage"] = std::move(stages);
    result["exact"] = contact_name(found.proof.contact);
    result["answer"] = answer_name(found.answer);
    result["answers"] = std::move(answers);
    result["proof"] = proof_json(pair);
    result["a"] = json_of(pair.a);
    result["b"] = json_of(pair.b);
    result["pose"] = json_of(pair.placed.b_to_a);
    const AnyVolume b = b_seen_from_a(pair);
    result["b_in_a"] = json_of(b);
    if (pair.kind == VolumeKind::scb) {
        result["thickness"] = {thickness(std::get<Scb>(pair.a)), thickness(std::get<Scb>(b))};
        result["normal_angle"] = angle(std::get<Scb>(pair.a).n, std::get<Scb>(b).n);
    }
    result["center_distance"] = std::sqrt(squared_norm(center(b) - center(pair.a)));
    result["margin"] = found.steps.margin;
    for (const OverlapQuantity& q : found.steps.quantities)
        result["quantities"][std::string(q.key)] = q.value;
    result["steps"] = steps_json(found.steps);
    if (!pair.notes.empty()) result["notes"] = pair.notes;
    return result;
}

}  // namespace scb
