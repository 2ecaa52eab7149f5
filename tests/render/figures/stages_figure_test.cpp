#include "render/figures/stages_figure.h"

#include <cstdlib>
#include <map>

#include "render/plots/icicle.h"
#include "tests/render/gl/gl_fixture.h"

namespace scb::render {
namespace {

constexpr int figure_width = 800, figure_height = 500;

StagesFigure figure_of(const std::vector<int>& frames) {
    StagesFigure figure;
    figure.title = "title";
    figure.groups = ending_groups(endings_of(VolumeKind::scb, {}), light_theme);
    figure.frames = frames;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EndingCounts counts{};
        counts[static_cast<std::size_t>(Stage::slab_ball)] = 100;
        counts[static_cast<std::size_t>(Stage::triangles_meet)] = i % 2 == 0 ? 100 : 300;
        figure.counts.push_back(counts);
    }
    return figure;
}

std::uint32_t key(Rgba8 color) {
    return static_cast<std::uint32_t>(color.r << 16 | color.g << 8 | color.b);
}

/// How many pixels of the plot have each color: left of the panel.
std::map<std::uint32_t, int> pixels_of(const StagesFigure& figure) {
    Drawing drawing;
    Overlay overlay;
    const Picture picture = compose(figure, figure_width, figure_height, overlay);
    const Image image = drawing.renderer.draw(picture, &overlay).image;
    std::map<std::uint32_t, int> pixels;
    for (int y = 0; y < figure_height; ++y)
        for (int x = 0; x < figure_width / 2; ++x) ++pixels[key(pixel(image, x, y))];
    return pixels;
}

TEST(StagesFigure, AreasAreProportionalToTheCounts) {
    // Few bars with gaps, and more frames than pixels.
    for (const int count : {40, 5000}) {
        std::vector<int> frames;
        for (int i = 0; i < count; ++i) frames.push_back(3 * i);
        std::map<std::uint32_t, int> pixels = pixels_of(figure_of(frames));
        const double slab = pixels[key(ending_color(Stage::slab_ball, light_theme))],
                     meet = pixels[key(ending_color(Stage::triangles_meet, light_theme))];
        EXPECT_GT(slab, 1000);
        EXPECT_NEAR(meet / slab, 2, 0.1) << count;
    }
}

TEST(StagesFigure, OneFrameAndNone) {
    EXPECT_GT(pixels_of(figure_of({7}))[key(ending_color(Stage::triangles_meet, light_theme))],
              1000);
    EXPECT_EQ(pixels_of(figure_of({}))[key(ending_color(Stage::triangles_meet, light_theme))], 0);
}

/// Every group that a picture can have, with its theme.
template <class Check>
void for_each_group(Check check) {
    for (const Theme* theme : {&light_theme, &dark_theme})
        for (const VolumeKind kind : all_volume_kinds())
            for (const OverlapTest test : all_overlap_tests()) {
                CollideOptions options;
                options.overlap.test = test;
                check(ending_groups(endings_of(kind, options), *theme), endings_of(kind, options),
                      *theme);
            }
}

TEST(EndingColors, TellGroupsApart) {
    for_each_group(
        [](const std::vector<EndingGroup>& groups, const std::vector<Stage>& all, const Theme&) {
            std::size_t endings = 0;
            for (std::size_t i = 0; i < groups.size(); ++i) {
                endings += groups[i].endings.size();
                EXPECT_FALSE(groups[i].label.empty());
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_NE(key(groups[i].color), key(groups[k].color)) << groups[i].label;
            }
            EXPECT_EQ(endings, all.size());
        });
}

TEST(EndingColors, StandOutFromTheBackgroundAndFromDividedPairs) {
    const auto distance = [](Rgba8 a, Rgba8 b) {
        return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
    };
    for_each_group(
        [&](const std::vector<EndingGroup>& groups, const std::vector<Stage>&, const Theme& theme) {
            for (const EndingGroup& group : groups) {
                EXPECT_GT(distance(group.color, theme.background), 150) << group.label;
                EXPECT_GT(distance(group.color, divided_color(theme)), 100) << group.label;
            }
        });
}

TEST(EndingColors, OnlyWhatIsLeftOverTakesTheThemes) {
    for (const Stage ending : endings_of(VolumeKind::scb, {})) {
        const Rgba8 light = ending_color(ending, light_theme),
                    dark = ending_color(ending, dark_theme);
        if (ending == Stage::left_over) {
            EXPECT_LT(light.g, 60);
            EXPECT_GT(dark.g, light.g + 100);
        } else {
            EXPECT_EQ(light, dark) << stage_name(ending);
        }
    }
}

}  // namespace
}  // namespace scb::render
