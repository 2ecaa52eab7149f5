#include "render/figures/pairs_figure.h"

#include <algorithm>
#include <optional>

#include "core/geometry/common_area.h"
#include "core/geometry/triangle_segment.h"
#include "render/figures/contact_areas.h"
#include "render/figures/distance_figure.h"
#include "render/figures/figure_words.h"
#include "render/figures/patch_labels.h"
#include "render/plots/ending_colors.h"
#include "scb/level_cover.h"
#include "scb/triangle_overlap.h"

namespace scb::render {
namespace {

/// The opacity of nodes at the level at which a query stopped.
constexpr double node_opacity = 0.3;
/// The opacity of leaves. Large leaves lie behind each other, in front of their triangles, so they
/// are fainter than usual ones.
constexpr double leaf_opacity = 0.25, least_leaf_opacity = 0.05;

/// The indices on one side of a list of pairs, ascending, each once.
std::vector<std::uint32_t> side_of(const std::vector<IndexPair>& pairs, std::size_t side) {
    std::vector<std::uint32_t> indices;
    for (const IndexPair& pair : pairs) indices.push_back(side == 0 ? pair.a : pair.b);
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

/// The leaves of one side that overlapped although their triangles are apart.
std::vector<std::uint32_t> apart_leaves(const TraceHeader& header, const QueryTrace& frame,
                                        std::size_t side) {
    std::vector<IndexPair> leaves;
    for (const ItemStep& test : frame.steps.items)
        if (!test.hit && !test.neighbors) leaves.push_back(frame.steps.volumes[test.step].nodes);
    return in_pairs(header, std::move(leaves), side);
}

void add_volumes(Pane& pane, const QueryBody& body, const std::vector<std::uint32_t>& nodes,
                 Rgba8 color) {
    for (const std::uint32_t node : nodes)
        if (body.tree->has_volume(node))
            pane.volumes.push_back({volume_of(body, node), color, body.first_node_id + node});
}

double leaf_size(const QueryBody& body, std::uint32_t node) {
    return body.tree->has_volume(node) ? body.tree->lengths(node).diameter : 0;
}

double usual_leaf_size(const QueryBody& body) {
    std::vector<double> sizes;
    for (const std::uint32_t leaf : level_cover(body.tree->shape(), leaf_level))
        sizes.push_back(leaf_size(body, leaf));
    if (sizes.empty()) return 0;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
}

void add_leaves(Pane& pane, const QueryBody& body, const std::vector<std::uint32_t>& leaves,
                Rgba8 color, bool hatched) {
    const double usual = usual_leaf_size(body);
    for (const std::uint32_t leaf : leaves) {
        if (!body.tree->has_volume(leaf)) continue;
        const double size = leaf_size(body, leaf), fainter = size > usual ? usual / size : 1;
        pane.volumes.push_back(
            {volume_of(body, leaf),
             with_opacity(color, std::max(leaf_opacity * fainter, least_leaf_opacity)),
             body.first_node_id + leaf, hatched});
    }
}

Rgba8 area_color() { return category_color(2); }

void add_leaves_keys(std::vector<PanelItem>& items, const QueryBodies& bodies,
                     const TraceHeader& header, const QueryTrace& frame, const PairsStyle& style) {
    if (!style.leaves) return;
    const Rgba8 color =
        seen_color(ending_color(Stage::triangles_apart, *style.theme), leaf_opacity, *style.theme);
    for (std::size_t side = 0; side < bodies_in(header); ++side)
        items.emplace_back(PanelLegendRow{
            color, std::string(side == 1 ? "hatched: " : "") + "leaves of " + bodies[side].name,
            count_text(apart_leaves(header, frame, side).size()), "", side == 1});
}

}  // namespace

std::size_t bodies_in(const TraceHeader& header) { return header.kind == QueryKind::self ? 1 : 2; }

std::vector<std::uint32_t> in_pairs(const TraceHeader& header, std::vector<IndexPair> pairs,
                                    std::size_t side) {
    if (header.kind != QueryKind::self) return side_of(pairs, side);
    for (std::size_t i = pairs.size(); i-- > 0;) pairs.push_back({pairs[i].b, pairs[i].a});
    return side_of(pairs, 0);
}

std::vector<Segment> contact_segments(const QueryBodies& bodies, const TraceHeader& header,
                                      const QueryTrace& frame) {
    if (pairs_are_nodes(header)) return {};
    if (is_of_distance(header.kind)) return distance_segments(bodies, frame);
    const std::vector<IndexPair>& pairs = frame.found.pairs;
    const auto meet = of_pairs<std::optional<LineSegment>>(bodies, frame, triangles_intersection);
    const std::vector<Area> areas = contact_areas(bodies, frame);
    std::vector<bool> in_area(pairs.size()), of_a(bodies[0].mesh->triangles.size()),
        of_b(bodies[1].mesh->triangles.size());
    for (const Area& area : areas)
        in_area[area.id] = of_a[pairs[area.id].a] = of_b[pairs[area.id].b] = true;
    // Triangles in one plane that only touch are neighbors of triangles that have an area there.
    const auto is_beside_area = [&](std::size_t i) {
        return of_a[pairs[i].a] && of_b[pairs[i].b] &&
               in_one_plane(corners(*bodies[0].mesh, pairs[i].a),
                            transform_corners(frame.b_to_a, corners(*bodies[1].mesh, pairs[i].b)));
    };
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (meet[i] && !in_area[i] && !is_beside_area(i))
            segments.push_back({transform_point(bodies[0].pose, meet[i]->a),
                                transform_point(bodies[0].pose, meet[i]->b), Rgba8{},
                                static_cast<std::uint32_t>(i)});
    for (Segment& outline : outlines_of(areas)) segments.push_back(std::move(outline));
    return segments;
}

Pane pairs_pane(const QueryBodies& bodies, const TraceHeader& header, const QueryTrace& frame,
                std::vector<Segment> contact, const PairsStyle& style,
                std::uint32_t first_pair_id) {
    Pane pane;
    for (std::size_t side = 0; side < bodies_in(header); ++side) {
        const QueryBody& body = bodies[side];
        // Before the whole mesh, since the first of coinciding surfaces is visible.
        if (!pairs_are_nodes(header)) {
            pane.meshes.push_back(marked_triangles(body, in_pairs(header, frame.found.pairs, side),
                                                   body_color(side)));
            pane.meshes.back().shine_through = hidden_opacity;
        }
        pane.meshes.push_back(mesh_draw(body, dimmed_body_color(side, *style.theme)));
        if (pairs_are_nodes(header))
            add_volumes(pane, body, in_pairs(header, frame.found.pairs, side),
                        with_opacity(body_color(side), node_opacity));
        else if (style.leaves)
            add_leaves(pane, body, apart_leaves(header, frame, side),
                       ending_color(Stage::triangles_apart, *style.theme), side == 1);
    }
    if (pairs_are_nodes(header)) return pane;
    if (!is_of_distance(header.kind)) pane.areas = contact_areas(bodies, frame);
    for (Area& area : pane.areas) {
        area.id += first_pair_id;
        area.color = area_color();
        area.shine_through = hidden_opacity;
    }
    pane.segments = std::move(contact);
    for (Segment& segment : pane.segments) {
        segment.id += first_pair_id;
        segment.color = style.theme->text;
        segment.hidden_color = style.theme->text;
        segment.width = 3;
    }
    return pane;
}

Subject contact_subject(const QueryBodies& bodies, const TraceHeader& header,
                        const QueryTrace& frame, std::vector<Segment> contact) {
    constexpr std::uint32_t of_contact = 1, of_a = 2;
    Subject subject;
    Pane& pane = subject.pane = pairs_pane(bodies, header, frame, std::move(contact), {}, 1);
    const auto first_of_b = of_a + static_cast<std::uint32_t>(bodies[0].mesh->triangles.size());
    int side = 0;
    for (MeshDraw& mesh : pane.meshes) {
        mesh.first_id = !mesh.chosen ? 0 : side++ == 0 ? of_a : first_of_b;
        mesh.shine_through = 0;
    }
    for (Area& area : pane.areas) area.shine_through = 0, area.id = of_contact;
    for (Segment& segment : pane.segments) segment.hidden_color.reset(), segment.id = of_contact;
    for (VolumeInstance& volume : pane.volumes) volume.id = of_contact;
    const bool both = side == 2;
    subject.score = [first_of_b, both](const IdImage& ids) {
        std::uint64_t contact_pixels = 0, a = 0, b = 0;
        for (const std::uint32_t id : ids.ids)
            if (id == of_contact)
                ++contact_pixels;
            else if (id >= first_of_b)
                ++b;
            else if (id >= of_a)
                ++a;
        return contact_pixels * (both ? 1 + std::min(a, b) : 1);
    };
    return subject;
}

std::vector<PanelItem> pairs_panel(const QueryBodies& bodies, const TraceHeader& header,
                                   const QueryTrace& frame, const PairsStyle& style,
                                   std::span<const ContactPatch> patches) {
    const Collision& found = frame.found;
    std::vector<PanelItem> items;
    const Theme& theme = *style.theme;
    const bool nodes = pairs_are_nodes(header);
    std::vector<std::string> body_names, counts, in_pairs_counts;
    std::vector<std::optional<Rgba8>> body_colors, shown;
    std::vector<ItemCount> item_counts;
    for (std::size_t side = 0; side < bodies_in(header); ++side) {
        body_names.push_back(bodies[side].name);
        body_colors.push_back(dimmed_body_color(side, theme));
        item_counts.push_back(item_count(*bodies[side].mesh, *bodies[side].tree));
        counts.push_back(count_text(item_counts.back().count));
        in_pairs_counts.push_back(count_text(in_pairs(header, frame.found.pairs, side).size()));
        shown.push_back(nodes ? seen_color(body_color(side), node_opacity, theme)
                              : body_color(side));
    }
    items.emplace_back(PanelRow{"body", column_names(items, body_names), body_colors, true});
    items.emplace_back(PanelRow{std::string(item_words(item_counts)), counts});
    items.emplace_back(PanelRow{nodes ? "nodes" : "in pairs", in_pairs_counts, shown});
    items.emplace_back(PanelHeading{""});
    items.emplace_back(PanelRow{"pairs", {count_text(found.pairs.size())}, {}, true});
    if (style.patches)
        for (PanelItem& row : patch_rows(patches)) items.push_back(std::move(row));
    items.emplace_back(PanelRow{"N_v", {count_text(found.n_v)}});
    items.emplace_back(PanelRow{"N_p", {count_text(found.n_p)}});
    if (!header.engine) items.emplace_back(PanelRow{"N_u", {count_text(found.n_u)}});
    items.emplace_back(PanelHeading{""});
    if (nodes) {
        items.emplace_back(PanelNote{
            header.engine ? std::string("volumes of the nodes whose objects were reported")
                          : "volumes of level " + std::to_string(header.options.stop_level) +
                                " that overlap"});
        return items;
    }
    items.emplace_back(PanelKey{theme.text, "where triangles meet"});
    if (const std::size_t areas = contact_areas(bodies, frame).size(); areas > 0)
        items.emplace_back(PanelLegendRow{area_color(), "triangles lie on each other",
                                          count_text(areas), "", false});
    add_leaves_keys(items, bodies, header, frame, style);
    items.emplace_back(PanelNote{"strong colors: triangles that intersect"});
    items.emplace_back(PanelNote{"dashed, or pale: behind a body"});
    if (style.leaves)
        items.emplace_back(PanelNote{"leaves: those that overlap while their triangles are apart"});
    return items;
}

std::vector<PanelItem> pairs_legend(const QueryBodies& bodies, const TraceHeader& header,
                                    const QueryTrace& frame, const PairsStyle& style) {
    std::vector<PanelItem> items;
    for (std::size_t side = 0; side < bodies_in(header); ++side)
        items.emplace_back(
            PanelKey{body_color(side),
                     (pairs_are_nodes(header) ? "body " : "in pairs: ") + bodies[side].name});
    if (pairs_are_nodes(header)) return items;
    items.emplace_back(PanelKey{style.theme->text, "where triangles meet"});
    if (!contact_areas(bodies, frame).empty())
        items.emplace_back(PanelKey{area_color(), "triangles lie on each other"});
    add_leaves_keys(items, bodies, header, frame, style);
    return items;
}

std::vector<AnyVolume> contact_region(const QueryBodies& bodies, const TraceHeader& header,
                                      const QueryTrace& frame, std::span<const Segment> contact) {
    std::vector<AnyVolume> region;
    for (const Segment& segment : contact)
        for (const Vec3& end : {segment.from, segment.to}) region.push_back(Ball{end, 0});
    if (!pairs_are_nodes(header)) return region;
    for (const IndexPair& pair : frame.found.pairs)
        for (std::size_t side = 0; side < 2; ++side)
            region.push_back(volume_of(bodies[side], side == 0 ? pair.a : pair.b));
    return region;
}

}  // namespace scb::render
