#include "app/explain/explain_report.h"

#include <algorithm>
#include <cmath>

#include "app/cli/console.h"
#include "app/report/scene_report.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/figures/explain_figure.h"
#include "render/figures/figure_words.h"

namespace scb::app {
namespace {

std::string number(double value) { return format("%.6g", value); }

std::string point(const Vec3& v) {
    const Vec3 w = v + Vec3::Zero();  // -0 is 0
    return "(" + number(w[0]) + ", " + number(w[1]) + ", " + number(w[2]) + ")";
}

/// Pads with blanks to the width; a UTF-8 character counts once.
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

/// Shape and position of a volume.
std::string volume_text(const Scb& s) {
    return "center " + point(s.c) + ", normal " + point(s.n) + "\n     radius " + number(s.r) +
           ", e " + number(s.e) + ", f " + number(s.f) + ", thickness " + number(thickness(s));
}
std::string volume_text(const Scb2& s) {
    std::string text = "center " + point(s.c) + ", radius " + number(s.r);
    for (std::size_t i = 0; i < 2; ++i) {
        const Slab& slab = s.slabs[i];
        text += std::string("\n     ") + (i == 0 ? "n " : "n″ ") + point(slab.n) + ", e " +
                number(slab.e) + ", f " + number(slab.f) + ", thickness " + number(slab.e - slab.f);
    }
    return text;
}
std::string volume_text(const Ball& ball) {
    return "center " + point(ball.center) + ", radius " + number(ball.radius);
}
std::string volume_text(const Obb& box) {
    return "center " + point(box.center) + ", half lengths " + point(box.half) + "\n     axes " +
           point(box.axes.col(0)) + ", " + point(box.axes.col(1)) + ", " + point(box.axes.col(2));
}
/// Its extents along the axes of its frame, in both directions.
std::string volume_text(const ConvexShape& shape) {
    Vec3 up, down;
    for (int i = 0; i < 3; ++i) {
        up[i] = support(shape, Vec3(shape.axes.col(i)));
        down[i] = -support(shape, Vec3(-shape.axes.col(i)));
    }
    return "center " + point(shape.center) +
           (shape.rounding > 0 ? ", radius " + number(shape.rounding) : std::string()) +
           "\n     from there " + point(down) + " to " + point(up);
}

/// The position of B in A's frame; printed if it differs from the one in B's frame.
std::string place_text(const Scb& s) { return "center " + point(s.c) + ", normal " + point(s.n); }
std::string place_text(const Scb2& s) {
    return "center " + point(s.c) + ", normals " + point(s.slabs[0].n) + ", " + point(s.slabs[1].n);
}
std::string place_text(const Ball& ball) { return "center " + point(ball.center); }
std::string place_text(const Obb& box) { return "center " + point(box.center); }
std::string place_text(const ConvexShape& shape) { return "center " + point(shape.center); }

}  // namespace

std::string volumes_text(const ExplainedPair& pair) {
    std::string text;
    const AnyVolume* volumes[] = {&pair.a, &pair.b};
    for (std::size_t side = 0; side < 2; ++side) {
        text += side == 0 ? "  A: " : "  B: ";
        if (pair.nodes) {
            const ExplainedNode& node = (*pair.nodes)[side];
            text += "node " + std::to_string(node.index) + " of " + printable(node.body) +
                    ", depth " + std::to_string(node.depth) + ", " +
                    std::to_string(node.triangles) + (node.are_objects ? " object" : " triangle") +
                    (node.triangles == 1 ? "" : "s") +
                    (node.remark.empty() ? "" : ", " + printable(node.remark)) + "\n     ";
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
        text += ", the normals at " + number(normal_angle(pair)) + "°";
    text += ".\n";
    for (const std::string& note : pair.notes) text += "  " + printable(note) + "\n";
    return text;
}

namespace {

/// The role of a step, given the decisive step.
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
    const bool has_lines = std::any_of(steps.steps.begin(), steps.steps.end(),
                                       [](const OverlapStep& step) { return step.line > 0; });
    text += std::string("\n\n  ") + (has_lines ? "line  " : "") + padded("stage", 15);
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
        text += "  ";
        if (has_lines) text += padded(step.line > 0 ? format("%4d", step.line) : "   -", 6);
        text += padded(std::string(stage_name(step.stage)), 15) + padded(step.formula, width) +
                format("%13.6g %13.6g %+13.6g", step.left, step.right, step.slack) +
                (how.empty() ? "" : "  " + how) + "\n";
    }
    const bool has_edges = std::any_of(
        steps.steps.begin(), steps.steps.end(),
        [](const OverlapStep& step) { return step.formula.find("×") != std::string::npos; });
    return text + (has_lines ? "  Lines are those of the paper's Figure 8. " : "  ") +
           "Of every slack, " + format("%.2g", steps.margin) + " is left for rounding" +
           (has_edges ? "; along products of edges, that over the sine of their angle.\n" : ".\n");
}

}  // namespace

std::string exact_text(const ExplainedPair& pair) {
    const ContactCertificate& certificate = pair.found.certificate;
    const std::string checked = pair.found.verified ? ", verified" : "";
    switch (certificate.contact) {
        case Contact::disjoint:
            return "disjoint: at least " + number(certificate.margin) + " apart along " +
                   point(certificate.direction) + checked;
        case Contact::overlapping:
            return "overlapping: " +
                   (pair.found.verified
                        ? point(Vec3(center(pair.a) + certificate.point)) + " is in both, and "
                        : std::string()) +
                   "B is at least " + number(certificate.margin) + " deep in A" + checked;
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

namespace {

/// Symbols in formulas that the paper does not have, one per line.
std::string symbols_text(const ExplainedPair& pair) {
    std::string text;
    for (const std::string_view line : render::symbol_lines(pair.kind, pair.options))
        text += "  " + std::string(line) + "\n";
    return text;
}

}  // namespace

std::string node_names(const ExplainedPair& pair) {
    if (!pair.nodes) return {};
    const auto name = [](const ExplainedNode& node) {
        return node.body + " " + std::to_string(node.index);
    };
    return name((*pair.nodes)[0]) + ", " + name((*pair.nodes)[1]);
}

PairNames pair_names(const std::string& scene, const ExplainedPair& pair) {
    if (!pair.nodes) return {scene, ""};
    const auto& [a, b] = *pair.nodes;
    if (scene == a.body + "-" + b.body) return {"", node_names(pair)};
    const std::string title = scene_title(scene, a.body, b.body);
    if (title == scene) return {scene, node_names(pair)};
    return {title, "A " + std::to_string(a.index) + ", B " + std::to_string(b.index)};
}

std::string explanation_text(const ExplainedPair& pair, bool colored) {
    std::string text =
        volumes_text(pair) + "\n" + steps_text(pair.found.steps) + symbols_text(pair) + "\n";
    const auto row = [&text](const std::string& name, const std::string& value) {
        text += "  " + padded(name, 20) + value + "\n";
    };
    row(pair.kind == VolumeKind::scb ? overlap_title(pair.options) : "test",
        ending_words(pair.found.steps.stage()));
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

}  // namespace scb::app
