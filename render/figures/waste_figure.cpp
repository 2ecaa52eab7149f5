#include "render/figures/waste_figure.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/triangle_heat.h"
#include "core/base/text_format.h"
#include "render/figures/distance_figure.h"
#include "render/figures/figure_words.h"
#include "scb/triangle_overlap.h"

namespace scb::render {
namespace {

/// Triangles with less than this part of the scale look like the rest of the body.
constexpr double least_colored = 0.04;
/// Triangles with at least this part of their body's most are those with the most waste.
constexpr double least_of_most = 0.2;
constexpr double hidden_waste_opacity = 0.5;

std::vector<std::uint32_t> triangles_from(const std::vector<double>& cost, double least) {
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t i = 0; i < cost.size(); ++i)
        if (cost[i] >= least && cost[i] > 0) triangles.push_back(i);
    return triangles;
}

std::vector<std::uint32_t> most_wasteful(const std::vector<double>& cost) {
    return triangles_from(
        cost, cost.empty() ? 0 : least_of_most * *std::max_element(cost.begin(), cost.end()));
}

/// The next number that is 1, 2 or 5 times a power of ten.
double round_end(double most) {
    if (!(most > 0)) return 0;
    double power = 1;
    while (power > most) power /= 10;
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= most) return step * power;
    return 10 * power;
}

std::size_t body_count(const Waste& waste) { return waste.cost[1].empty() ? 1 : 2; }

TriangleCorners in_world(const QueryBody& body, std::uint32_t triangle) {
    return transform_corners(body.pose, corners(*body.mesh, triangle));
}

std::string percent(double share) { return format("%.3g %%", 100 * share); }

}  // namespace

Waste waste_of(const QueryBodies& bodies, const TraceHeader& header, const QueryTrace& frame,
               const TestCosts& costs, std::vector<MarkedTriangle> marked) {
    Waste waste;
    const std::vector<bool> wasted = wasted_tests(frame.steps, outcomes_of(header, frame));
    for (std::size_t side = 0; side < 2; ++side)
        waste.cost[side] =
            wasted_cost(frame.steps, bodies[side].tree->shape(), side, wasted, costs);
    if (header.kind == QueryKind::self) {
        for (std::size_t i = 0; i < waste.cost[0].size(); ++i) waste.cost[0][i] += waste.cost[1][i];
        waste.cost[1].clear();
    }
    double most = 0;
    for (const std::vector<double>& of_body : waste.cost)
        for (const double cost : of_body) {
            waste.sum += cost;
            most = std::max(most, cost);
        }
    waste.scale_end = round_end(most);
    waste.marked = std::move(marked);
    return waste;
}

Pane waste_pane(const QueryBodies& bodies, const Waste& waste, const Theme& theme) {
    Pane pane;
    for (std::size_t side = 0; side < body_count(waste); ++side) {
        const QueryBody& body = bodies[side];
        MeshDraw colored = mesh_draw(body, {});
        colored.chosen = triangles_from(waste.cost[side], least_colored * waste.scale_end);
        for (const double cost : waste.cost[side])
            colored.triangle_colors.push_back(
                pale_to_red(waste.scale_end > 0 ? cost / waste.scale_end : 0));
        colored.shading = 0.3;  // readers compare the colors with a scale
        colored.shine_through = hidden_waste_opacity;
        // First, since the first of coinciding surfaces is visible.
        pane.meshes.push_back(std::move(colored));
        pane.meshes.push_back(mesh_draw(body, dimmed_body_color(side, theme)));
        pane.meshes.back().dim = 0.4;
    }
    for (const MarkedTriangle& marked : waste.marked) {
        const TriangleCorners at = in_world(bodies[marked.side], marked.triangle);
        for (std::size_t i = 0; i < 3; ++i)
            pane.segments.push_back(
                {at[i], at[(i + 1) % 3], theme.text, 0, 2.5, false, theme.text});
    }
    return pane;
}

Subject waste_subject(const QueryBodies& bodies, const Waste& waste) {
    Subject subject;
    subject.pane = waste_pane(bodies, waste, light_theme);
    subject.pane.segments.clear();
    const auto first_of_b = 1 + static_cast<std::uint32_t>(bodies[0].mesh->triangles.size());
    for (std::size_t side = 0; side < body_count(waste); ++side) {
        MeshDraw& most = subject.pane.meshes[2 * side];
        most.chosen = most_wasteful(waste.cost[side]);
        most.first_id = side == 0 ? 1 : first_of_b;
        most.shine_through = 0;
        subject.pane.meshes[2 * side + 1].first_id = 0;
    }
    subject.score = [first_of_b](const IdImage& ids) {
        std::uint64_t a = 0, b = 0;
        for (const std::uint32_t id : ids.ids) {
            a += id != 0 && id < first_of_b;
            b += id >= first_of_b;
        }
        return (1 + a) * (1 + b);
    };
    return subject;
}

std::vector<AnyVolume> waste_region(const QueryBodies& bodies, const Waste& waste) {
    std::vector<AnyVolume> region;
    for (std::size_t side = 0; side < body_count(waste); ++side)
        for (const std::uint32_t triangle : most_wasteful(waste.cost[side]))
            for (const Vec3& corner : in_world(bodies[side], triangle))
                region.emplace_back(Ball{corner, 0});
    return region;
}

std::vector<SceneLabel> waste_labels(const QueryBodies& bodies, const Waste& waste) {
    std::vector<SceneLabel> labels;
    for (const MarkedTriangle& marked : waste.marked) {
        const TriangleCorners at = in_world(bodies[marked.side], marked.triangle);
        labels.push_back({(at[0] + at[1] + at[2]) / 3, std::to_string(marked.triangle),
                          body_color(marked.side)});
    }
    return labels;
}

std::vector<PanelItem> waste_panel(const QueryBodies& bodies, const QueryTrace& frame,
                                   const Waste& waste, const Theme& theme) {
    std::vector<PanelItem> items;
    if (frame.nearest)
        items.emplace_back(
            PanelRow{"distance", {distance_text(frame.nearest->distance)}, {}, true});
    else
        items.emplace_back(PanelRow{"pairs", {count_text(frame.found.pairs.size())}, {}, true});
    items.emplace_back(PanelRow{"N_v", {count_text(frame.found.n_v)}});
    items.emplace_back(PanelRow{"N_p", {count_text(frame.found.n_p)}});
    items.emplace_back(PanelRow{"wasted cost", {share_text(waste.sum, 1)}, {}, true});
    items.emplace_back(PanelHeading{""});
    for (std::size_t side = 0; side < body_count(waste); ++side)
        items.emplace_back(PanelKey{dimmed_body_color(side, theme), "body " + bodies[side].name});
    if (!waste.marked.empty())
        items.emplace_back(PanelNote{"outlined: the " + std::to_string(waste.marked.size()) +
                                     " triangles in the most tests, with their numbers"});
    items.emplace_back(PanelHeading{""});
    if (waste.scale_end > 0)
        items.emplace_back(PanelScale{
            "wasted cost of a triangle",
            {{0, "0"}, {0.5, percent(waste.scale_end / 2)}, {0.95, percent(waste.scale_end)}},
            pale_to_red});
    items.emplace_back(
        PanelNote{"cost: assumed time; the triangles below a node share the cost of "
                  "its tests"});
    items.emplace_back(PanelNote{"pale: behind a body"});
    return items;
}

}  // namespace scb::render
