#include "render/figures/heat_figure.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/figures/distance_figure.h"
#include "render/figures/figure_words.h"
#include "render/plots/depth_matrix_plot.h"
#include "render/view/palette.h"

namespace scb::render {

Heat heat_of(const QueryBodies& bodies, const QueryTrace& frame, HeatOf of,
             std::optional<std::uint32_t> scale_end, const std::vector<bool>& wasted) {
    Heat heat;
    heat.of = of;
    heat.wasted = static_cast<std::uint64_t>(std::count(wasted.begin(), wasted.end(), true));
    for (std::size_t side = 0; side < 2; ++side) {
        heat.counts[side] =
            triangle_heat(frame.steps, bodies[side].tree->shape(), side, of, wasted);
        for (const std::uint32_t count : heat.counts[side]) heat.most = std::max(heat.most, count);
    }
    // The next number that is 1, 2 or 5 times a power of ten.
    double end = 10;
    for (int i = 0; end < heat.most; ++i) end *= i % 3 == 1 ? 2.5 : 2;
    constexpr int most_ticks = 6;
    heat.scale = log_axis(1, scale_end ? static_cast<double>(std::max(2u, *scale_end)) : end,
                          most_ticks, true);
    return heat;
}

Pane heat_pane(const QueryBodies& bodies, const Heat& heat) {
    Pane pane;
    for (std::size_t side = 0; side < 2; ++side) {
        MeshDraw mesh = mesh_draw(bodies[side], {});
        mesh.shading = 0.5;  // readers compare the colors with a scale
        for (const std::uint32_t count : heat.counts[side])
            mesh.triangle_colors.push_back(viridis(axis_position(heat.scale, count)));
        pane.meshes.push_back(std::move(mesh));
    }
    // Both bodies have the same colors, so an outline separates them where they meet.
    pane.outline = {std::vector<std::uint32_t>(heat.counts[1].size()), body_color(1), {0, 0, 0}, 2};
    std::iota(pane.outline.ids.begin(), pane.outline.ids.end(), bodies[1].first_triangle_id);
    return pane;
}

PanelItem heat_key(const Heat& heat) {
    PanelScale scale{heat.of == HeatOf::volumes     ? "volume tests of a triangle"
                     : heat.of == HeatOf::triangles ? "triangle tests of a triangle"
                                                    : "wasted tests of a triangle",
                     {}};
    // The end always has a label, and no other label is so near that they would touch.
    constexpr double nearest = 0.85;
    for (const AxisTick& tick : heat.scale.ticks)
        if (const double at = axis_position(heat.scale, tick.value);
            !tick.label.empty() && at < nearest)
            scale.ticks.emplace_back(at, tick.label);
    const auto end = static_cast<std::uint64_t>(std::llround(heat.scale.high));
    scale.ticks.emplace_back(1, short_count(end));
    return scale;
}

std::vector<PanelItem> heat_panel(const QueryBodies& bodies, const TraceHeader& header,
                                  const QueryTrace& frame, const Heat& heat) {
    std::vector<PanelItem> items;
    if (header.kind == QueryKind::distance)
        items.push_back(distance_row(frame));
    else
        items.emplace_back(PanelRow{"pairs", {count_text(frame.found.pairs.size())}, {}, true});
    items.emplace_back(PanelRow{"N_v", {count_text(frame.found.n_v)}});
    items.emplace_back(PanelRow{"N_p", {count_text(frame.found.n_p)}});
    if (heat.of == HeatOf::wasted)
        items.emplace_back(PanelRow{
            "wasted N_v",
            {count_text(heat.wasted) + ", " +
             share_text(static_cast<double>(heat.wasted), static_cast<double>(frame.found.n_v))}});
    items.emplace_back(PanelHeading{""});
    PanelRow body{"body", column_names(items, {bodies[0].name, bodies[1].name}), {}, true},
        most{"most tests", {}}, none{"triangles with 0", {}};
    for (std::size_t side = 0; side < 2; ++side) {
        const std::vector<std::uint32_t>& counts = heat.counts[side];
        most.values.push_back(
            count_text(counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end())));
        none.values.push_back(
            count_text(static_cast<std::uint64_t>(std::count(counts.begin(), counts.end(), 0u))));
    }
    const std::string name_of_b = body.values[1];
    items.emplace_back(std::move(body));
    items.emplace_back(std::move(most));
    items.emplace_back(std::move(none));
    items.emplace_back(PanelKey{body_color(1), "outlined: " + name_of_b});
    items.emplace_back(PanelHeading{""});
    items.push_back(heat_key(heat));
    items.emplace_back(PanelNote{
        heat.of == HeatOf::triangles ? "tests of the triangle against one of the other body"
        : heat.of == HeatOf::volumes ? "tests of volumes that hold the triangle"
        : is_of_distance(header.kind)
            ? "tests of volumes that hold the triangle, if no triangles as near as the answer are "
              "below the pair that led to the test"
            : "tests of volumes that hold the triangle, if no triangles meet below the pair that "
              "led to the test"});
    return items;
}

}  // namespace scb::render
