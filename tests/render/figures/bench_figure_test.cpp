#include "render/figures/bench_figure.h"

#include <array>
#include <cmath>
#include <set>

#include "core/base/statistics.h"
#include "render/figures/bench_legend.h"
#include "render/overlay/figure_layout.h"
#include "tests/render/figures/drawn_figure.h"

namespace scb::render {
namespace {

BenchSeries series_of(std::string name, VolumeKind kind, double n_v, double ms, int frames) {
    BenchSeries series{std::move(name), kind, {}, {}, {}, {}, {}};
    for (int f = 0; f < frames; ++f) {
        const double peak = std::abs(f - frames / 2) < frames / 50 ? 40 : 1 + f % 7 * 0.1;
        series.frames.push_back(f);
        series.n_v.push_back(n_v * peak);
        series.n_p.push_back(n_v * peak / 10);
        series.ms.push_back(ms * peak);
        series.pairs.push_back(20 + f);
    }
    return series;
}

BenchFigure example(int frames = 300) {
    BenchFigure figure;
    figure.scene = "spheres-l1";
    figure.triangles = {20480, 20480};
    figure.series = {series_of("SCB", VolumeKind::scb, 20000, 3, frames),
                     series_of("ball, minimum", VolumeKind::ball, 90000, 7, frames),
                     series_of("ball, Ritter", VolumeKind::ritter, 94000, 7.5, frames),
                     series_of("OBB", VolumeKind::obb, 13000, 4.5, frames),
                     series_of("SCB2", VolumeKind::scb2, 11000, 3.5, frames)};
    figure.ranges = {{144, 156, "parallel close proximity, frames 144–156"}};
    figure.footnote = "Times depend on the machine: gcc 12.2, -O3, best of three runs.";
    return figure;
}

// Five tests of slab cut balls beside the other hierarchies.
BenchFigure tests_example(int frames = 300) {
    BenchFigure figure = example(frames);
    figure.series.erase(figure.series.begin());
    double n_v = 20000;
    for (const char* test : {"printed", "line8", "extents", "corrected", "symmetric"})
        figure.series.insert(
            figure.series.begin(),
            series_of(std::string("SCB ") + test, VolumeKind::scb, n_v += 1000, 3, frames));
    return figure;
}

int count_of(const Image& image, Rgba8 color) {
    int count = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) count += pixel(image, x, y) == color;
    return count;
}

// The longest row of pixels of a color.
int longest_run(const Image& image, Rgba8 color) {
    int longest = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0, run = 0; x < image.width; ++x) {
            run = pixel(image, x, y) == color ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    return longest;
}

const LegendColumn* column_of(const BenchLegend& legend, const std::string& heading) {
    for (const LegendColumn& column : legend.columns)
        if (column.heading == heading) return &column;
    return nullptr;
}

double luminance(Rgba8 color) {
    const auto linear = [](double c) {
        return c <= 0.04045 * 255 ? c / 255 / 12.92 : std::pow((c / 255 + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

double contrast(Rgba8 a, Rgba8 b) {
    const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
    return std::max(x / y, y / x);
}

TEST(BenchFigure, HasTheSameBytesEveryTime) {
    Drawing drawing;
    Overlay first, second;
    const auto draw = [&](Overlay& overlay) {
        const Picture picture = compose(example(), 640, 480, overlay);
        return drawing.renderer.draw(picture, &overlay).image;
    };
    const Image image = draw(first);
    EXPECT_EQ(draw(second), image);
    EXPECT_EQ(draw(first), image);
}

TEST(BenchFigure, LeavesItsMarginsFree) {
    Drawing drawing;
    Overlay overlay;
    BenchFigure no_times = example();
    for (BenchSeries& series : no_times.series) series.ms.clear();
    BenchFigure long_names = example(3);
    long_names.scene = std::string(300, 'W');
    long_names.footnote = std::string(900, 'W') + " " + std::string(40, 'W');
    for (BenchSeries& series : long_names.series) {
        series.name = std::string(80, 'W');
        series.kind = VolumeKind::scb;
        for (double& value : series.n_v) value *= 1e9;
        for (double& value : series.ms) value *= 1e9;
    }
    for (const BenchFigure& figure : {example(), example(1), BenchFigure{}, no_times, long_names})
        for (const auto& [width, height] :
             {std::pair{1280, 720}, {640, 480}, {320, 240}, {400, 800}, {64, 48}}) {
            const Picture picture = compose(figure, width, height, overlay);
            const int margin = figure_layout(width, height).heading.x - 1;
            const auto [inside, outside] = inside_and_outside(
                drawing.renderer.draw(picture, &overlay).image,
                {margin, margin, width - 2 * margin, height - 2 * margin}, picture.background);
            EXPECT_EQ(outside, 0) << width << "x" << height;
            if (width > 64) {
                EXPECT_GT(inside, 100) << width << "x" << height;
            }
        }
}

TEST(BenchFigure, DrawsEveryHierarchyInItsColor) {
    Drawing drawing;
    Overlay overlay;
    for (const Theme* theme : {&light_theme, &dark_theme}) {
        BenchFigure figure = example();
        figure.series.push_back(series_of("AABB", VolumeKind::aabb, 40000, 4, 300));
        figure.series.push_back(series_of("AABB (exact)", VolumeKind::aabb_exact, 30000, 6, 300));
        figure.theme = theme;
        const Picture picture = compose(figure, 1280, 720, overlay);
        const Image image = drawing.renderer.draw(picture, &overlay).image;
        for (const BenchSeries& series : figure.series) {
            EXPECT_GT(count_of(image, hierarchy_color(series.kind)), 100)
                << volume_kind_name(series.kind);
        }
    }
}

TEST(BenchFigure, DrawsEachTestOfAHierarchyInItsOwnLook) {
    Drawing drawing;
    for (const Theme* theme : {&light_theme, &dark_theme}) {
        BenchFigure figure = tests_example();
        figure.theme = theme;
        const std::vector<SeriesLook> looks = looks_of(figure);
        ASSERT_EQ(looks.size(), 9u);
        EXPECT_EQ(looks[0].color, hierarchy_color(VolumeKind::scb));
        EXPECT_EQ(looks[0].stroke, LineStroke::solid);
        std::set<LineStroke> strokes;
        for (std::size_t i = 0; i < 5; ++i) {
            strokes.insert(looks[i].stroke);
            EXPECT_GE(contrast(looks[i].color, theme->background), 3) << i;
            if (i > 0) {
                EXPECT_GE(contrast(looks[i].color, looks[i - 1].color), 1.15) << i;
            }
        }
        EXPECT_EQ(strokes.size(), 5u);
        const Image image = drawn(drawing, figure, 1280, 720);
        for (const SeriesLook& look : looks) EXPECT_GT(count_of(image, look.color), 60);
    }
}

TEST(BenchFigure, HasBarsOfFewFrames) {
    Drawing drawing;
    const Rgba8 color = hierarchy_color(VolumeKind::ball);
    for (int frames = 1; frames < 4; ++frames)
        EXPECT_GT(longest_run(drawn(drawing, example(frames), 1280, 720), color), 300) << frames;
    EXPECT_LT(longest_run(drawn(drawing, example(4), 1280, 720), color), 100);
    EXPECT_EQ(bench_legend(example(1)).columns[0].heading, "N_v");
    EXPECT_EQ(bench_legend(example(2)).columns[0].heading, "mean N_v");
}

TEST(BenchFigure, HasBarsOfOneFrameHoweverManyHierarchies) {
    Drawing drawing;
    for (const std::size_t more : {1u, 10u, 22u, 26u, 28u, 30u}) {
        BenchFigure figure = example(1);
        for (std::size_t i = 0; i < more; ++i)
            figure.series.insert(figure.series.end() - 1, series_of("OBB " + std::to_string(i),
                                                                    VolumeKind::obb, 9000, 2, 1));
        const Image image = drawn(drawing, figure, 1280, 720);
        EXPECT_GT(longest_run(image, hierarchy_color(VolumeKind::scb2)), 40) << more;
    }
}

TEST(BenchFigure, SaysWhichFrames) {
    EXPECT_EQ(frames_text({}), "");
    EXPECT_EQ(frames_text({7}), "frame 7");
    EXPECT_EQ(frames_text({0, 20}), "frames 0 and 20");
    EXPECT_EQ(frames_text({0, 20, 40}), "frames 0, 20 and 40");
    EXPECT_EQ(frames_text({5, 6, 7, 8}), "frames 5 to 8");
    EXPECT_EQ(frames_text({0, 120, 240, 360, 480}), "5 frames, 0 to 480");
}

// What is cut does not change the picture.
TEST(BenchFigure, CutsNoNameAndNoFootnoteWhereItIsSmall) {
    Drawing drawing;
    BenchFigure figure = tests_example();
    figure.series[1].pairs[3] = 0;
    figure.footnote =
        "Cold: at each frame the hierarchies take turns. One thread, processor time; median of 3 "
        "runs per frame, sorting the pairs included. Compiled by GNU 12.2.0, -O3 -DNDEBUG "
        "-ffp-contract=off -fno-tree-slp-vectorize. Times differ from machine to machine and from "
        "run to run; counts do not.";
    for (const auto& [width, height] : {std::pair{640, 480}, {480, 360}}) {
        const Image image = drawn(drawing, figure, width, height);
        for (std::size_t i = 0; i < figure.series.size(); ++i) {
            BenchFigure other = figure;
            other.series[i].name.back() = 'W';
            EXPECT_NE(drawn(drawing, other, width, height), image) << figure.series[i].name;
        }
        BenchFigure other = figure;
        other.footnote.back() = 'W';
        EXPECT_NE(drawn(drawing, other, width, height), image) << width;
        BenchFigure valid = figure;
        valid.series[1].pairs[3] = valid.series[0].pairs[3];
        EXPECT_NE(drawn(drawing, valid, width, height), image) << width;
    }
}

TEST(BenchLegend, ComparesTimesToThoseOfTheFirstScb) {
    BenchFigure figure = tests_example(10);
    const auto times = [&](std::size_t row, double ms) { figure.series[row].ms.assign(10, ms); };
    times(0, 2);
    times(1, 0.1714);
    times(2, 0.001);
    times(3, 6.8749);
    times(4, 24.68);
    times(5, 4734);
    figure.ranges = {{2, 4, ""}};
    const BenchLegend legend = bench_legend(figure);
    const LegendColumn* all = column_of(legend, "time / SCB");
    ASSERT_NE(all, nullptr);
    const std::vector<std::string> expected = {"1.00", "0.09", "<0.01", "3.44", "12.3", "2,370"};
    EXPECT_EQ(std::vector<std::string>(all->values.begin(), all->values.begin() + 6), expected);
    EXPECT_NE(column_of(legend, "in shaded frames"), nullptr);
    // Nothing is shaded.
    figure.ranges = {{200, 300, ""}};
    EXPECT_EQ(column_of(bench_legend(figure), "in shaded frames"), nullptr);
}

TEST(BenchLegend, SaysWhoMissesPairs) {
    BenchFigure figure = tests_example(10);
    EXPECT_EQ(column_of(bench_legend(figure), "mean pairs"), nullptr);
    figure.series[4].pairs[3] -= 5;
    const auto warned = [&] {
        std::vector<std::size_t> rows;
        const BenchLegend legend = bench_legend(figure);
        for (std::size_t i = 0; i < legend.rows.size(); ++i)
            if (legend.rows[i].warning == "misses pairs") rows.push_back(i);
        return rows;
    };
    const BenchLegend legend = bench_legend(figure);
    const LegendColumn* pairs = column_of(legend, "mean pairs");
    ASSERT_NE(pairs, nullptr);
    EXPECT_EQ(pairs->values[0], "24.5");
    EXPECT_EQ(pairs->values[4], "24.0");
    EXPECT_EQ(warned(), std::vector<std::size_t>{4});
    // Also where it is the first one, and where the means are the same.
    std::swap(figure.series[0], figure.series[4]);
    EXPECT_EQ(warned(), std::vector<std::size_t>{0});
    for (BenchSeries& series : figure.series) series.pairs = {1, 2};
    figure.series[1].pairs = {2, 1};
    EXPECT_EQ(warned().size(), 9u);
    for (BenchSeries& series : figure.series) series.pairs.clear();
    EXPECT_TRUE(warned().empty());
}

TEST(HierarchyColor, IsDifferentForEveryKind) {
    std::set<std::array<std::uint8_t, 3>> seen;
    for (const VolumeKind kind : all_volume_kinds()) {
        const Rgba8 color = hierarchy_color(kind);
        EXPECT_TRUE(seen.insert({color.r, color.g, color.b}).second);
    }
}

TEST(Mean, LeavesOutWhatIsNotKnown) {
    EXPECT_EQ(mean(std::vector<double>{1, NAN, 3}), 2);
    EXPECT_EQ(mean(std::vector<std::uint64_t>{1, 2}), 1.5);
    EXPECT_TRUE(std::isnan(mean(std::vector<double>{})));
    EXPECT_TRUE(std::isnan(mean(std::vector<double>{NAN})));
    EXPECT_TRUE(std::isnan(mean(std::vector<std::uint64_t>{})));
}

TEST(Median, IsTheMiddleOfWhatIsKnown) {
    EXPECT_EQ(median({5, 1, 3}), 3);
    EXPECT_EQ(median({8, NAN, 1, 4, 2}), 3);
    EXPECT_EQ(median({7}), 7);
    EXPECT_TRUE(std::isnan(median({})));
}

TEST(TimeOverScb, ComparesFramesThatBothWereTimedIn) {
    const BenchSeries scb{"", VolumeKind::scb, {0, 1, 2, 4}, {}, {}, {1, 2, NAN, 5}, {}};
    const BenchSeries other{"", VolumeKind::obb, {1, 2, 3, 4}, {}, {}, {4, 9, 9, 10}, {}};
    EXPECT_EQ(time_over_scb(scb, other, 0, 9), 2);
    EXPECT_EQ(time_over_scb(scb, other, 1, 1), 2);
    EXPECT_EQ(time_over_scb(scb, other, 2, 3), std::nullopt);
    const BenchSeries idle{"", VolumeKind::scb, {1}, {}, {}, {0}, {}};
    EXPECT_EQ(time_over_scb(idle, other, 0, 9), std::nullopt);
}

}  // namespace
}  // namespace scb::render
