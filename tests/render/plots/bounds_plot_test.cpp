#include "render/plots/bounds_plot.h"

#include <gtest/gtest.h>

namespace scb::render {
namespace {

BoundsPlot small_plot() {
    BoundsPlot plot;
    plot.colors = {Rgba8{1, 1, 1}, Rgba8{2, 2, 2}};
    plot.answer = 1;
    plot.tests = {{0, 0, 0}, {1, 2, 0}, {1, 2, 1}, {1, 0.5, 1}, {4, 2, 1}};
    return plot;
}

TEST(BoundsPlot, CountsTestsByColumnAndRow) {
    const BoundsPlot plot = small_plot();
    const PlotAxis axis = bounds_axis(plot, 5);
    EXPECT_FALSE(axis.log10);
    EXPECT_EQ(axis.low, 0);
    EXPECT_EQ(axis.high, 2);
    const std::vector<BoundsCell> cells = bounds_cells(plot, axis, 4, 1);
    ASSERT_EQ(cells.size(), 4u);
    // By column, and in a column from the top.
    EXPECT_EQ(cells[0].row, 1);
    EXPECT_EQ(cells[1].column, 1u);
    EXPECT_EQ(cells[1].row, -2);
    EXPECT_EQ(cells[1].counts, (std::vector<std::uint32_t>{1, 1}));
    EXPECT_EQ(cells[2].row, 1);
    EXPECT_EQ(cells[2].counts, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(cells[3].column, 4u);
    // Columns of two depths.
    EXPECT_EQ(bounds_cells(plot, axis, 4, 2).back().column, 2u);
}

TEST(BoundsPlot, NoBarCrossesTheAnswer) {
    BoundsPlot plot = small_plot();
    for (const double rows : {3.0, 4.0, 10.3, 77.7}) {
        plot.answer = 1.37;
        plot.tests = {
            {0, std::nextafter(1.37, 0), 0}, {1, 1.37, 0}, {2, std::nextafter(1.37, 2), 0}};
        const std::vector<BoundsCell> cells = bounds_cells(plot, bounds_axis(plot, 5), rows, 1);
        ASSERT_EQ(cells.size(), 3u);
        EXPECT_EQ(cells[0].row, 0);
        EXPECT_EQ(cells[1].row, 0);
        EXPECT_EQ(cells[2].row, -1);
    }
}

TEST(BoundsPlot, BeginsAtTheLeastBound) {
    BoundsPlot plot = small_plot();
    plot.tests = {{0, 0.9, 0}, {1, 1.2, 0}};
    EXPECT_GE(bounds_axis(plot, 5).low, 0.8);
}

TEST(BoundsPlot, IsLogarithmicForBoundsFarAboveTheAnswer) {
    BoundsPlot plot = small_plot();
    plot.tests.push_back({2, 50, 0});
    plot.tests.push_back({2, 1e-12, 0});
    const PlotAxis axis = bounds_axis(plot, 5);
    EXPECT_TRUE(axis.log10);
    EXPECT_TRUE(axis.zero_at_low);
    EXPECT_EQ(axis.high, 50);
    // Small bounds do not stretch the scale.
    EXPECT_GT(axis.low, 1e-4);
    EXPECT_EQ(axis_position(axis, 1e-12), 0);
    EXPECT_GT(axis_position(axis, 1), 0.4);
}

TEST(BoundsPlot, NeedsNoAnswerAndNoBounds) {
    BoundsPlot plot = small_plot();
    plot.answer = HUGE_VAL;
    EXPECT_TRUE(bounds_axis(plot, 5).log10);
    plot.answer = 0;
    plot.tests = {{0, 0, 0}};
    EXPECT_FALSE(bounds_axis(plot, 5).log10);
    EXPECT_EQ(bounds_cells(plot, bounds_axis(plot, 5), 3, 1).size(), 1u);
    // A plot without room is left out.
    Overlay overlay;
    overlay.begin();
    draw_bounds_plot(overlay, {0, 0, 2, 2}, plot, {});
}

}  // namespace
}  // namespace scb::render
