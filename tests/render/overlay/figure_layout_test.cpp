#include "render/overlay/figure_layout.h"

#include <gtest/gtest.h>

#include "render/figures/level_sheet.h"
#include "render/view/fit_camera.h"
#include "tests/render/overlay/overlay_fixture.h"

namespace scb::render {
namespace {

bool inside(const PixelRect& inner, int width, int height) {
    return inner.x >= 0 && inner.y >= 0 && inner.width > 0 && inner.height > 0 &&
           inner.x + inner.width <= width && inner.y + inner.height <= height;
}

TEST(FigureLayout, PartsAreInsideAndApartAtEverySize) {
    for (const auto& [width, height] : {std::pair{320, 240},
                                        {640, 480},
                                        {1280, 720},
                                        {512, 512},
                                        {400, 900},
                                        {3840, 400},
                                        {320, 4000},
                                        {8000, 6000}}) {
        const FigureLayout layout = figure_layout(width, height);
        for (const PixelRect* rect : {&layout.heading, &layout.view, &layout.panel})
            EXPECT_TRUE(inside(*rect, width, height)) << width << "x" << height;
        EXPECT_TRUE(apart(layout.heading, layout.view));
        EXPECT_TRUE(apart(layout.view, layout.panel));
        EXPECT_TRUE(apart(layout.heading, layout.panel));
        EXPECT_GE(layout.unit, 13);
        if (const auto square = detail_square(layout, layout.panel.y + 9 * layout.unit)) {
            EXPECT_TRUE(inside(*square, width, height)) << width << "x" << height;
            EXPECT_TRUE(apart(*square, layout.view)) << width << "x" << height;
        }
    }
}

TEST(LevelSheetLayout, FitsWhateverTheNumberOfCells) {
    for (const std::size_t volumes : {1u, 2u, 4u})
        for (const std::size_t levels : {1u, 2u, 5u, 6u, 13u, 17u, 40u, 90u})
            for (const bool detail : {false, true}) {
                const LevelSheetLayout layout = level_sheet_layout(volumes, levels, detail);
                EXPECT_LE(std::max(layout.width, layout.height), 8000) << volumes << " " << levels;
                EXPECT_GE(static_cast<std::size_t>(layout.columns * layout.bands), levels);
                EXPECT_GE(layout.view_width, 160);
                EXPECT_EQ(layout.detail_size > 0, detail);
            }
    // Flat bodies have flat views.
    EXPECT_LT(level_sheet_layout(1, 4, false, 2).view_height,
              level_sheet_layout(1, 4, false, 1).view_height);
    // Figure 6: four levels side by side.
    EXPECT_EQ(level_sheet_layout(2, 4, true).columns, 4);
    EXPECT_EQ(level_sheet_layout(2, 4, true).bands, 1);
}

TEST(NumberText, KeepsDigitsAndReadsWell) {
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(0.03), "0.0300");
    EXPECT_EQ(number_text(463.2), "463");
    EXPECT_EQ(number_text(1360), "1,360");
    EXPECT_EQ(number_text(-1360), "-1,360");
    EXPECT_EQ(number_text(2.5), "2.50");
    EXPECT_EQ(number_text(7.1e-5), "7.10e-05");
    EXPECT_EQ(number_text(1.5e8), "1.50e+08");
    EXPECT_EQ(count_text(999), "999");
    EXPECT_EQ(count_text(1000), "1,000");
    EXPECT_EQ(count_text(20480), "20,480");
    EXPECT_EQ(count_text(1234567), "1,234,567");
}

TEST(FittedText, CutsWholeCharactersAndSaysSo) {
    Overlay overlay;
    overlay.begin();
    const TextStyle style{20, FontWeight::regular, {0, 0, 0}};
    const std::string text = "ττττττττττ";
    EXPECT_EQ(fitted_text(overlay, text, style, 1000), text);
    const std::string cut = fitted_text(overlay, text, style, 60);
    EXPECT_LT(cut.size(), text.size());
    EXPECT_EQ(cut.substr(cut.size() - 3), "…");
    EXPECT_EQ((cut.size() - 3) % 2, 0u);
    EXPECT_LE(overlay.measure(cut, style).width, 60);
}

TEST(Marker, IsWhereTheDetailAppears) {
    const Camera camera = orbit_camera(0, 0, Vec3::Zero(), 10, true, 30);
    const PixelRect view{100, 50, 400, 200};
    const auto marker = marker_of(view, camera, Vec3::Zero(), camera.view_height / 10);
    ASSERT_TRUE(marker);
    EXPECT_NEAR(marker->x + marker->width / 2, 300, 1);
    EXPECT_NEAR(marker->y + marker->height / 2, 150, 1);
    EXPECT_NEAR(marker->width, 40, 1);
    EXPECT_FALSE(marker_of(view, camera, Vec3(0, -20, 0), 0.1));  // behind
    EXPECT_FALSE(marker_of(view, camera, Vec3(50, 0, 0), 0.1));   // outside
}

TEST(OrbitAxes, TurnWithTheAxisThatIsUp) {
    for (const Vec3& up : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ()),
                           Vec3(-Vec3::UnitZ()), Vec3(1, 2, 3)}) {
        const Mat3 axes = orbit_axes(30, 0, up);
        EXPECT_NEAR((axes.transpose() * axes - Mat3::Identity()).norm(), 0, 1e-14);
        EXPECT_NEAR((Vec3(axes.col(1)) - up / up.norm()).norm(), 0, 1e-14);
    }
    EXPECT_EQ(orbit_axes(30, 20, Vec3::UnitZ()), orbit_axes(30, 20));
}

TEST(WrappedText, BreaksAtSpacesAndLosesNoWord) {
    Overlay overlay;
    const TextStyle style{14, FontWeight::regular, {0, 0, 0}};
    const std::string text = "Compiled by GNU 12.2.0, -O3 -DNDEBUG -ffp-contract=off. One thread.";
    const std::vector<std::string> lines = wrapped_text(overlay, text, style, 150);
    EXPECT_GT(lines.size(), 2u);
    std::string together;
    for (const std::string& line : lines) {
        EXPECT_LE(overlay.measure(line, style).width, 150);
        together += (together.empty() ? "" : " ") + line;
    }
    EXPECT_EQ(together, text);
    EXPECT_TRUE(wrapped_text(overlay, "", style, 150).empty());
    // A word that is wider is cut.
    for (const std::string& line :
         wrapped_text(overlay, "a " + std::string(99, 'W') + " b", style, 150))
        EXPECT_LE(overlay.measure(line, style).width, 150);
}

}  // namespace
}  // namespace scb::render
