#include "render/bench_figure.h"

#include <array>
#include <cmath>
#include <set>

#include "render/figure_layout.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/overlay_fixture.h"

namespace scb {
namespace {

BenchSeries series_of(std::string name, VolumeKind kind, double n_v, double ms, int frames) {
    BenchSeries series{std::move(name), kind, {}, {}, {}, {}};
    for (int f = 0; f < frames; ++f) {
        const double peak = std::abs(f - frames / 2) < frames / 50 ? 40 : 1 + f % 7 * 0.1;
        series.frames.push_back(f);
        series.n_v.push_back(n_v * peak);
        series.n_p.push_back(n_v * peak / 10);
        series.ms.push_back(ms * peak);
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
                     series_of("OBB", VolumeKind::obb, 13000, 4.5, frames)};
    figure.ranges = {{144, 156, "parallel close proximity, frames 144–156"}};
    figure.footnote = "Times depend on the machine: gcc 12.2, -O3, best of three runs.";
    return figure;
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
        figure.theme = theme;
        const Picture picture = compose(figure, 1280, 720, overlay);
        const Image image = drawing.renderer.draw(picture, &overlay).image;
        for (const VolumeKind kind : all_volume_kinds()) {
            int count = 0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x)
                    count += pixel(image, x, y) == hierarchy_color(kind);
            EXPECT_GT(count, 100) << volume_kind_name(kind);
        }
    }
}

TEST(HierarchyColor, IsDifferentForEveryKind) {
    std::set<std::array<std::uint8_t, 3>> seen;
    for (const VolumeKind kind : all_volume_kinds()) {
        const Rgba8 color = hierarchy_color(kind);
        EXPECT_TRUE(seen.insert({color.r, color.g, color.b}).second);
    }
}

TEST(MeanOf, LeavesOutWhatIsNotKnown) {
    EXPECT_EQ(mean_of({1, NAN, 3}), 2);
    EXPECT_EQ(mean_of({}), std::nullopt);
    EXPECT_EQ(mean_of({NAN}), std::nullopt);
}

TEST(SpeedUp, ComparesFramesThatBothWereTimedIn) {
    const BenchSeries scb{"", VolumeKind::scb, {0, 1, 2, 4}, {}, {}, {1, 2, NAN, 5}};
    const BenchSeries other{"", VolumeKind::obb, {1, 2, 3, 4}, {}, {}, {4, 9, 9, 10}};
    EXPECT_EQ(speed_up(scb, other, 0, 9), 2);
    EXPECT_EQ(speed_up(scb, other, 1, 1), 2);
    EXPECT_EQ(speed_up(scb, other, 2, 3), std::nullopt);
    const BenchSeries idle{"", VolumeKind::scb, {1}, {}, {}, {0}};
    EXPECT_EQ(speed_up(idle, other, 0, 9), std::nullopt);
}

}  // namespace
}  // namespace scb
