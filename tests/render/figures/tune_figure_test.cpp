#include "render/figures/tune_figure.h"

#include "tests/render/figures/drawn_figure.h"

namespace scb::render {
namespace {

TuneFigure example(bool timed) {
    TuneFigure figure;
    figure.title = "scene · settings";
    figure.subtitle = "50 frames, 0 to 490, base: symmetric, descent radius, growth ritter";
    figure.runs = 5;
    figure.footnote = std::string(300, 'W') + " " + std::string(50, 'W');
    for (int i = 0; i < 12; ++i) {
        TuneBar bar;
        bar.name = "setting " + std::to_string(i);
        bar.n_v = 1 + 0.01 * i * i;
        bar.cost = 1 + 0.05 * i;
        bar.recommended = i == 2;
        bar.alike = i == 3;
        bar.misses_pairs = i == 1;
        if (timed) bar.time = {1.4 - 0.1 * i, 1.5 - 0.1 * i, 1.6 - 0.1 * i};
        figure.bars.push_back(bar);
    }
    return figure;
}

TEST(TuneFigure, StaysWithinItsMargins) {
    TuneFigure wide = example(true);
    for (TuneBar& bar : wide.bars) bar.name = std::string(80, 'W');
    expect_free_margins({example(true), example(false), wide, TuneFigure{}});
}

TEST(TuneFigure, ShowsEveryBarAndThePlaceOfTheBest) {
    Drawing drawing;
    for (const auto& [width, height] : {std::pair{1280, 720}, {640, 480}}) {
        const TuneFigure figure = example(true);
        const Image image = drawn(drawing, figure, width, height);
        for (std::size_t i = 0; i < figure.bars.size(); ++i) {
            TuneFigure other = figure;
            other.bars[i].name.back() = 'W';
            EXPECT_NE(drawn(drawing, other, width, height), image) << i;
        }
        TuneFigure other = figure;
        other.bars[2].recommended = false;
        EXPECT_NE(drawn(drawing, other, width, height), image);
        other = figure;
        other.bars[3].alike = false;
        EXPECT_NE(drawn(drawing, other, width, height), image);
        other = figure;
        other.bars[4].cost = 1.9;
        EXPECT_NE(drawn(drawing, other, width, height), image);
        other = figure;
        other.bars.back().packed = true;
        EXPECT_NE(drawn(drawing, other, width, height), image);
        other = figure;
        other.bars[3].time->most += 1;
        EXPECT_NE(drawn(drawing, other, width, height), image);
        other = figure;
        other.bars[1].misses_pairs = false;
        EXPECT_NE(drawn(drawing, other, width, height), image);
    }
}

TEST(TuneFigure, OneRunHasNoInterval) {
    Drawing drawing;
    TuneFigure figure = example(true);
    figure.runs = 1;
    const Image image = drawn(drawing, figure, 1280, 720);
    EXPECT_NE(drawn(drawing, example(true), 1280, 720), image);
    figure.bars[3].time->least = figure.bars[3].time->median / 2;
    EXPECT_EQ(drawn(drawing, figure, 1280, 720), image);
}

}  // namespace
}  // namespace scb::render
