#include "render/figures/rejections_figure.h"

#include <gtest/gtest.h>

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/figures/pairs_figure.h"
#include "scb/triangle_overlap.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb::render {
namespace {

/// Two height fields that meet, and a query of them.
struct Query {
    BuiltMesh mesh{height_field(9)};
    TraceHeader header = asking(VolumeKind::scb, OverlapTest::symmetric);
    std::unique_ptr<Tree> tree_of_mesh =
        std::make_unique<Tree>(mesh.hierarchies[static_cast<std::size_t>(VolumeKind::scb)]);
    QueryTrace frame;
    Outcomes outcomes;
    QueryBodies bodies;

    Query() {
        Pose pose;
        pose.translation = Vec3(0.3, 0.11, 0.02);
        frame = record_frame(mesh, mesh, 0, pose, header);
        outcomes = outcomes_of(header, frame);
        for (QueryBody& body : bodies) {
            body.mesh = &mesh.mesh;
            body.tree = tree_of_mesh.get();
        }
        bodies[0].name = "A";
        bodies[1].name = "lid";
        bodies[1].pose = pose;
    }
    std::vector<Segment> contact() const { return contact_segments(bodies, header, frame); }
    const Topology& topology() const { return mesh.topology(); }
    bool at_triangle(const EndedPaths& node) const {
        return topology().nodes[node.node].is_leaf() && !is_rejection(node.dominant);
    }
    double paths_per_area(std::size_t side, const EndedPaths& node) const {
        const double size = std::visit([](const auto& v) { return diameter(v); },
                                       volume_of(bodies[side], node.node));
        if (!at_triangle(node)) return node.tests / (size * size);
        const auto at = corners(mesh.mesh, topology().order[topology().nodes[node.node].first]);
        return node.tests /
               (size * std::sqrt(std::sqrt(squared_norm(cross(at[1] - at[0], at[2] - at[0])))));
    }
};

TEST(RejectionsFigure, VolumesWithFewPathsForTheirSizeAreLeftOut) {
    const Query query;
    RejectionsStyle style;
    const EndedNodes all = ended_nodes(query.bodies, query.frame, query.outcomes, style);
    double paths = 0;
    for (const auto& side : all)
        for (const EndedPaths& node : side) paths += node.tests;
    for (const double focus : {0.9, 0.5, 0.1}) {
        style.focus = focus;
        const EndedNodes kept = ended_nodes(query.bodies, query.frame, query.outcomes, style);
        double least_kept = 1e99, most_left_out = 0, seen = 0;
        for (std::size_t side = 0; side < 2; ++side)
            for (const EndedPaths& node : all[side]) {
                const bool is_kept =
                    std::any_of(kept[side].begin(), kept[side].end(),
                                [&](const EndedPaths& other) { return other.node == node.node; });
                if (is_kept) {
                    least_kept = std::min(least_kept, query.paths_per_area(side, node));
                    seen += node.tests;
                } else {
                    most_left_out = std::max(most_left_out, query.paths_per_area(side, node));
                }
            }
        EXPECT_GE(least_kept, most_left_out);
        EXPECT_LT(kept[0].size() + kept[1].size(), all[0].size() + all[1].size());
        EXPECT_GE(seen, focus * paths - 1e-9);
        EXPECT_LT(seen, (focus + 0.1) * paths);
    }
}

TEST(RejectionsFigure, WhatMeetsIsAlwaysSeen) {
    const Query query;
    RejectionsStyle style;
    const auto lines = [&] {
        const EndedNodes ended = ended_nodes(query.bodies, query.frame, query.outcomes, style);
        return rejections_pane(query.bodies, query.frame, query.outcomes, ended, query.contact(),
                               style)
            .segments;
    };
    ASSERT_FALSE(query.frame.found.pairs.empty());
    // Also the lines of triangles that are left out.
    style.focus = 0.01;
    EXPECT_EQ(lines().size(), query.frame.found.pairs.size());
    for (const Segment& line : lines()) {
        EXPECT_EQ(line.color, ending_color(Stage::triangles_meet, light_theme));
        EXPECT_TRUE(line.on_top);
    }
    style.sides = {false, true};
    EXPECT_EQ(lines().size(), query.frame.found.pairs.size());
    style.filter.most_depth = 1;
    EXPECT_TRUE(lines().empty());
    style.filter = {};
    style.filter.endings = {Stage::triangles_apart};
    EXPECT_TRUE(lines().empty());
    style.filter = {};
    style.by = NodeColor::share;
    EXPECT_TRUE(lines().empty());
}

TEST(RejectionsFigure, BodiesAreToldApart) {
    const Query query;
    const RejectionsStyle style;
    const Pane pane = rejections_pane(query.bodies, query.frame, query.outcomes,
                                      ended_nodes(query.bodies, query.frame, query.outcomes, style),
                                      query.contact(), style);
    const std::uint32_t first_of_b = query.bodies[1].first_node_id;
    ASSERT_FALSE(pane.volumes.empty());
    EXPECT_FALSE(pane.volumes.front().hatched);
    EXPECT_TRUE(pane.volumes.back().hatched);
    ASSERT_EQ(pane.meshes.size(), 4u);
    for (const MeshDraw& mesh : pane.meshes) EXPECT_EQ(mesh.backdrop, !mesh.chosen);
    EXPECT_FALSE(pane.meshes[0].hatched);
    EXPECT_TRUE(pane.meshes[1].hatched);
    EXPECT_GE(pane.volumes.back().id, first_of_b);
    std::vector<PanelLegendRow> rows;
    for (const PanelItem& item : drawn_keys(query.bodies, {}, style))
        if (const auto* row = std::get_if<PanelLegendRow>(&item)) rows.push_back(*row);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].text, "A");
    EXPECT_FALSE(rows[0].hatched);
    EXPECT_EQ(rows[1].text, "B, hatched: lid");
    EXPECT_TRUE(rows[1].hatched);
    EXPECT_NE(rows[0].color, rows[1].color);
}

TEST(RejectionsFigure, LeavesAreTrianglesWhereTheseWereTested) {
    const Query query;
    RejectionsStyle style;
    style.sides = {true, false};
    const EndedNodes ended = ended_nodes(query.bodies, query.frame, query.outcomes, style);
    const Pane pane =
        rejections_pane(query.bodies, query.frame, query.outcomes, ended, query.contact(), style);
    std::vector<std::uint32_t> triangles;
    for (const EndedPaths& node : ended[0])
        if (query.at_triangle(node))
            triangles.push_back(query.topology().order[query.topology().nodes[node.node].first]);
    std::sort(triangles.begin(), triangles.end());
    ASSERT_FALSE(triangles.empty());
    ASSERT_LT(triangles.size(), ended[0].size());
    EXPECT_EQ(pane.volumes.size(), ended[0].size() - triangles.size());
    ASSERT_TRUE(pane.meshes[0].chosen);
    EXPECT_EQ(*pane.meshes[0].chosen, triangles);
    for (const std::uint32_t triangle : triangles) {
        const Rgba8 color = pane.meshes[0].triangle_colors[triangle];
        EXPECT_TRUE(color == ending_color(Stage::triangles_apart, light_theme) ||
                    color == ending_color(Stage::triangles_meet, light_theme));
    }
    EXPECT_FALSE(shows_no_node(pane));
    EXPECT_TRUE(
        shows_no_node(rejections_pane(query.bodies, query.frame, query.outcomes, {}, {}, style)));
}

TEST(PairsFigure, MarksWhatIntersectsAndTheCameraHoldsTheLinesAlone) {
    const Query query;
    const std::vector<IndexPair>& pairs = query.frame.found.pairs;
    ASSERT_FALSE(pairs.empty());
    const Pane pane = pairs_pane(query.bodies, query.header, query.frame, query.contact(), {}, 1);
    ASSERT_EQ(pane.meshes.size(), 4u);
    for (const IndexPair pair : pairs)
        for (std::size_t side = 0; side < 2; ++side) {
            const MeshDraw& marked = pane.meshes[2 * side];
            EXPECT_EQ(marked.color, body_color(side));
            ASSERT_TRUE(marked.chosen);
            EXPECT_TRUE(std::binary_search(marked.chosen->begin(), marked.chosen->end(),
                                           side == 0 ? pair.a : pair.b));
            EXPECT_FALSE(pane.meshes[2 * side + 1].chosen);
        }
    const std::vector<AnyVolume> region =
        contact_region(query.bodies, query.header, query.frame, query.contact());
    ASSERT_EQ(region.size(), 2 * pairs.size());
    for (std::size_t i = 0; i < region.size(); ++i) {
        const TriangleCorners at = corners(query.mesh.mesh, pairs[i / 2].a);
        const Vec3 low = at[0].cwiseMin(at[1]).cwiseMin(at[2]),
                   high = at[0].cwiseMax(at[1]).cwiseMax(at[2]), end = center(region[i]);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(end[axis], low[axis] - 1e-9);
            EXPECT_LE(end[axis], high[axis] + 1e-9);
        }
    }
}

TEST(PairsFigure, LeavesAreCountedAndThoseOfBAreHatched) {
    const Query query;
    PairsStyle style;
    style.leaves = true;
    const Pane pane =
        pairs_pane(query.bodies, query.header, query.frame, query.contact(), style, 1);
    std::vector<PanelLegendRow> rows;
    for (const PanelItem& item : pairs_panel(query.bodies, query.header, query.frame, style))
        if (const auto* row = std::get_if<PanelLegendRow>(&item)) rows.push_back(*row);
    ASSERT_EQ(rows.size(), 2u);
    for (const bool hatched : {false, true}) {
        const auto count = std::count_if(pane.volumes.begin(), pane.volumes.end(),
                                         [&](const auto& v) { return v.hatched == hatched; });
        EXPECT_GT(count, 0);
        EXPECT_EQ(rows[hatched].hatched, hatched);
        EXPECT_EQ(rows[hatched].count, count_text(static_cast<std::uint64_t>(count)));
    }
}

/// How much is drawn over a picture of that chart.
int drawn_over(int rows) {
    SceneFigure figure;
    figure.pane.camera = orbit_camera(0, 0, Vec3::Zero(), 5);
    figure.panel.assign(14, PanelKey{});
    for (int i = 0; i < rows; ++i) figure.chart.rows.push_back({{Rgba8{}, 1.0}});
    Overlay overlay;
    overlay.begin();
    compose(std::move(figure), 640, 360, 1, overlay);
    return overlay.draw_list().VtxBuffer.Size;
}

TEST(SceneFigure, ManyRowsOfAChartShareBars) {
    // The bars of 10 rows, of 3 pixels each, and of 200 rows in bars of several each.
    EXPECT_GT(drawn_over(10), drawn_over(0));
    EXPECT_GT(drawn_over(200), drawn_over(0));
    EXPECT_LT(drawn_over(200), drawn_over(0) + 40 * 8);
}

TEST(QueryBody, AMeshReachesAsFarAsItsVertices) {
    const Query query;
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(-0.6, 0, 0.8), Vec3(0, 0.6, -0.8)})
        EXPECT_NEAR(mesh_reach(query.bodies[1], direction),
                    support_of(query.mesh.mesh, query.bodies[1].pose)(direction), 1e-12);
}

TEST(RejectionsFigure, LegendAndBarsHaveWhatIsShown) {
    const Query query;
    RejectionsStyle style;
    const auto rows = [&] {
        std::vector<PanelLegendRow> result;
        for (const PanelItem& item : endings_legend(query.header, query.outcomes, style))
            if (const auto* row = std::get_if<PanelLegendRow>(&item)) result.push_back(*row);
        return result;
    };
    const auto bars = [&] {
        return endings_chart(query.header, query.frame, query.outcomes, style).rows;
    };
    EXPECT_EQ(rows().size(), 7u);
    const PanelLegendRow balls = rows().front();
    const double of_balls = [&] {
        double sum = 0;
        for (const std::vector<BarPart>& bar : bars()) sum += bar.front().amount;
        return sum;
    }();
    style.filter.endings = {Stage::ball_ball};
    ASSERT_EQ(rows().size(), 1u);
    EXPECT_EQ(rows()[0].text, balls.text);
    EXPECT_EQ(rows()[0].count, balls.count);
    EXPECT_EQ(rows()[0].share, balls.share);
    double sum = 0;
    for (const std::vector<BarPart>& bar : bars()) {
        ASSERT_EQ(bar.size(), 1u);
        sum += bar[0].amount;
    }
    EXPECT_EQ(sum, of_balls);
    // Several endings of boxes are one group.
    EndingCounts counts;
    counts.fill(3);
    style.filter.endings = {Stage::axis_a1};
    const EndingCounts shown = shown_counts(counts, style);
    EXPECT_EQ(std::accumulate(shown.begin(), shown.end(), std::uint64_t{0}), 3u);
    EXPECT_EQ(shown[static_cast<std::size_t>(Stage::axis_a1)], 3u);
}

TEST(RejectionsFigure, AScaleHasNoOtherColorsBesideIt) {
    const Query query;
    RejectionsStyle style;
    style.by = NodeColor::share;
    for (const PanelItem& item :
         rejections_panel(query.bodies, query.header, query.frame, query.outcomes, {}, style)) {
        // The bodies alone.
        if (const auto* row = std::get_if<PanelLegendRow>(&item)) {
            EXPECT_TRUE(row->share.empty());
        }
        EXPECT_FALSE(std::holds_alternative<PanelKey>(item));
    }
    for (const std::vector<BarPart>& bar :
         endings_chart(query.header, query.frame, query.outcomes, style).rows)
        for (const BarPart& part : bar) EXPECT_EQ(part.color, light_theme.mesh);
}

}  // namespace
}  // namespace scb::render
