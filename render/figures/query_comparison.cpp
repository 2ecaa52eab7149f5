#include "render/figures/query_comparison.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "render/figures/contact_areas.h"
#include "render/figures/heat_figure.h"
#include "render/plots/ending_colors.h"

namespace scb::render {
namespace {

constexpr int number_rows = 7, scale_rows = 4;

/// "+432", "−17", "±0": an exact difference.
std::string difference_text(std::uint64_t from, std::uint64_t to) {
    if (from == to) return "±0";
    return to > from ? "+" + count_text(to - from) : "−" + count_text(from - to);
}

/// Whether equal numbers of nodes mean equal nodes with equal volumes in both.
bool nodes_comparable(const ComparedQueries& queries) {
    const TraceHeader &a = *queries[0].header, &b = *queries[1].header;
    return same_nodes(a, b) && (a.engine || a.volume == b.volume);
}

/// Adds the counts of both, the second's with the differences. `only_here`: pairs_of_one.
void add_numbers(std::array<ComparedView, 2>& views, const ComparedQueries& queries,
                 const PairsOfOne& only_here) {
    const auto counts = [&](std::size_t side) {
        const Collision& found = queries[side].frame->found;
        return std::array<std::uint64_t, 4>{found.pairs.size(), found.n_v, found.n_p, found.n_u};
    };
    const std::array<std::uint64_t, 4> first = counts(0), second = counts(1);
    constexpr std::array<const char*, 4> names = {"pairs", "N_v", "N_p", "N_u"};
    const bool counts_transforms = !queries[0].header->engine && !queries[1].header->engine;
    for (std::size_t i = 0; i < names.size() - (counts_transforms ? 0 : 1); ++i) {
        views[0].numbers.emplace_back(PanelRow{names[i], {count_text(first[i]), ""}, {}, i == 0});
        views[1].numbers.emplace_back(PanelRow{
            names[i], {count_text(second[i]), difference_text(first[i], second[i])}, {}, i == 0});
    }
    for (std::size_t side = 0; side < 2; ++side) {
        views[side].numbers.emplace_back(PanelRow{
            "only here", {count_text(only_here[side].size()), ""}, {}, !only_here[side].empty()});
        if (views[side].outlined)
            views[side].numbers.emplace_back(
                PanelRow{"outlined", {count_text(*views[side].outlined), ""}});
    }
}

/// Outlines the differences from this id on.
void outline(std::array<ComparedView, 2>& views, std::uint32_t first_id, const Theme& theme) {
    const std::size_t outlined = outline_differences(views, first_id, theme);
    for (ComparedView& view : views) view.outlined = outlined;
}

void explain_outlines(std::array<ComparedView, 2>& views) {
    for (ComparedView& view : views)
        if (view.outlined.value_or(0) > 0)
            view.numbers.emplace_back(PanelNote{"outlined: the views differ"});
}

/// Outlines nodes that differ, if these can be compared, and triangles that differ, and adds the
/// numbers.
void compare(std::array<ComparedView, 2>& views, const ComparedQueries& queries,
             const PairsOfOne& only_here, const Theme& theme) {
    const QueryBodies& bodies = queries[0].bodies;
    assert(bodies[0].first_triangle_id > bodies[1].first_node_id &&
           "ids of triangles follow ids of nodes");
    outline(views, nodes_comparable(queries) ? 1 : bodies[0].first_triangle_id, theme);
    add_numbers(views, queries, only_here);
}

/// Whether each color means the same in both.
bool agree(const std::vector<EndingGroup>& a, const std::vector<EndingGroup>& b) {
    return std::all_of(a.begin(), a.end(), [&](const EndingGroup& x) {
        return std::all_of(b.begin(), b.end(), [&](const EndingGroup& y) {
            return x.color != y.color || x.label == y.label;
        });
    });
}

/// The nodes shown in each view: if they can be compared, the nodes that either query would show.
std::array<EndedNodes, 2> compared_nodes(const ComparedQueries& queries,
                                         const std::array<Outcomes, 2>& trees,
                                         const RejectionsStyle& style) {
    std::array<EndedNodes, 2> shown;
    for (std::size_t i = 0; i < 2; ++i)
        shown[i] = ended_nodes(queries[i].bodies, *queries[i].frame, trees[i], style);
    if (style.focus == 1 || !nodes_comparable(queries)) return shown;
    RejectionsStyle unfocused = style;
    unfocused.focus = 1;
    std::array<EndedNodes, 2> both;
    for (std::size_t i = 0; i < 2; ++i) {
        both[i] = ended_nodes(queries[i].bodies, *queries[i].frame, trees[i], unfocused);
        for (std::size_t side = 0; side < 2; ++side)
            std::erase_if(both[i][side], [&](const EndedPaths& node) {
                return std::none_of(shown.begin(), shown.end(), [&](const EndedNodes& of_one) {
                    const auto at =
                        std::lower_bound(of_one[side].begin(), of_one[side].end(), node.node,
                                         [](const EndedPaths& other, std::uint32_t number) {
                                             return other.node < number;
                                         });
                    return at != of_one[side].end() && at->node == node.node;
                });
            });
    }
    return both;
}

/// Shows pairs that only one query found: in its own view their triangles, and hatched in the
/// other. A triangle is shown if it is in no pair of the other. Lines and areas of the pairs are in
/// both. `first_pair_id`: of the areas in the view of the query that found the pairs.
void show_pairs_of_one(std::array<ComparedView, 2>& views, const ComparedQueries& queries,
                       const PairsOfOne& only_here, std::size_t finder,
                       std::uint32_t first_pair_id) {
    const ComparedQuery& query = queries[finder];
    const std::vector<IndexPair>& pairs = only_here[finder];
    for (std::size_t body = 0; body < bodies_in(*query.header); ++body) {
        const std::vector<std::uint32_t> here = in_pairs(*query.header, pairs, body),
                                         there =
                                             in_pairs(*query.header,
                                                      queries[1 - finder].frame->found.pairs, body);
        std::vector<std::uint32_t> missed;
        std::set_difference(here.begin(), here.end(), there.begin(), there.end(),
                            std::back_inserter(missed));
        if (missed.empty()) continue;
        MeshDraw marked = marked_triangles(query.bodies[body], missed, changed_color);
        marked.shine_through = hidden_opacity;
        for (std::size_t side = 0; side < 2; ++side) {
            marked.hatched = side != finder;
            // Of coinciding surfaces, the first is visible.
            std::vector<MeshDraw>& meshes = views[side].pane.meshes;
            meshes.insert(meshes.begin(), marked);
        }
    }
    const auto is_of_one = [&](std::size_t pair) {
        return std::binary_search(pairs.begin(), pairs.end(), query.frame->found.pairs[pair]);
    };
    std::vector<Area> missed_areas;
    for (Area& area : views[finder].pane.areas) {
        if (area.id == 0 || !is_of_one(area.id - first_pair_id)) continue;
        area.color = changed_color;
        missed_areas.push_back(area);
        missed_areas.back().id = 0;
    }
    std::vector<Area>& others = views[1 - finder].pane.areas;
    others.insert(others.begin(), missed_areas.begin(), missed_areas.end());
    for (Segment segment : query.contact) {
        if (!is_of_one(segment.id)) continue;
        segment.id = 0;
        segment.color = changed_color;
        segment.width = 4;
        segment.on_top = true;
        for (ComparedView& view : views) view.pane.segments.push_back(segment);
    }
    const std::string count = count_text(pairs.size()),
                      noun = pairs.size() == 1 ? " pair" : " pairs";
    for (std::size_t side = 0; side < 2; ++side) {
        ComparedView& view = views[side];
        const bool found = side == finder;
        if (!view.remark.empty()) view.remark += ", ";
        view.remark += found ? count + noun + " only here" : count + noun + " missed here";
        view.legend.emplace_back(
            PanelLegendRow{changed_color, found ? "pairs only here" : "hatched: pairs missed here",
                           "", "", !found});
    }
}

}  // namespace

PairsOfOne pairs_of_one(const ComparedQueries& queries) {
    const std::vector<IndexPair>&a = queries[0].frame->found.pairs,
          &b = queries[1].frame->found.pairs;
    PairsOfOne result;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result[0]));
    std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(result[1]));
    return result;
}

std::array<ComparedView, 2> compared_pairs(const ComparedQueries& queries,
                                           const PairsOfOne& only_here, const PairsStyle& style,
                                           std::uint32_t first_pair_id) {
    std::array<ComparedView, 2> views;
    const std::array<std::uint32_t, 2> first_ids = {
        first_pair_id,
        first_pair_id + static_cast<std::uint32_t>(queries[0].frame->found.pairs.size())};
    for (std::size_t side = 0; side < 2; ++side) {
        const ComparedQuery& query = queries[side];
        views[side].pane = pairs_pane(query.bodies, *query.header, *query.frame, query.contact,
                                      style, first_ids[side]);
        views[side].legend = pairs_legend(query.bodies, *query.header, *query.frame, style);
    }
    compare(views, queries, only_here, *style.theme);
    explain_outlines(views);
    if (queries[0].header->options.stop_level >= 0) return views;
    if (pairs_are_nodes(*queries[0].header)) return views;
    for (std::size_t finder = 0; finder < 2; ++finder)
        if (!only_here[finder].empty())
            show_pairs_of_one(views, queries, only_here, finder, first_ids[finder]);
    return views;
}

std::array<ComparedView, 2> compared_rejections(const ComparedQueries& queries,
                                                const PairsOfOne& only_here,
                                                const RejectionsStyle& style) {
    std::array<ComparedView, 2> views;
    const std::array<Outcomes, 2> trees = {outcomes_of(*queries[0].header, *queries[0].frame),
                                           outcomes_of(*queries[1].header, *queries[1].frame)};
    const std::array<EndedNodes, 2> ended = compared_nodes(queries, trees, style);
    for (std::size_t side = 0; side < 2; ++side) {
        const ComparedQuery& query = queries[side];
        views[side].pane = rejections_pane(query.bodies, *query.frame, trees[side], ended[side],
                                           query.contact, style);
        views[side].legend = endings_legend(*query.header, trees[side], style);
        for (PanelItem& item : node_color_keys(style))
            views[side].legend.push_back(std::move(item));
    }
    if (style.by != NodeColor::share &&
        !agree(shown_groups(*queries[0].header, style), shown_groups(*queries[1].header, style)))
        for (ComparedView& view : views)
            insert_before_notes(view.legend, {"colors of this side: the other side's mean others"});
    // With different volumes, every node looks different.
    if (nodes_comparable(queries)) outline(views, 1, *style.theme);
    add_numbers(views, queries, only_here);
    for (std::size_t side = 0; side < 2; ++side)
        for (PanelItem& item : drawn_keys(queries[side].bodies, ended[side], style))
            views[side].numbers.push_back(std::move(item));
    explain_outlines(views);
    return views;
}

std::array<ComparedView, 2> compared_heat(const ComparedQueries& queries,
                                          const PairsOfOne& only_here, HeatOf of,
                                          std::optional<std::uint32_t> scale_end,
                                          const Theme& theme) {
    std::array<Heat, 2> heats;
    for (std::size_t side = 0; side < 2; ++side) {
        const QueryTrace& frame = *queries[side].frame;
        std::vector<bool> wasted;
        if (of == HeatOf::wasted)
            wasted = wasted_tests(frame.steps, outcomes_of(*queries[side].header, frame));
        heats[side] = heat_of(queries[side].bodies, frame, of, scale_end, wasted);
    }
    const std::size_t larger = heats[1].most > heats[0].most ? 1 : 0;
    heats[1 - larger].scale = heats[larger].scale;
    std::array<ComparedView, 2> views;
    for (std::size_t side = 0; side < 2; ++side) {
        views[side].pane = heat_pane(queries[side].bodies, heats[side]);
        views[side].legend = {heat_key(heats[side])};
    }
    compare(views, queries, only_here, theme);
    explain_outlines(views);
    return views;
}

ComparisonRows compared_pairs_rows(const PairsStyle& style) {
    return {number_rows, style.leaves ? 8 : 6};
}

ComparisonRows compared_rejections_rows(const TraceHeader& a, const TraceHeader& b,
                                        const RejectionsStyle& style) {
    std::size_t groups = 0;
    for (const TraceHeader* header : {&a, &b})
        groups =
            std::max(groups, style.by == NodeColor::share ? std::size_t{2}
                                                          : shown_groups(*header, style).size());
    // The heading has some distance.
    const int key = style.by == NodeColor::share ? scale_rows : 0;
    constexpr int bodies = 2, notes = 2;
    return {number_rows + bodies, static_cast<int>(groups) + 2 + key + notes};
}

ComparisonRows compared_heat_rows() { return {number_rows, scale_rows}; }

}  // namespace scb::render
