#include "render/figures/inspect_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text_format.h"
#include "render/overlay/figure_layout.h"
#include "render/overlay/side_panel.h"
#include "render/plots/ending_colors.h"
#include "render/plots/stacked_bars_plot.h"

namespace scb::render {
namespace {

constexpr PassReason reasons[] = {PassReason::triangles_meet, PassReason::loose_fit,
                                  PassReason::weak_test};

/// Not wasted, wasted by the fit, wasted by the test: as `reasons`.
using Split = std::array<std::uint64_t, std::size(reasons)>;

Split split_of(std::uint64_t all, std::uint64_t wasted, std::uint64_t by_tests) {
    return {all - wasted, wasted - by_tests, by_tests};
}

Split split_of(const PassCounts& counts) {
    return split_of(counts.all.volume_tests, counts.wasted.volume_tests,
                    counts.wasted_by_tests.volume_tests);
}

StackedBarsPlot empty_plot(const char* title, const char* x_label, const Theme& theme) {
    StackedBarsPlot plot;
    plot.title = title;
    plot.y_label = "volume tests";
    plot.x_label = x_label;
    for (const PassReason reason : reasons) plot.colors.push_back(pass_reason_color(reason, theme));
    return plot;
}

void add(StackedBarsPlot& plot, int number, const Split& split) {
    plot.numbers.push_back(number);
    plot.amounts.emplace_back(split.begin(), split.end());
}

StackedBarsPlot frames_plot(const InspectFigure& figure) {
    StackedBarsPlot plot = empty_plot("by frame", "frame", *figure.theme);
    std::vector<const InspectedFrame*> frames;
    for (const InspectedFrame& frame : figure.frames) frames.push_back(&frame);
    std::sort(frames.begin(), frames.end(),
              [](const auto* x, const auto* y) { return x->frame < y->frame; });
    for (const InspectedFrame* frame : frames)
        add(plot, frame->frame, split_of(frame->found.counts));
    return plot;
}

StackedBarsPlot depths_plot(const InspectFigure& figure) {
    StackedBarsPlot plot =
        empty_plot("by depth", "depth of the pair: of both nodes together", *figure.theme);
    for (std::size_t d = 0; d < figure.sum.depths.size(); ++d) {
        const DepthInspection& at = figure.sum.depths[d];
        add(plot, static_cast<int>(d), split_of(at.tests, at.wasted, at.wasted_by_tests));
    }
    return plot;
}

void add_legend(std::vector<PanelItem>& items, const std::array<const char*, 3>& words,
                const Split& split, const Theme& theme) {
    const std::uint64_t all = split[0] + split[1] + split[2];
    for (std::size_t r = 0; r < split.size(); ++r)
        items.emplace_back(
            PanelLegendRow{pass_reason_color(reasons[r], theme), words[r], count_text(split[r]),
                           share_text(static_cast<double>(split[r]), static_cast<double>(all))});
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
    add_legend(items, {"not wasted", "fit too loose", "test too weak"}, split_of(counts),
               *figure.theme);
    items.emplace_back(PanelHeading{"pairs that passed"});
    add_legend(items, {"true contact", "fit too loose", "test too weak"},
               {counts.passed(reasons[0]), counts.passed(reasons[1]), counts.passed(reasons[2])},
               *figure.theme);
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
            break;
    }
    return theme.accent;
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
