#include "render/plots/length_histogram.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <numeric>

namespace scb::render {
namespace {

LengthHistogram some_lengths() {
    LengthHistogram lengths;
    lengths.root_diameter = 8;
    lengths.add(8, 8);
    lengths.add(4, 1);
    lengths.add(4, 0);
    lengths.add(1e-9, 1e-9);
    return lengths;
}

TEST(LengthHistogram, BinsAreHalvingsOfTheRootsDiameter) {
    const LengthHistogram lengths = some_lengths();
    EXPECT_EQ(lengths.diameters[0], 1u);
    EXPECT_EQ(lengths.diameters[LengthHistogram::per_halving], 2u);
    EXPECT_EQ(lengths.diameters.back(), 1u);
    EXPECT_EQ(lengths.thicknesses[0], 1u);
    EXPECT_EQ(lengths.thicknesses[3 * LengthHistogram::per_halving], 1u);
    EXPECT_EQ(lengths.thicknesses.back(), 2u);  // none, and one too small
    EXPECT_EQ(std::accumulate(lengths.diameters.begin(), lengths.diameters.end(), 0u), 4u);
    EXPECT_TRUE(lengths.differ);
}

TEST(LengthHistogram, WhatIsLargerThanTheRootCountsAsLarge) {
    LengthHistogram lengths;
    lengths.add(3, 3);
    EXPECT_EQ(lengths.diameters[0], 1u);
    EXPECT_FALSE(lengths.differ);
}

TEST(LengthHistogram, AThicknessOfRoundingNoiseIsNone) {
    LengthHistogram lengths;
    lengths.add(1, 1e-15);
    EXPECT_EQ(lengths.thicknesses.back(), 1u);
}

TEST(LengthHistogram, LengthsBesideARootWithoutSizeAreTheLargest) {
    LengthHistogram lengths;
    lengths.root_diameter = 0;
    lengths.add(1, 0);
    lengths.add(0, 0);
    lengths.add(HUGE_VAL, 1);
    EXPECT_EQ(lengths.diameters.front(), 2u);
    EXPECT_EQ(lengths.diameters.back(), 1u);
}

TEST(LengthHistogram, IsDrawnWithinItsRectangleOrNotAtAll) {
    for (const int width : {20, 120, 195, 300, 440})
        for (const int height : {20, 90, 140, 300}) {
            Overlay overlay;
            overlay.begin();
            const PixelRect rect{7, 9, width, height};
            const PixelRect covered =
                draw_length_histogram(overlay, rect, some_lengths(), {light_theme, 20});
            EXPECT_LE(covered.width, width);
            EXPECT_LE(covered.height, height);
            const bool drawn = overlay.draw_list().VtxBuffer.Size > 0;
            EXPECT_EQ(drawn, covered.height > 0) << width << " " << height;
            for (const ImDrawVert& v : overlay.draw_list().VtxBuffer) {
                const double x = v.pos.x, y = v.pos.y;
                EXPECT_TRUE(x >= rect.x && x <= rect.x + rect.width) << x;
                EXPECT_TRUE(y >= rect.y && y <= rect.y + rect.height) << y;
            }
        }
}

}  // namespace
}  // namespace scb::render
