#include "render/plots/slack_chart.h"

#include <algorithm>
#include <cmath>

#include "render/overlay/figure_layout.h"
#include "render/plots/ending_colors.h"

namespace scb::render {
namespace {

struct Row {
    std::string name, number, note;
    std::size_t step = 0;
    bool shown = false;  ///< the step of the section
    bool faint = false;
};

std::string signed_text(double value) {
    return (value > 0 ? "+" : value < 0 ? "−" : "") + number_text(std::abs(value));
}

std::vector<Row> rows_of(const OverlapSteps& steps, bool formulas) {
    std::vector<Row> rows;
    const std::optional<std::size_t> decisive = steps.decisive();
    const std::size_t closest = steps.closest();
    for (std::size_t i = 0; i < steps.steps.size(); ++i) {
        const OverlapStep& step = steps.steps[i];
        Row row;
        row.step = i;
        if (step.line > 0) row.name = std::to_string(step.line) + "  ";
        row.name += formulas ? step.formula : std::string(stage_name(step.stage));
        // Only rounding.
        const bool vanishes = !step.skipped.empty() && std::abs(step.slack) <= 2 * steps.margin;
        row.number = vanishes ? "–" : signed_text(step.slack);
        row.shown = i == closest;
        row.faint = !step.skipped.empty() || (decisive && i > *decisive);
        if (decisive == i)
            row.note = "rejects";
        else if (!step.skipped.empty())
            row.note = "not tried";
        else if (row.faint && step.separates)
            row.note = "would too";
        rows.push_back(std::move(row));
    }
    return rows;
}

/// If there is no room for all: keeps the first rows, the number of omitted rows, and the closest
/// step.
void keep_rows(std::vector<Row>& rows, std::size_t room, std::size_t closest) {
    if (rows.size() <= room) return;
    const std::size_t first = room < 3 ? 0 : room - 2;
    const Row last = rows[closest];
    const std::size_t left_out = rows.size() - first - (closest < first ? 0 : 1);
    rows.resize(first);
    if (room > 1) {
        rows.emplace_back().name = "and " + std::to_string(left_out) + " more";
        rows.back().step = rows.size();
        rows.back().faint = true;
    }
    if (closest >= first) rows.push_back(last);
}

/// One scale for both sides of a chart, which share the width as they need it.
struct SlackScale {
    int zero;  ///< x of slack 0
    double pixels_per_unit;

    int length(double slack) const {
        if (slack == 0) return 0;
        // What is too short to see still has a side.
        return std::max(2, static_cast<int>(std::lround(std::abs(slack) * pixels_per_unit)));
    }
};

SlackScale slack_scale(const OverlapSteps& steps, const PixelRect& area) {
    double low = 0, high = 0;
    for (const OverlapStep& step : steps.steps) {
        low = std::max(low, -step.slack);
        high = std::max(high, step.slack);
    }
    const double least_share = 0.2, share = low + high > 0 ? low / (low + high) : 0.5;
    const int zero =
        area.x +
        static_cast<int>(std::lround(area.width * std::clamp(share, least_share, 1 - least_share)));
    return {zero, std::min(low > 0 ? (zero - area.x) / low : HUGE_VAL,
                           high > 0 ? (area.x + area.width - zero) / high : HUGE_VAL)};
}

TextStyle aligned_right(TextStyle style) {
    style.align = Align::right;
    return style;
}

}  // namespace

int slack_line(int unit) { return small_size(unit) * 5 / 4; }

int slack_chart_lines(const OverlapSteps& steps) {
    return 1 + static_cast<int>(steps.steps.size());
}

void draw_slack_chart(Overlay& overlay, const PixelRect& rect, const SlackChart& chart,
                      const Theme& theme, int unit) {
    const int small = small_size(unit), line = slack_line(unit), gap = unit / 2;
    const TextStyle name{small, FontWeight::regular, theme.text};
    const TextStyle strong{small, FontWeight::bold, theme.text};
    const TextStyle faint{small, FontWeight::regular, theme.faint_text};
    const int swatch = small * 4 / 5, indent = swatch + small / 2;
    const auto widest = [&](const std::vector<Row>& rows, std::string Row::*part) {
        int width = 0;
        for (const Row& row : rows)
            for (const TextStyle& style : {name, strong})
                width = std::max(width, overlay.measure(row.*part, style).width);
        return width;
    };
    std::vector<Row> rows = rows_of(*chart.steps, true);
    const int numbers = std::max(widest(rows, &Row::number), overlay.measure("slack", faint).width),
              notes = widest(rows, &Row::note);
    const int least = 6 * unit, fixed = indent + numbers + notes + 3 * gap;
    int names = widest(rows, &Row::name);
    if (fixed + names + least > rect.width) {
        rows = rows_of(*chart.steps, false);
        names = std::min(widest(rows, &Row::name), std::max(0, rect.width - fixed - least / 2));
    }
    const PixelRect area = {rect.x + indent + names + gap, rect.y + line,
                            rect.width - fixed - names, rect.height - line};
    if (area.width < 2 * unit || area.height < line) return;
    keep_rows(rows, static_cast<std::size_t>(area.height / line), chart.steps->closest());

    const SlackScale scale = slack_scale(*chart.steps, area);
    const bool has_lines = std::any_of(chart.steps->steps.begin(), chart.steps->steps.end(),
                                       [](const OverlapStep& step) { return step.line > 0; });
    const int zero = scale.zero, number_x = area.x + area.width + gap + numbers,
              room = zero - 2 * gap - overlay.measure("short", faint).width - rect.x;
    overlay.text(
        rect.x, rect.y,
        fitted_text(overlay, has_lines ? "line, separates if" : "separates if", faint, room),
        faint);
    overlay.text(zero - gap, rect.y, "short", aligned_right(faint));
    overlay.text(zero + gap, rect.y, "apart", faint);
    overlay.text(number_x, rect.y, "slack", aligned_right(faint));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        const int y = area.y + static_cast<int>(i) * line;
        const TextStyle& style = row.shown ? strong : row.faint ? faint : name;
        const bool is_step = !row.number.empty();
        const OverlapStep& step = chart.steps->steps[is_step ? row.step : 0];
        if (is_step)
            overlay.rectangle({rect.x, y + (small - swatch) / 2 + 1, swatch, swatch},
                              ending_color(step.stage, theme));
        overlay.text(rect.x + indent, y, fitted_text(overlay, row.name, style, names), style);
        if (!is_step) continue;
        const Rgba8 color = with_opacity(step.separates ? chart.separating : theme.faint_text,
                                         row.faint        ? 0.35
                                         : step.separates ? 1
                                                          : 0.7);
        const int length = scale.length(step.slack);
        overlay.rectangle({step.slack > 0 ? zero : zero - length, y + 1, length, small - 1}, color);
        overlay.text(number_x, y, row.number, aligned_right(style));
        overlay.text(number_x + gap, y, row.note, style);
    }
    overlay.rectangle({zero, area.y, std::max(1, unit / 20),
                       std::min(area.height, static_cast<int>(rows.size()) * line)},
                      theme.text);
}

}  // namespace scb::render
