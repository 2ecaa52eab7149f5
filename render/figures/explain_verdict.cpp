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
    const Stage stage = found.steps.stage();
    std::vector<VerdictLine> lines;
    const auto shape = [](const AnyVolume& volume) {
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
    };
    const std::string test = figure.kind == VolumeKind::scb
                                 ? std::string(overlap_test_name(figure.options.test))
                                 : "test";
    if (figure.ending.empty())
        lines.push_back({test + ":  " + ending_words(stage), theme.text, FontWeight::bold,
                         stage == Stage::overlapping ? std::nullopt
                                                     : std::optional(ending_color(stage, theme))});
    else
        lines.push_back({figure.ending, theme.text, FontWeight::bold});
    lines.push_back({"exact:  " + exact_words(found.certificate), theme.text, FontWeight::bold});
    std::string answer(answer_names[found.answer]);
    if (found.answer == Answer::correct)
        answer = "the test is right" + (figure.but.empty() ? "" : ", but " + figure.but);
    else
        answer = found.answer == Answer::false_positive
                     ? "FALSE POSITIVE: passed, but disjoint"
                     : "FALSE NEGATIVE: rejected, but overlapping";
    if (figure.is_tested)
        lines.push_back({answer, answer_color(found.answer, theme), FontWeight::bold});
    // Of the paper's errors, the one to blame: where `corrected` answers alike, none is.
    const Stage erring = found.answer == Answer::false_positive ? Stage::cylinder_slab : stage;
    const bool is_to_blame =
        found.answer != Answer::correct &&
        std::any_of(found.tests.begin(), found.tests.end(), [](const TestAnswer& t) {
            return t.test == OverlapTest::corrected && t.answer == Answer::correct;
        });
    for (const OverlapStep& step : found.steps.steps)
        if (is_to_blame && step.stage == erring && step.skipped.empty() && !step.error.empty())
            lines.push_back({"line " + std::to_string(step.line) + " " + step.error, theme.text});
    lines.push_back(
        {figure.names[0] + ":  " + shape(figure.a), theme.text, FontWeight::regular, body_a_color});
    lines.push_back(
        {figure.names[1] + ":  " + shape(figure.b), theme.text, FontWeight::regular, body_b_color});
    // The other tests, those that end alike together.
    std::vector<std::pair<Stage, VerdictLine>> others;
    for (const TestAnswer& t : found.tests) {
        if (t.test == figure.options.test) continue;
        const std::string name(overlap_test_name(t.test));
        const auto same = std::find_if(others.begin(), others.end(),
                                       [&](const auto& o) { return o.first == t.stage; });
        if (same != others.end())
            same->second.text = name + ", " + same->second.text;
        else
            others.push_back(
                {t.stage,
                 {name + ":  " + ending_words(t.stage),
                  t.answer == Answer::correct ? theme.faint_text : answer_color(t.answer, theme)}});
    }
    for (auto& [ending, line] : others) lines.push_back(std::move(line));
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
