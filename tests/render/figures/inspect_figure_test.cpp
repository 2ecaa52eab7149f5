#include "render/figures/inspect_figure.h"

#include <array>

#include "render/overlay/figure_layout.h"
#include "tests/render/figures/drawn_figure.h"

namespace scb::render {
namespace {

Inspection example(std::uint64_t fit, std::uint64_t test, std::uint64_t wrong) {
    Inspection found;
    found.pairs = 100;
    found.counts.inner = {test, fit, 50};
    found.counts.wrongly_rejected = found.counts.missed = wrong;
    found.counts.all = {100 + fit + test, 500, 90000};
    found.counts.wasted_for = {Work{test, 100, 20000}, Work{fit, 200, 30000}};
    found.depths = {{100 + fit + test, {{test, fit}}, {}}};
    return found;
}

InspectFigure figure_of(std::size_t frames, std::uint64_t fit, std::uint64_t test,
                        std::uint64_t wrong = 0) {
    InspectFigure figure;
    figure.title = "scene · SCB · inspect";
    figure.subtitle = "A and B, test corrected, a = 0.7";
    for (std::size_t i = 0; i < frames; ++i) {
        figure.frames.push_back({static_cast<int>(10 * i), example(fit, test, wrong)});
        figure.sum += figure.frames.back().found;
    }
    for (const OverlapTest other : {OverlapTest::extents, OverlapTest::corrected}) {
        figure.others.emplace_back();
        figure.others.back().overlap.test = other;
        figure.others.back().all = {1234, 56, 789};
    }
    return figure;
}

TEST(InspectFigure, StaysWithinItsMargins) {
    InspectFigure long_title = figure_of(3, 10, 10);
    long_title.title = std::string(300, 'W');
    expect_free_margins(
        {figure_of(1, 100, 50), figure_of(300, 100, 0, 7), long_title, InspectFigure{}});
}

TEST(InspectFigure, PanelTellsThresholdsApartAndSaysWhatWouldHaveHelped) {
    Drawing drawing;
    const auto with = [&](double threshold, std::uint64_t n_v_of_setting) {
        InspectFigure figure = figure_of(1, 100, 50);
        figure.others.back().overlap.threshold = threshold;
        figure.settings_from = {1000, 100, 10000, 900};
        if (n_v_of_setting > 0) figure.settings = {{"scb2", {n_v_of_setting, 10, 1000, 90}}};
        return drawn(drawing, figure, 1280, 720);
    };
    const Image image = with(0.5, 500);
    EXPECT_EQ(with(0.5, 500), image);
    EXPECT_NE(with(0.9, 500), image);
    EXPECT_NE(with(0.5, 400), image);
    EXPECT_NE(with(0.5, 0), image);
    InspectFigure best = figure_of(1, 100, 50);
    best.settings_from = {1000, 100, 10000, 900};
    best.settings = {{"scb2", {500, 10, 1000, 90}}};
    const Image unmarked = drawn(drawing, best, 1280, 720);
    best.settings[0].recommended = true;
    EXPECT_NE(drawn(drawing, best, 1280, 720), unmarked);
}

/// How many pixels left of the panel have the colors of the reasons: not wasted, wasted by fits,
/// wasted by tests.
std::array<int, 3> bar_pixels(Drawing& drawing, const InspectFigure& figure) {
    const Image image = drawn(drawing, figure, 1280, 720);
    const PixelRect view = figure_layout(1280, 720).view;
    std::array<int, 3> count{};
    for (int y = view.y; y < view.y + view.height; ++y)
        for (int x = view.x; x < view.x + view.width; ++x) {
            const Rgba8 color = pixel(image, x, y);
            count[0] += color == pass_reason_color(PassReason::triangles_meet, *figure.theme);
            count[1] += color == pass_reason_color(PassReason::loose_fit, *figure.theme);
            count[2] += color == pass_reason_color(PassReason::weak_test, *figure.theme);
        }
    return count;
}

TEST(InspectFigure, BarsHaveTheSharesOfTheWork) {
    Drawing drawing;
    for (const std::size_t frames : {1u, 8u}) {
        const auto [useful, fit, test] = bar_pixels(drawing, figure_of(frames, 100, 50));
        EXPECT_GT(test, 5000);
        EXPECT_NEAR(fit, 2 * test, test / 20);
        EXPECT_NEAR(useful, 2 * test, test / 20);
    }
    const auto [useful, fit, test] = bar_pixels(drawing, figure_of(8, 0, 0));
    EXPECT_GT(useful, 10000);
    EXPECT_EQ(fit + test, 0);
}

TEST(InspectFigure, BarsStandHoweverFewTheyAre) {
    Drawing drawing;
    const PixelRect view = figure_layout(1280, 720).view;
    for (const std::size_t frames : {2u, 3u, 4u, 20u}) {
        InspectFigure figure = figure_of(frames, 100, 50);
        figure.frames.front().found = example(400, 200, 0);
        const Image image = drawn(drawing, figure, 1280, 720);
        // Where bars begin, from the top, in the left and the right quarter.
        std::array<int, 2> top = {720, 720};
        for (int y = view.y; y < view.y + view.height / 2; ++y)
            for (int x = view.x; x < view.x + view.width; ++x)
                if (pixel(image, x, y) == pass_reason_color(PassReason::weak_test, *figure.theme)) {
                    if (x < view.x + view.width / 4) top[0] = std::min(top[0], y);
                    if (x > view.x + view.width * 3 / 4) top[1] = std::min(top[1], y);
                }
        EXPECT_LT(top[0] + 50, top[1]) << frames;
        EXPECT_LT(top[1], 720) << frames;
    }
}

TEST(InspectFigure, WrongRejectionsAreInTheAlarmColor) {
    Drawing drawing;
    for (const std::uint64_t wrong : {0u, 4u}) {
        const Image image = drawn(drawing, figure_of(2, 10, 10, wrong), 1280, 720);
        int alarms = 0;
        for (int y = 0; y < 720; ++y)
            for (int x = 0; x < 1280; ++x) alarms += pixel(image, x, y) == light_theme.warning;
        EXPECT_EQ(alarms > 100, wrong > 0);
    }
}

}  // namespace
}  // namespace scb::render
