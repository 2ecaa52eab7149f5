#include "render/figures/rejections_figure.h"

#include <numeric>

#include "render/figures/body_names.h"
#include "render/plots/ending_colors.h"

namespace scb::render {
namespace {

Rgba8 color_of(const EndedPaths& node, NodeColor by, const Theme& theme) {
    switch (by) {
        case NodeColor::first:
            return ending_color(node.first, theme);
        case NodeColor::last:
            return ending_color(node.last, theme);
        case NodeColor::dominant:
            return ending_color(node.dominant, theme);
        case NodeColor::share:
            break;
    }
    return viridis(static_cast<double>(node.rejected) / node.tested);
}

/// What is left over may hold much of the front, and would hide it.
double opacity_of(Rgba8 color, const RejectionsStyle& style) {
    return color == ending_color(Outcome::left_over, *style.theme) ? style.opacity / 5
                                                                   : style.opacity;
}

}  // namespace

EndedNodes ended_nodes(const QueryBodies& bodies, const TraceFrame& frame,
                       const TraversalTree& tree, const RejectionsStyle& style) {
    EndedNodes ended;
    for (std::size_t side = 0; side < 2; ++side) {
        if (!style.sides[side]) continue;
        ended[side] = ended_paths(frame, tree, side, style.filter);
        if (!style.nested)
            ended[side] = innermost(ended[side], topology_of(*bodies[side].hierarchy));
    }
    return ended;
}

Pane rejections_pane(const QueryBodies& bodies, const EndedNodes& ended,
                     const RejectionsStyle& style) {
    Pane pane;
    for (std::size_t side = 0; side < 2; ++side)
        for (const EndedPaths& node : ended[side]) {
            const Rgba8 color = color_of(node, style.by, *style.theme);
            pane.volumes.push_back({volume_of(bodies[side], node.node),
                                    with_opacity(color, opacity_of(color, style)),
                                    bodies[side].first_node_id + node.node});
        }
    return pane;
}

PanelItem node_color_key(const RejectionsStyle& style) {
    if (style.by == NodeColor::share)
        return PanelScale{"color: share of a node's tests rejected",
                          {{0, "0"}, {0.5, "50 %"}, {1, "100 %"}}};
    return PanelNote{"a node's " +
                     std::string(style.by == NodeColor::dominant ? "most frequent"
                                                                 : node_color_names[style.by]) +
                     " ending" + (style.nested ? "" : "; those that hold others are left out")};
}

std::vector<PanelItem> endings_legend(const TraceHeader& header, const TraceFrame& frame,
                                      const TraversalTree& tree, const Theme& theme) {
    const EndingCounts counts = ending_counts(frame, tree);
    const auto ended =
        static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    std::vector<PanelItem> items;
    items.emplace_back(PanelHeading{"paths that ended"});
    for (const EndingGroup& group :
         ending_groups(endings_of(header.volume, header.options), theme)) {
        const std::uint64_t count = count_of(group, counts);
        if (count == 0 && group.endings.front() == Outcome::left_over) continue;
        items.emplace_back(PanelLegendRow{group.color, std::string(group.label), count_text(count),
                                          share_text(static_cast<double>(count), ended)});
    }
    return items;
}

std::vector<PanelItem> rejections_panel(const QueryBodies& bodies, const TraceHeader& header,
                                        const TraceFrame& frame, const TraversalTree& tree,
                                        const EndedNodes& ended, const RejectionsStyle& style) {
    const EndingCounts counts = ending_counts(frame, tree);
    const std::uint64_t paths = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    std::vector<PanelItem> items;
    items.emplace_back(PanelRow{"pairs", {count_text(frame.found.pairs.size())}, {}, true});
    items.emplace_back(PanelRow{"N_v", {count_text(frame.found.n_v)}});
    items.emplace_back(PanelRow{"N_p", {count_text(frame.found.n_p)}});
    items.emplace_back(PanelRow{"passed on", {count_text(frame.found.n_v - paths)}});
    for (PanelItem& item : endings_legend(header, frame, tree, *style.theme))
        items.push_back(std::move(item));
    items.emplace_back(PanelHeading{""});
    const std::vector<std::string> names =
        column_names(items, {bodies[0].name, bodies[1].name}, true);
    for (std::size_t side = 0; side < 2; ++side)
        items.emplace_back(
            PanelRow{"volumes of " + names[side],
                     {style.sides[side] ? count_text(ended[side].size()) : std::string("–")}});
    items.push_back(node_color_key(style));
    return items;
}

PanelChart endings_chart(const TraceHeader& header, const TraceFrame& frame,
                         const TraversalTree& tree, const Theme& theme) {
    PanelChart chart;
    chart.title = "by depth of the pair";
    const std::vector<EndingGroup> groups =
        ending_groups(endings_of(header.volume, header.options), theme);
    for (const EndingCounts& counts : endings_by_depth(frame, tree)) {
        std::vector<BarPart>& row = chart.rows.emplace_back();
        for (const EndingGroup& group : groups)
            row.push_back({group.color, static_cast<double>(count_of(group, counts))});
    }
    return chart;
}

}  // namespace scb::render
