#include "render/figures/explain_figure.h"

#include <algorithm>

#include "render/figures/explain_verdict.h"
#include "render/overlay/figure_layout.h"
#include "render/plots/slack_chart.h"

namespace scb::render {
namespace {

/// An upper bound, since on average letters are at most half as wide as high.
int footnote_lines(const ExplainFigure& figure, int unit, int width) {
    std::size_t letters = 0;
    for (const std::string_view line : symbol_lines(figure.kind, figure.options))
        letters += line.size() + 1;
    const int wide = static_cast<int>(letters) * small_size(unit) / 2;
    return (wide + width - 1) / std::max(1, width);
}

}  // namespace

PixelRect ExplainLayout::view_box() const {
    const int caption = caption_height(), below = 2 * unit;
    return {view.x, view.y + caption, view.width, std::max(1, view.height - caption - below)};
}

ExplainLayout explain_layout(int width, int height, const ExplainFigure& figure, Overlay& overlay) {
    FigureLayout whole = figure_layout(width, height);
    whole.heading.height += second_heading_line(overlay, whole, figure.title, figure.subtitle);
    ExplainLayout layout;
    const int unit = layout.unit = whole.unit, margin = whole.heading.x, gap = unit;
    layout.heading = whole.heading;
    const int top = whole.heading.y + whole.heading.height;
    PixelRect all = {margin, top, width - 2 * margin, height - margin - top};
    const int footnote = (small_size(unit) * 5 / 4) * footnote_lines(figure, unit, all.width);
    if (footnote > 0 && footnote <= all.height / 12) {
        layout.footnote = {margin, height - margin - footnote, all.width, footnote};
        all.height -= footnote + unit / 2;
    }
    const int line = slack_line(unit), chart = slack_chart_lines(figure.found->steps) * line,
              verdict = (static_cast<int>(verdict_lines(figure).size()) + 1) * line;
    const int below = std::min(std::max(chart, verdict), all.height * 3 / 5);
    // Small pictures have no room for a section.
    const bool section = whole.portrait || all.height - std::max(chart, verdict) > 12 * unit;
    if (whole.portrait) {
        const int verdict_height = std::min(verdict, all.height / 5),
                  chart_height = std::min(chart, all.height / 3),
                  views = all.height - verdict_height - chart_height - 2 * gap;
        layout.view = {all.x, all.y, all.width, section ? (views - gap / 2) / 2 : views};
        if (section)
            layout.section = {all.x, all.y + views - layout.view.height, all.width,
                              layout.view.height};
        layout.steps = {all.x, all.y + views + gap, all.width, chart_height};
        layout.verdict = {all.x, all.y + all.height - verdict_height, all.width, verdict_height};
    } else if (!section) {
        const int column = std::min(all.width / 2, 26 * unit);
        layout.view = {all.x, all.y, all.width - column - gap, all.height};
        const int x = all.x + all.width - column,
                  chart_height = std::min(chart, all.height * 7 / 10);
        layout.steps = {x, all.y, column, chart_height};
        const int y = all.y + chart_height + gap;
        layout.verdict = {x, y, column, all.y + all.height - y};
    } else {
        const int views = all.height - below - gap / 2, half = (all.width - gap) / 2;
        layout.view = {all.x, all.y, half, views};
        layout.section = {all.x + all.width - half, all.y, half, views};
        const int right = std::min(all.width * 2 / 5, 20 * unit), y = all.y + all.height - below;
        layout.steps = {all.x, y, all.width - right - 3 * gap / 2, below};
        layout.verdict = {all.x + all.width - right, y, right, below};
    }
    return layout;
}

std::vector<std::string_view> symbol_lines(VolumeKind kind, const OverlapOptions& options) {
    switch (kind) {
        case VolumeKind::ball:
        case VolumeKind::ritter:
            return {};
        case VolumeKind::obb:
        case VolumeKind::aabb:
        case VolumeKind::aabb_exact:
            return {"a, b: the axes of the boxes; ρ: how far a box reaches along the axis."};
        case VolumeKind::scb2:
            return {
                "0: of A; 1: of B; ″: of the second slab; d: of the other center, along the normal "
                "n;",
                "ρ: how far a volume reaches in a direction; u: from A's center to B's; w: the "
                "product "
                "of the long axes; sλ: the sine of their angle."};
        case VolumeKind::scb:
            break;
        default:
            return {
                "ρ: how far a volume reaches in a direction; u: from A's center to B's; w: a "
                "direction that the search for the closest points tried."};
    }
    switch (options.test) {
        case OverlapTest::symmetric:
            return {
                "m, h: middle of a slab and half its thickness, so e = m + h, f = m − h; r·sα: "
                "effective radius of the cylinder about the slab cut ball; sα is rounded up."};
        case OverlapTest::extents:
            return {
                "ρ: how far a slab cut ball reaches in that direction; u: the direction from A's "
                "center to B's."};
        default:
            return {
                "r·sα: effective radius of the cylinder about the slab cut ball; sα is rounded "
                "up."};
    }
}

}  // namespace scb::render
