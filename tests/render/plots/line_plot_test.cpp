#include "render/plots/line_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/overlay/line_stroke.h"
#include "render/plots/bar_plot.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/overlay/overlay_fixture.h"

namespace scb::render {
namespace {

PlotSeries series_of(std::vector<double> y, Rgba8 color = body_a_color) {
    PlotSeries series{"a series", "mean 12", color, LineStroke::solid, {}, std::move(y)};
    for (std::size_t i = 0; i < series.y.size(); ++i) series.x.push_back(static_cast<double>(i));
    return series;
}

LinePlot plot_of(std::vector<PlotSeries> series) {
    LinePlot plot;
    plot.title = "Tests of pairs of volumes, with a long title (jgÄ)";
    plot.x_label = "frame";
    plot.y_label = "N_v";
    plot.series = std::move(series);
    plot.ranges = {
        {1, 2, "parallel close proximity"}, {-5, -4, "elsewhere"}, {3, INFINITY, "rest"}};
    return plot;
}

std::vector<double> peaked(std::size_t count) {
    std::vector<double> y(count);
    for (std::size_t i = 0; i < count; ++i) y[i] = 10 + static_cast<double>(i * 7919 % 13);
    y[count / 2] = 15000;
    return y;
}

TEST(Thinned, KeepsTheExtremesOfEveryColumn) {
    std::vector<ScreenPosition> points;
    for (int i = 0; i < 10000; ++i) points.push_back({i / 100.0, 50.0 + i * 7919 % 31});
    points[5321].y = -400;
    points[5322].y = 900;
    const std::vector<ScreenPosition> few = thinned(points);
    EXPECT_LE(few.size(), 400u);
    for (int column = 0; column < 100; ++column) {
        const auto extremes = [&](const std::vector<ScreenPosition>& all) {
            std::pair range{1e9, -1e9};
            for (const ScreenPosition& p : all)
                if (std::floor(p.x) == column)
                    range = {std::min(range.first, p.y), std::max(range.second, p.y)};
            return range;
        };
        EXPECT_EQ(extremes(few), extremes(points));
    }
    EXPECT_EQ(few.front().x, points.front().x);
    EXPECT_EQ(few.back().x, points.back().x);
    for (std::size_t i = 1; i < few.size(); ++i) EXPECT_LT(few[i - 1].x, few[i].x);
}

TEST(Thinned, LeavesSparsePointsAlone) {
    EXPECT_TRUE(thinned({}).empty());
    const std::vector<ScreenPosition> points = {{0.5, 3}, {1.5, 9}, {2.5, 1}};
    EXPECT_EQ(thinned(points).size(), 3u);
}

TEST(SmoothLine, CoversWhatItIsWide) {
    Drawing drawing;
    Overlay overlay;
    const Rgba8 black{0, 0, 0};
    draw_smooth_line(overlay, std::vector<ScreenPosition>{{10, 20}, {90, 20}}, black, 3);
    const Image image = drawing.renderer.draw(empty_picture(100, 40), &overlay).image;
    EXPECT_EQ(pixel(image, 50, 17).r, 255);
    EXPECT_NEAR(pixel(image, 50, 18).r, 128, 1);  // half of it
    EXPECT_EQ(pixel(image, 50, 19).r, 0);
    EXPECT_EQ(pixel(image, 50, 20).r, 0);
    EXPECT_NEAR(pixel(image, 50, 21).r, 128, 1);
    EXPECT_EQ(pixel(image, 50, 22).r, 255);
    EXPECT_EQ(pixel(image, 7, 20).r, 255);
}

TEST(SmoothLine, IsTheSameFromEitherEndAndOverStrips) {
    Drawing drawing;
    Overlay overlay;
    const std::vector<ScreenPosition> forth = {{3, 5}, {190, 31}, {120, 90}, {3, 88}};
    const std::vector<ScreenPosition> back(forth.rbegin(), forth.rend());
    draw_smooth_line(overlay, forth, {0, 90, 0, 160}, 2.5);
    const Image first = drawing.renderer.draw(empty_picture(200, 100), &overlay).image;
    overlay.begin();
    draw_smooth_line(overlay, back, {0, 90, 0, 160}, 2.5);
    EXPECT_EQ(drawing.renderer.draw(empty_picture(200, 100), &overlay).image, first);
    // Where a line crosses itself it is no darker.
    int darkest = 255;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 200; ++x) darkest = std::min<int>(darkest, pixel(first, x, y).r);
    EXPECT_NEAR(darkest, 255 * (255 - 160) / 255, 1);
}

TEST(Dashes, HaveTheirLengths) {
    const auto cut =
        dashes(std::vector<ScreenPosition>{{0, 0}, {3, 0}, {20, 0}}, std::vector<double>{5, 2});
    ASSERT_EQ(cut.size(), 3u);
    EXPECT_NEAR(cut[0].back().x, 5, 1e-9);
    EXPECT_NEAR(cut[1].front().x, 7, 1e-9);
    EXPECT_NEAR(cut[1].back().x, 12, 1e-9);
    EXPECT_NEAR(cut[2].back().x, 19, 1e-9);
    EXPECT_TRUE(dashes({}, std::vector<double>{5, 2}).empty());
}

TEST(ChosenScale, IsLogarithmicWhereAPeakHidesTheRest) {
    EXPECT_EQ(chosen_scale(plot_of({series_of({1, 2, 3, 19})})), PlotScale::linear);
    EXPECT_EQ(chosen_scale(plot_of({series_of(peaked(99))})), PlotScale::log10);
    EXPECT_EQ(chosen_scale(plot_of({series_of({0, 0, 0, 0, 5, 6})})), PlotScale::linear);
    std::vector<double> negative = peaked(99);
    negative[3] = -1;
    EXPECT_EQ(chosen_scale(plot_of({series_of(negative)})), PlotScale::linear);
    EXPECT_EQ(chosen_scale(plot_of({})), PlotScale::linear);
    LinePlot forced = plot_of({series_of({0, 0})});
    forced.scale = PlotScale::log10;
    EXPECT_EQ(chosen_scale(forced), PlotScale::linear);
}

TEST(LinePlot, StaysInItsRectangleWhateverTheData) {
    Drawing drawing;
    Overlay overlay;
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<PlotSeries> many;
    for (std::size_t i = 0; i < 12; ++i) many.push_back(series_of(peaked(60), category_color(i)));
    PlotSeries uneven = series_of({1, 2, 3});
    uneven.x.pop_back();
    const std::vector<std::vector<PlotSeries>> cases = {
        {},
        {series_of({})},
        {series_of({7})},
        {series_of({0})},
        {series_of({NAN, NAN})},
        {series_of({NAN, 3, NAN, 4, 5, infinity, -infinity, 6})},
        {series_of({5, 5, 5, 5})},
        {series_of({0, 0, 0, 0})},
        {series_of({0, 1, 0, 100000, 0})},
        {series_of({-3, 8, -1e6})},
        {series_of({1e308, -1e308, 1e-308})},
        {series_of({1, 1 + 1e-15})},
        {series_of(peaked(20000))},
        {uneven},
        many};
    const PixelRect rect{40, 30, 420, 260};
    for (std::size_t i = 0; i < cases.size(); ++i)
        for (const PlotScale scale : {PlotScale::automatic, PlotScale::linear, PlotScale::log10})
            for (const PlotLegend legend :
                 {PlotLegend::none, PlotLegend::at_lines, PlotLegend::below}) {
                LinePlot plot = plot_of(cases[i]);
                plot.scale = scale;
                plot.legend = legend;
                if (!plot.series.empty() && i % 2 == 0) plot.series[0].stroke = LineStroke::dashed;
                overlay.begin();
                const PixelRect area = draw_line_plot(overlay, rect, plot, {light_theme, 16});
                EXPECT_GT(area.width, 100) << i;
                const Picture picture = empty_picture(500, 320);
                const auto [inside, outside] = inside_and_outside(
                    drawing.renderer.draw(picture, &overlay).image, rect, picture.background);
                EXPECT_GT(inside, 100) << i;
                EXPECT_EQ(outside, 0) << i;
            }
}

TEST(LinePlot, DrawsNothingWhereThereIsNoRoom) {
    Overlay overlay;
    for (const auto& [width, height] : {std::pair{0, 0}, {30, 200}, {300, 40}, {-5, -5}}) {
        const LinePlot plot = plot_of({series_of({1, 2, 3})});
        EXPECT_EQ(draw_line_plot(overlay, {5, 5, width, height}, plot, {}).width, 0);
    }
}

TEST(LinePlot, APeakOfOneFrameAmongThousandsIsSeen) {
    Drawing drawing;
    Overlay overlay;
    LinePlot plot;
    plot.series = {series_of(peaked(20000), {255, 0, 0})};
    plot.scale = PlotScale::linear;
    plot.legend = PlotLegend::none;
    const PixelRect area = draw_line_plot(overlay, {0, 0, 400, 300}, plot, {light_theme, 16});
    const Image image = drawing.renderer.draw(empty_picture(400, 300), &overlay).image;
    int columns = 0;
    for (int x = area.x; x < area.x + area.width; ++x) {
        const Rgba8 color = pixel(image, x, area.y + area.height / 2);
        columns += color.r > color.g + 80;
    }
    EXPECT_GE(columns, 1);
    EXPECT_LE(columns, 4);
}

TEST(LinePlot, AGapIsNotDrawn) {
    Drawing drawing;
    Overlay overlay;
    LinePlot plot;
    plot.series = {series_of({5, 5, NAN, 5, 5}, {255, 0, 0})};
    plot.legend = PlotLegend::none;
    const PixelRect area = draw_line_plot(overlay, {0, 0, 400, 300}, plot, {light_theme, 16});
    const Image image = drawing.renderer.draw(empty_picture(400, 300), &overlay).image;
    const auto drawn = [&](double at) {
        const int x = area.x + static_cast<int>(at * (area.width - 1));
        for (int y = area.y; y < area.y + area.height; ++y)
            if (pixel(image, x, y) == (Rgba8{255, 0, 0})) return true;
        return false;
    };
    EXPECT_TRUE(drawn(0.1));
    EXPECT_FALSE(drawn(0.5));
    EXPECT_TRUE(drawn(0.9));
}

// What names at the lines take from the width of the data: 0 where there are none.
int width_of_names(const std::vector<std::vector<double>>& values,
                   const std::string& name = "a name") {
    LinePlot plot;
    plot.scale = PlotScale::linear;
    for (const std::vector<double>& y : values) {
        plot.series.push_back(series_of(y));
        plot.series.back().name = name;
    }
    const auto width = [&](PlotLegend legend) {
        Overlay overlay;
        plot.legend = legend;
        return draw_line_plot(overlay, {0, 0, 400, 300}, plot, {light_theme, 16}).width;
    };
    return width(PlotLegend::none) - width(PlotLegend::at_lines);
}

TEST(LinePlot, HasNamesAtTheLinesOnlyWhereEachCanStandThere) {
    EXPECT_GT(width_of_names({{1, 2, 5}}), 40);
    EXPECT_GT(width_of_names({{1, 2, 5}, {1, 2, 9}}), 40);
    // Two next to each other, both moved a little.
    EXPECT_GT(width_of_names({{1, 2, 5}, {1, 2, 5}, {1, 2, 9}}), 40);
    // Three at the same end, or two at the bottom: one of them would stand beside another's line.
    EXPECT_EQ(width_of_names({{1, 2, 5}, {1, 3, 5}, {1, 4, 5}, {1, 2, 9}}), 0);
    EXPECT_EQ(width_of_names({{1, 2, 0}, {1, 5, 0}}), 0);
    // A line that ends elsewhere, and a name that would have to be cut.
    EXPECT_EQ(width_of_names({{1, 2, 5}, {1, 9, NAN}}), 0);
    EXPECT_EQ(width_of_names({{1, 2, 5}}, std::string(40, 'W')), 0);
}

TEST(LinePlot, DrawsNoNameWhereNotAllCanBe) {
    Drawing drawing;
    LinePlot plot;
    plot.series = {series_of({1, 2, 0}), series_of({1, 5, 0}), series_of({1, 9, 0})};
    const auto image = [&](PlotLegend legend) {
        Overlay overlay;
        plot.legend = legend;
        draw_line_plot(overlay, {0, 0, 400, 300}, plot, {light_theme, 16});
        return drawing.renderer.draw(empty_picture(400, 300), &overlay).image;
    };
    EXPECT_EQ(image(PlotLegend::at_lines), image(PlotLegend::none));
}

TEST(LineStroke, CanBeToldApartInASample) {
    Drawing drawing;
    const FigureStyle style{light_theme, 13};
    std::vector<Image> samples;
    for (std::size_t i = 0; i < line_stroke_count; ++i) {
        Overlay overlay;
        draw_line_sample(overlay, 10, 10, line_sample_width(style), {0, 0, 0}, stroke_of_line(i),
                         style);
        samples.push_back(drawing.renderer.draw(empty_picture(100, 20), &overlay).image);
        // A good part of it differs from any other.
        for (std::size_t k = 0; k < i; ++k) {
            int different = 0;
            for (int x = 0; x < 100; ++x)
                different += std::abs(pixel(samples[i], x, 10).r - pixel(samples[k], x, 10).r) > 64;
            EXPECT_GE(different, line_sample_width(style) / 10) << i << " " << k;
        }
    }
}

BarPlot bars_of(const std::vector<double>& values) {
    BarPlot plot{"Time, with a long title (jgÄ)", "ms in frame 0", {}};
    for (std::size_t i = 0; i < values.size(); ++i)
        plot.bars.push_back({"name " + std::to_string(i), category_color(i), values[i], "12,345"});
    return plot;
}

TEST(BarPlot, HasBarsAsLongAsTheirValues) {
    Drawing drawing;
    Overlay overlay;
    const PixelRect area =
        draw_bar_plot(overlay, {10, 10, 480, 300}, bars_of({50, 100, 25}), {light_theme, 16});
    const Image image = drawing.renderer.draw(empty_picture(500, 320), &overlay).image;
    const double shares[] = {0.5, 1, 0.25};
    for (int i = 0; i < 3; ++i) {
        int length = 0;
        for (int x = area.x; x < area.x + area.width; ++x)
            length += pixel(image, x, area.y + (2 * i + 1) * area.height / 6) ==
                      category_color(static_cast<std::size_t>(i));
        EXPECT_NEAR(length, shares[i] * area.width, 2) << i;
    }
}

TEST(BarPlot, HasWhiskersThatNeedRoomToo) {
    Drawing drawing;
    const auto drawn = [&](const BarPlot& plot) {
        Overlay overlay;
        overlay.begin();
        draw_bar_plot(overlay, {10, 10, 480, 300}, plot, {light_theme, 16});
        return drawing.renderer.draw(empty_picture(500, 320), &overlay).image;
    };
    BarPlot plot = bars_of({50, 100, 25});
    const Image plain = drawn(plot);
    plot.bars[0].range = {40, 60};
    EXPECT_NE(drawn(plot), plain);
    plot.bars[0].range = {40, 200};
    const auto [inside, outside] =
        inside_and_outside(drawn(plot), {9, 9, 482, 302}, light_theme.background);
    EXPECT_GT(inside, 0);
    EXPECT_EQ(outside, 0);
}

TEST(BarPlot, StaysInItsRectangleWhateverTheData) {
    Drawing drawing;
    Overlay overlay;
    const PixelRect rect{40, 30, 420, 260};
    BarPlot long_names = bars_of({1, 2});
    for (PlotBar& bar : long_names.bars) bar.name = std::string(80, 'W');
    for (const BarPlot& plot :
         {bars_of({}), bars_of({0}), bars_of({NAN, NAN}), bars_of({1e300, 1e-300, NAN, -4}),
          bars_of({INFINITY, 3}), bars_of(std::vector<double>(12, 7)), long_names}) {
        overlay.begin();
        EXPECT_GT(draw_bar_plot(overlay, rect, plot, {light_theme, 16}).width, 50);
        const Picture picture = empty_picture(500, 320);
        const auto [inside, outside] = inside_and_outside(
            drawing.renderer.draw(picture, &overlay).image, rect, picture.background);
        EXPECT_GT(inside, 100);
        EXPECT_EQ(outside, 0);
    }
    for (const auto& [width, height] : {std::pair{0, 0}, {30, 200}, {300, 40}, {-5, -5}})
        EXPECT_EQ(draw_bar_plot(overlay, {5, 5, width, height}, bars_of({1, 2}), {}).width, 0);
}

}  // namespace
}  // namespace scb::render
