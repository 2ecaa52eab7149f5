#include "render/figures/rejections_figure.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/geometry/surface.h"
#include "render/figures/contact_areas.h"
#include "render/figures/pairs_figure.h"
#include "render/plots/ending_colors.h"
#include "scb/triangle_overlap.h"

namespace scb::render {
namespace {

/// The ending that a node's color tells, or its most frequent one where that tells a share.
Stage shown_ending(const EndedPaths& node, NodeColor by) {
    return by == NodeColor::first ? node.first : by == NodeColor::last ? node.last : node.dominant;
}

Rgba8 color_of(const EndedPaths& node, NodeColor by, const Theme& theme) {
    if (by == NodeColor::share) return viridis(static_cast<double>(node.rejected) / node.tested);
    return ending_color(shown_ending(node, by), theme);
}

double area_of(const QueryBody& body, std::uint32_t triangle) {
    const TriangleCorners at = corners(*body.mesh, triangle);
    return triangle_moments(at[0], at[1], at[2]).area;
}

/// The triangles of a leaf at which paths ended with a test of triangles, if they have an area;
/// none for a node whose volume ended the paths.
std::vector<std::uint32_t> tested_triangles(const QueryBody& body, const EndedPaths& node,
                                            NodeColor by) {
    std::vector<std::uint32_t> triangles;
    const Stage ending = shown_ending(node, by);
    if (body.tree->is_leaf(node.node) &&
        (ending == Stage::triangles_apart || ending == Stage::triangles_meet))
        for (const std::uint32_t triangle : body.tree->items(node.node))
            if (triangle < body.mesh->triangles.size() && area_of(body, triangle) > 0)
                triangles.push_back(triangle);
    return triangles;
}

/// Pairs that are left over may contain much of the front, and would hide it.
double opacity_of(Rgba8 color, const RejectionsStyle& style) {
    return color == ending_color(Stage::left_over, *style.theme) ? style.opacity / 5
                                                                 : style.opacity;
}

/// The area that a node may hide: the square about its volume; for triangles that are drawn
/// instead, between that and the small area of slivers. 0 if there is no volume.
double hidden_area(const QueryBody& body, const EndedPaths& node, NodeColor by) {
    if (!body.tree->has_volume(node.node)) return 0;
    const double side =
        std::visit([](const auto& v) { return diameter(v); }, volume_of(body, node.node));
    double area = 0;
    for (const std::uint32_t triangle : tested_triangles(body, node, by))
        area += area_of(body, triangle);
    return area > 0 ? side * std::sqrt(2 * area) : side * side;
}

/// Leaves out nodes that are large for the number of their paths: see RejectionsStyle::focus.
void leave_out_large(EndedNodes& ended, const QueryBodies& bodies, const RejectionsStyle& style) {
    struct Volume {
        double paths_per_area;
        std::size_t side, index;
    };
    std::vector<Volume> volumes;
    double left = 0;  // paths that may still be left out
    for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t i = 0; i < ended[side].size(); ++i) {
            const double size = hidden_area(bodies[side], ended[side][i], style.by);
            // A point hides nothing.
            volumes.push_back({ended[side][i].tests / std::max(size, 1e-300), side, i});
            left += (1 - style.focus) * ended[side][i].tests;
        }
    std::stable_sort(volumes.begin(), volumes.end(), [](const Volume& x, const Volume& y) {
        return x.paths_per_area < y.paths_per_area;
    });
    std::array<std::vector<char>, 2> out = {std::vector<char>(ended[0].size()),
                                            std::vector<char>(ended[1].size())};
    for (const Volume& volume : volumes) {
        left -= ended[volume.side][volume.index].tests;
        if (left < 0) break;
        out[volume.side][volume.index] = 1;
    }
    for (std::size_t side = 0; side < 2; ++side) {
        std::vector<EndedPaths> kept;
        for (std::size_t i = 0; i < ended[side].size(); ++i)
            if (!out[side][i]) kept.push_back(ended[side][i]);
        ended[side] = std::move(kept);
    }
}

bool is_shown(Stage ending, const RejectionsStyle& style) {
    const std::vector<Stage>& endings = style.filter.endings;
    return endings.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// Faint meshes in the background.
constexpr double backdrop_dim = 0.5;

Rgba8 backdrop_color(std::size_t side, const Theme& theme) {
    return mix(dimmed_body_color(side, theme), theme.background, backdrop_dim);
}

std::string volumes_text(std::size_t side, const std::string& name) {
    const std::string letter = side == 0 ? "A" : "B";
    // Long names are cut at their ends.
    return letter + (side == 1 ? ", hatched" : "") + (name == letter ? "" : ": " + name);
}

/// Per triangle, whether paths that pass the filter ended at its leaf because triangles met there.
std::vector<char> meeting_triangles(const QueryBody& body, const QueryTrace& frame,
                                    const Outcomes& outcomes, std::size_t side,
                                    const EndedPathsFilter& filter) {
    std::vector<char> meet(body.mesh->triangles.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        if (outcomes[i] != Stage::triangles_meet) continue;
        const Step& test = frame.steps.volumes[i];
        const int depth = side == 0 ? test.depth_a : test.depth_b;
        if (depth < filter.least_depth || depth > filter.most_depth) continue;
        for (const std::uint32_t triangle :
             body.tree->items(side == 0 ? test.nodes.a : test.nodes.b))
            if (triangle < meet.size()) meet[triangle] = 1;
    }
    return meet;
}

/// Draws where triangles meet, in front of everything: lines, and areas where they lie on each
/// other, since bodies have equal depths there. Found pairs are the rarest ending and the most
/// interesting one, but most of these triangles are more often apart from others.
void add_meetings(Pane& pane, const QueryBodies& bodies, const QueryTrace& frame,
                  const Outcomes& outcomes, std::vector<Segment> contact,
                  const RejectionsStyle& style) {
    if (style.by == NodeColor::share || !is_shown(Stage::triangles_meet, style)) return;
    std::array<std::vector<char>, 2> shown;
    for (std::size_t side = 0; side < 2; ++side)
        if (style.sides[side])
            shown[side] = meeting_triangles(bodies[side], frame, outcomes, side, style.filter);
    const auto is_shown_of = [&](std::size_t side, std::uint32_t triangle) {
        return triangle < shown[side].size() && shown[side][triangle] != 0;
    };
    const Rgba8 color = ending_color(Stage::triangles_meet, *style.theme);
    for (Segment& line : contact) {
        const IndexPair pair = frame.found.pairs[line.id];
        const bool of_a = is_shown_of(0, pair.a);
        if (!of_a && !is_shown_of(1, pair.b)) continue;
        line.id =
            of_a ? bodies[0].first_triangle_id + pair.a : bodies[1].first_triangle_id + pair.b;
        line.color = color;
        line.width = 1.5;
        line.on_top = true;
        pane.segments.push_back(line);
    }
    // Without lines there is no area, whose outline is among them.
    if (pane.segments.empty()) return;
    for (Area& area : contact_areas(bodies, frame)) {
        const IndexPair pair = frame.found.pairs[area.id];
        if (!is_shown_of(0, pair.a) && !is_shown_of(1, pair.b)) continue;
        area.color = color;
        area.id = 0;
        pane.areas.push_back(std::move(area));
    }
}

}  // namespace

EndedNodes ended_nodes(const QueryBodies& bodies, const QueryTrace& frame, const Outcomes& outcomes,
                       const RejectionsStyle& style) {
    EndedNodes ended;
    for (std::size_t side = 0; side < 2; ++side) {
        if (!style.sides[side]) continue;
        ended[side] = ended_paths(frame, outcomes, side, style.filter);
        if (!style.nested) ended[side] = innermost(ended[side], bodies[side].tree->shape());
    }
    if (style.focus < 1) leave_out_large(ended, bodies, style);
    return ended;
}

Pane rejections_pane(const QueryBodies& bodies, const QueryTrace& frame, const Outcomes& outcomes,
                     const EndedNodes& ended, std::vector<Segment> contact,
                     const RejectionsStyle& style) {
    Pane pane;
    for (std::size_t side = 0; side < 2; ++side) {
        MeshDraw tested = marked_triangles(bodies[side], {}, style.theme->mesh);
        tested.hatched = side == 1;
        for (const EndedPaths& node : ended[side]) {
            const Rgba8 color = color_of(node, style.by, *style.theme);
            const std::vector<std::uint32_t> triangles =
                tested_triangles(bodies[side], node, style.by);
            for (const std::uint32_t triangle : triangles) {
                tested.triangle_colors.resize(bodies[side].mesh->triangles.size());
                tested.triangle_colors[triangle] = color;
                tested.chosen->push_back(triangle);
            }
            if (!triangles.empty() || !bodies[side].tree->has_volume(node.node)) continue;
            pane.volumes.push_back({volume_of(bodies[side], node.node),
                                    with_opacity(color, opacity_of(color, style)),
                                    bodies[side].first_node_id + node.node, side == 1});
        }
        if (tested.chosen->empty()) continue;
        std::sort(tested.chosen->begin(), tested.chosen->end());
        pane.meshes.push_back(std::move(tested));
    }
    for (std::size_t side = 0; side < 2; ++side) {
        MeshDraw mesh = mesh_draw(bodies[side], dimmed_body_color(side, *style.theme));
        mesh.first_id = 0;
        mesh.dim = backdrop_dim;
        mesh.backdrop = true;
        pane.meshes.push_back(std::move(mesh));
    }
    add_meetings(pane, bodies, frame, outcomes, std::move(contact), style);
    return pane;
}

bool shows_no_node(const Pane& pane) {
    return pane.volumes.empty() && std::all_of(pane.meshes.begin(), pane.meshes.end(),
                                               [](const MeshDraw& mesh) { return mesh.backdrop; });
}

std::vector<PanelItem> node_color_keys(const RejectionsStyle& style) {
    std::vector<PanelItem> keys;
    if (style.by == NodeColor::share)
        keys.emplace_back(PanelScale{"color: share of a node's tests rejected",
                                     {{0, "0"}, {0.5, "50 %"}, {1, "100 %"}}});
    // Options and their values stay together; if there is little room, the last is left out.
    if (style.focus < 1)
        keys.emplace_back(PanelNote{"large nodes left out; --focus\u00a01 shows all"});
    if (style.by == NodeColor::share) return keys;
    const std::string which =
        style.by == NodeColor::dominant ? "most frequent" : std::string(node_color_names[style.by]);
    keys.emplace_back(PanelNote{"colors: a node's " + which + " ending; lines: triangles meet"});
    return keys;
}

EndingCounts shown_counts(EndingCounts counts, const RejectionsStyle& style) {
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (!is_shown(static_cast<Stage>(i), style)) counts[i] = 0;
    return counts;
}

std::vector<EndingGroup> shown_groups(const TraceHeader& header, const RejectionsStyle& style) {
    std::vector<EndingGroup> groups = ending_groups(header, *style.theme);
    std::erase_if(groups, [&](const EndingGroup& group) {
        return std::none_of(group.endings.begin(), group.endings.end(),
                            [&](Stage ending) { return is_shown(ending, style); });
    });
    return groups;
}

std::vector<PanelItem> endings_legend(const TraceHeader& header, const Outcomes& outcomes,
                                      const RejectionsStyle& style) {
    const EndingCounts all = ending_counts(outcomes), counts = shown_counts(all, style);
    const auto ended =
        static_cast<double>(std::accumulate(all.begin(), all.end(), std::uint64_t{0}));
    std::vector<PanelItem> items;
    items.emplace_back(PanelHeading{"paths that ended"});
    if (style.by == NodeColor::share) {
        std::uint64_t rejected = 0, passed = 0;
        for (std::size_t i = 0; i < counts.size(); ++i)
            (is_rejection(static_cast<Stage>(i)) ? rejected : passed) += counts[i];
        for (const auto& [label, count] :
             {std::pair("rejected", rejected), std::pair("not rejected", passed)})
            items.emplace_back(PanelRow{
                label, {count_text(count), share_text(static_cast<double>(count), ended)}});
        return items;
    }
    for (const EndingGroup& group : shown_groups(header, style)) {
        const std::uint64_t count = count_of(group, counts);
        if (count == 0 && group.endings.front() == Stage::left_over) continue;
        // What is left over is translucent.
        const double opacity = opacity_of(group.color, style);
        const Rgba8 color =
            opacity < 1 ? seen_color(group.color, opacity, *style.theme) : group.color;
        items.emplace_back(PanelLegendRow{color, std::string(group.label), count_text(count),
                                          share_text(static_cast<double>(count), ended)});
    }
    return items;
}

std::vector<PanelItem> drawn_keys(const QueryBodies& bodies, const EndedNodes& ended,
                                  const RejectionsStyle& style) {
    std::vector<PanelItem> items;
    for (std::size_t side = 0; side < 2; ++side)
        items.emplace_back(PanelLegendRow{
            backdrop_color(side, *style.theme), volumes_text(side, bodies[side].name),
            style.sides[side] ? count_text(ended[side].size()) : std::string("–"), "", side == 1});
    return items;
}

std::vector<PanelItem> rejections_panel(const QueryBodies& bodies, const TraceHeader& header,
                                        const QueryTrace& frame, const Outcomes& outcomes,
                                        const EndedNodes& ended, const RejectionsStyle& style) {
    const EndingCounts counts = ending_counts(outcomes);
    const std::uint64_t paths = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    std::vector<PanelItem> items;
    items.emplace_back(PanelRow{"pairs", {count_text(frame.found.pairs.size())}, {}, true});
    items.emplace_back(PanelRow{"N_v", {count_text(frame.found.n_v)}});
    items.emplace_back(PanelRow{"N_p", {count_text(frame.found.n_p)}});
    items.emplace_back(PanelRow{"passed on", {count_text(frame.found.n_v - paths)}});
    for (PanelItem& item : endings_legend(header, outcomes, style))
        items.push_back(std::move(item));
    if (const auto leaves = counts[static_cast<std::size_t>(Stage::triangles_apart)] +
                            counts[static_cast<std::size_t>(Stage::triangles_meet)];
        header.engine && leaves > 0 && frame.found.n_p > leaves)
        items.emplace_back(PanelNote{"triangles: pairs of leaves, which have several"});
    items.emplace_back(PanelHeading{"nodes drawn"});
    for (PanelItem& item : drawn_keys(bodies, ended, style)) items.push_back(std::move(item));
    for (PanelItem& key : node_color_keys(style)) items.push_back(std::move(key));
    return items;
}

PanelChart endings_chart(const TraceHeader& header, const QueryTrace& frame,
                         const Outcomes& outcomes, const RejectionsStyle& style) {
    PanelChart chart;
    chart.title = "by depth of the pair";
    const std::vector<EndingGroup> groups = shown_groups(header, style);
    for (const EndingCounts& of_depth : endings_by_depth(frame, outcomes)) {
        const EndingCounts counts = shown_counts(of_depth, style);
        std::vector<BarPart>& row = chart.rows.emplace_back();
        for (const EndingGroup& group : groups)
            row.push_back({style.by == NodeColor::share ? style.theme->mesh : group.color,
                           static_cast<double>(count_of(group, counts))});
    }
    return chart;
}

}  // namespace scb::render
