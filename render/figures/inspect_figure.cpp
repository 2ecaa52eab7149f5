#include "render/figures/inspect_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text_format.h"
#include "render/figures/reason_words.h"
#include "render/overlay/figure_layout.h"
#include "render/overlay/side_panel.h"
#include "render/plots/ending_colors.h"
#include "render/plots/stacked_bars_plot.h"

namespace scb::render {
namespace {

std::vector<ReasonWords> parts_of(const InspectFigure& figure) {
    return reason_words(figure.kind, figure.sum.counts);
}

StackedBarsPlot empty_plot(const char* title, const char* x_label, const InspectFigure& figure) {
    StackedBarsPlot plot;
    plot.title = title;
    plot.y_label = "volume tests";
    plot.x_label = x_label;
    for (const ReasonWords& part : parts_of(figure))
        plot.colors.push_back(pass_reason_color(part.reason, *figure.theme));
    return plot;
}

/// Adds a bar. `wasted_by` gives the wasted tests by their reason.
template <class WastedBy>
void add(StackedBarsPlot& plot, int number, const InspectFigure& figure, std::uint64_t useful,
         const WastedBy& wasted_by) {
    plot.numbers.push_back(number);
    auto& amounts = plot.amounts.emplace_back();
    for (const ReasonWords& part : parts_of(figure))
        amounts.push_back(static_cast<double>(
            part.reason == PassReason::triangles_meet ? useful : wasted_by(part.reason)));
}

StackedBarsPlot frames_plot(const InspectFigure& figure) {
    StackedBarsPlot plot = empty_plot("by frame", "frame", figure);
    std::vector<const InspectedFrame*> frames;
    for (const InspectedFrame& frame : figure.frames) frames.push_back(&frame);
    std::sort(frames.begin(), frames.end(),
              [](const auto* x, const auto* y) { return x->frame < y->frame; });
    for (const InspectedFrame* frame : frames) {
        const PassCounts& counts = frame->found.counts;
        add(plot, frame->frame, figure, counts.all.volume_tests - counts.wasted().volume_tests,
            [&counts](PassReason reason) { return counts.wasted_by(reason).volume_tests; });
    }
    return plot;
}

StackedBarsPlot depths_plot(const InspectFigure& figure) {
    StackedBarsPlot plot =
        empty_plot("by depth", "depth of the pair: of both nodes together", figure);
    for (std::size_t d = 0; d < figure.sum.depths.size(); ++d) {
        const DepthInspection& at = figure.sum.depths[d];
        add(plot, static_cast<int>(d), figure, at.tests - at.wasted.all(),
            [&at](PassReason reason) { return at.wasted.by(reason); });
    }
    return plot;
}

struct LegendEntry {
    PassReason reason{};
    const char* words = "";
    std::uint64_t count = 0;
};

void add_legend(std::vector<PanelItem>& items, const std::vector<LegendEntry>& entries,
                const Theme& theme) {
    std::uint64_t all = 0;
    for (const LegendEntry& entry : entries) all += entry.count;
    for (const LegendEntry& entry : entries)
        items.emplace_back(PanelLegendRow{
            pass_reason_color(entry.reason, theme), entry.words, count_text(entry.count),
            share_text(static_cast<double>(entry.count), static_cast<double>(all))});
    items.emplace_back(PanelRow{"all", {count_text(all)}, {}, true});
}

void add_changes_heading(std::vector<PanelItem>& items, const char* words) {
    items.emplace_back(PanelHeading{words});
    items.emplace_back(PanelRow{"", {"tests", "cost"}});
}

void add_changes(std::vector<PanelItem>& items, const std::string& name, const Work& from,
                 const Work& to, bool best = false) {
    items.emplace_back(PanelRow{name,
                                {change_text(from.volume_tests, to.volume_tests),
                                 change_text(from.picoseconds, to.picoseconds)},
                                {},
                                best});
}

/// Beside two numbers there is no room for "corrected", and thresholds identify these.
std::string short_title(const OverlapOptions& options) {
    const std::string title = overlap_title(options), name = "corrected ";
    return title.starts_with(name) ? "corr. " + title.substr(name.size()) : title;
}

std::vector<PanelItem> panel_of(const InspectFigure& figure) {
    const PassCounts& counts = figure.sum.counts;
    std::vector<PanelItem> items;
    // First, since a small picture's panel ends early.
    if (counts.wrongly_rejected > 0) {
        const Rgba8 alarm = figure.theme->warning;
        items.emplace_back(PanelHeading{"REJECTED WRONGLY"});
        items.emplace_back(PanelLegendRow{alarm, "pairs", count_text(counts.wrongly_rejected), ""});
        items.emplace_back(PanelLegendRow{alarm, "contacts missed", count_text(counts.missed), ""});
    }
    items.emplace_back(PanelHeading{"volume tests"});
    std::vector<LegendEntry> tests, passed;
    for (const ReasonWords& part : parts_of(figure)) {
        const bool is_useful = part.reason == PassReason::triangles_meet;
        tests.push_back({part.reason, is_useful ? "not wasted" : part.title,
                         is_useful ? counts.all.volume_tests - counts.wasted().volume_tests
                                   : counts.wasted_by(part.reason).volume_tests});
        passed.push_back({part.reason, part.title, counts.passed(part.reason)});
    }
    add_legend(items, tests, *figure.theme);
    items.emplace_back(PanelHeading{"pairs that passed"});
    add_legend(items, passed, *figure.theme);
    if (!figure.settings.empty()) {
        add_changes_heading(items, "what would have helped");
        for (const InspectedSetting& setting : figure.settings)
            add_changes(items, setting.name, figure.settings_from, setting.counts,
                        setting.recommended);
        items.emplace_back(PanelNote{"bold: the best, " + figure.best});
        items.emplace_back(PanelNote{std::string("cost: ") + cost_words});
    }
    if (!figure.others.empty()) {
        add_changes_heading(items, "with another test");
        // The cheapest first, since the panel may end before the last.
        std::vector<AlternativeTest> others = figure.others;
        std::stable_sort(others.begin(), others.end(), [](const auto& x, const auto& y) {
            return x.all.picoseconds < y.all.picoseconds;
        });
        for (const AlternativeTest& other : others)
            add_changes(items, short_title(other.overlap), counts.all, other.all);
    }
    return items;
}

}  // namespace

Rgba8 pass_reason_color(PassReason reason, const Theme& theme) {
    switch (reason) {
        case PassReason::triangles_meet:
            return theme.mesh;
        case PassReason::loose_fit:
            return ending_color(Stage::triangles_apart, theme);
        case PassReason::weak_test:
            return theme.accent;
        case PassReason::early:
            return body_b_color;
        case PassReason::unjudged:
            break;
    }
    return mix(theme.mesh, theme.text, 0.5);
}

Rgba8 wrong_rejection_color(const Theme& theme) {
    return &theme == &light_theme ? Rgba8{180, 0, 60} : Rgba8{255, 122, 144};
}

std::string change_text(std::uint64_t from, std::uint64_t to) {
    if (from == 0) return "–";
    const double change = 100 * (static_cast<double>(to) / static_cast<double>(from) - 1);
    return (change < 0 ? "−" : "+") + format("%.1f %%", std::abs(change));
}

Picture compose(const InspectFigure& figure, int width, int height, Overlay& overlay) {
    const FigureLayout layout = figure_layout(width, height);
    const Theme& theme = *figure.theme;
    const FigureStyle style{theme, layout.unit};
    overlay.begin();
    draw_heading(overlay, layout, theme, figure.title, figure.subtitle);
    draw_side_panel(overlay, layout.panel, theme, layout.unit, panel_of(figure));
    PixelRect top = layout.view, bottom = layout.view;
    if (figure.frames.size() > 1) {
        top.height = bottom.height = (layout.view.height - layout.unit) / 2;
        bottom.y += layout.view.height - bottom.height;
        draw_stacked_bars_plot(overlay, top, frames_plot(figure), style);
    }
    draw_stacked_bars_plot(overlay, bottom, depths_plot(figure), style);
    return {width, height, 1, theme.background, {}};
}

}  // namespace scb::render
