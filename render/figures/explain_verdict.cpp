#include "render/figures/explain_verdict.h"

#include <algorithm>

#include "render/overlay/figure_layout.h"
#include "render/plots/ending_colors.h"
#include "render/plots/slack_chart.h"

namespace scb::render {
namespace {

Rgba8 answer_color(Answer answer, const Theme& theme) {
    switch (answer) {
        case Answer::false_positive:
            return theme.accent;
        case Answer::false_negative:
            return theme.warning;
        case Answer::correct:
            break;
    }
    return theme.text;
}

/// The lengths of a volume.
std::string shape_words(const AnyVolume& volume) {
    if (const Scb* s = std::get_if<Scb>(&volume))
        return "r " + number_text(s->r) + ", τ " + number_text(thickness(*s));
    if (const Scb2* s = std::get_if<Scb2>(&volume)) {
        const auto& [first, second] = s->slabs;
        return "r " + number_text(s->r) + ", τ " + number_text(first.e - first.f) + ", τ″ " +
               number_text(second.e - second.f);
    }
    if (const Ball* ball = std::get_if<Ball>(&volume)) return "r " + number_text(ball->radius);
    if (const ConvexShape* convex = std::get_if<ConvexShape>(&volume)) {
        Vec3 sides;
        for (int i = 0; i < 3; ++i)
            sides[i] = support(*convex, Vec3(convex->axes.col(i))) +
                       support(*convex, Vec3(-convex->axes.col(i)));
        for (int i = 0; i < 3; ++i)
            if (sides[i] < 1e-12 * sides.maxCoeff()) sides[i] = 0;  // rounding
        return "box " + number_text(sides[0]) + " × " + number_text(sides[1]) + " × " +
               number_text(sides[2]) +
               (convex->rounding > 0 ? ", r " + number_text(convex->rounding) : "");
    }
    const Vec3& half = std::get<Obb>(volume).half;
    return "half " + number_text(half[0]) + " × " + number_text(half[1]) + " × " +
           number_text(half[2]);
}

VerdictLine ending_line(const ExplainFigure& figure) {
    const Theme& theme = *figure.theme;
    if (!figure.ending.empty()) return {figure.ending, theme.text, FontWeight::bold};
    const Stage stage = figure.found->steps.stage();
    const std::string test = figure.kind == VolumeKind::scb
                                 ? std::string(overlap_test_name(figure.options.test))
                                 : "test";
    return {test + ":  " + ending_words(stage), theme.text, FontWeight::bold,
            stage == Stage::overlapping ? std::nullopt : std::optional(ending_color(stage, theme))};
}

std::string answer_words(const ExplainFigure& figure) {
    switch (figure.found->answer) {
        case Answer::false_positive:
            return "FALSE POSITIVE: passed, but disjoint";
        case Answer::false_negative:
            return "FALSE NEGATIVE: rejected, but overlapping";
        case Answer::correct:
            break;
    }
    return "the test is right" + (figure.but.empty() ? "" : ", but " + figure.but);
}

/// Of the paper's errors, the one to blame: where `corrected` answers alike, none is.
std::vector<VerdictLine> error_lines(const ExplainFigure& figure) {
    const PairExplanation& found = *figure.found;
    if (found.answer == Answer::correct ||
        std::none_of(found.tests.begin(), found.tests.end(), [](const TestAnswer& t) {
            return t.test == OverlapTest::corrected && t.answer == Answer::correct;
        }))
        return {};
    const Stage erring =
        found.answer == Answer::false_positive ? Stage::cylinder_slab : found.steps.stage();
    std::vector<VerdictLine> lines;
    for (const OverlapStep& step : found.steps.steps)
        if (step.stage == erring && step.skipped.empty() && !step.error.empty())
            lines.push_back(
                {"line " + std::to_string(step.line) + " " + step.error, figure.theme->text});
    return lines;
}

/// The other tests, those that end alike together.
std::vector<VerdictLine> other_test_lines(const ExplainFigure& figure) {
    const Theme& theme = *figure.theme;
    std::vector<Stage> endings;
    std::vector<VerdictLine> lines;  // per ending
    for (const TestAnswer& t : figure.found->tests) {
        if (t.test == figure.options.test) continue;
        const std::string name(overlap_test_name(t.test));
        const auto same = std::find(endings.begin(), endings.end(), t.stage);
        if (same != endings.end()) {
            std::string& text = lines[static_cast<std::size_t>(same - endings.begin())].text;
            text = name + ", " + text;
            continue;
        }
        endings.push_back(t.stage);
        lines.push_back(
            {name + ":  " + ending_words(t.stage),
             t.answer == Answer::correct ? theme.faint_text : answer_color(t.answer, theme)});
    }
    return lines;
}

}  // namespace

const OverlapStep& shown_step(const ExplainFigure& figure) {
    const OverlapSteps& steps = figure.found->steps;
    return steps.steps[steps.closest()];
}

std::string exact_words(const ContactCertificate& certificate) {
    switch (certificate.contact) {
        case Contact::disjoint:
            return "disjoint, " + number_text(certificate.margin) + " apart";
        case Contact::overlapping:
            return "overlapping, " + number_text(certificate.margin) + " deep";
        case Contact::touching:
            break;
    }
    return "touching";
}

std::vector<VerdictLine> verdict_lines(const ExplainFigure& figure) {
    const Theme& theme = *figure.theme;
    const PairExplanation& found = *figure.found;
    std::vector<VerdictLine> lines = {
        ending_line(figure),
        {"exact:  " + exact_words(found.certificate), theme.text, FontWeight::bold}};
    if (figure.is_tested)
        lines.push_back(
            {answer_words(figure), answer_color(found.answer, theme), FontWeight::bold});
    for (VerdictLine& line : error_lines(figure)) lines.push_back(std::move(line));
    lines.push_back({figure.names[0] + ":  " + shape_words(figure.a), theme.text,
                     FontWeight::regular, body_a_color});
    lines.push_back({figure.names[1] + ":  " + shape_words(figure.b), theme.text,
                     FontWeight::regular, body_b_color});
    for (VerdictLine& line : other_test_lines(figure)) lines.push_back(std::move(line));
    return lines;
}

void draw_verdict(Overlay& overlay, const PixelRect& box, const ExplainFigure& figure, int unit) {
    const int small = small_size(unit), line = slack_line(unit), indent = small * 5 / 4;
    int y = box.y;
    for (const VerdictLine& v : verdict_lines(figure)) {
        const TextStyle style{small, v.weight, v.color};
        for (const std::string& part : wrapped_text(overlay, v.text, style, box.width - indent)) {
            if (y + line > box.y + box.height) return;
            overlay.text(box.x + indent, y, part, style);
            if (v.swatch && part == wrapped_text(overlay, v.text, style, box.width - indent)[0])
                overlay.rectangle({box.x, y + small / 8, small * 4 / 5, small * 4 / 5}, *v.swatch);
            y += line;
        }
    }
}

}  // namespace scb::render
