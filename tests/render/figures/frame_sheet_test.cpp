#include "render/figures/frame_sheet.h"

#include <gtest/gtest.h>

#include "render/draw/image_operations.h"

namespace scb::render {
namespace {

TEST(FrameSheetLayout, FitsWhateverTheNumberOfCells) {
    for (const PixelRect& view :
         {PixelRect{20, 50, 900, 630}, {10, 40, 153, 180}, {10, 60, 380, 800}, {0, 0, 3000, 300}}) {
        const std::size_t most = most_frame_cells(view);
        EXPECT_FALSE(frame_sheet_layout(0, view));
        EXPECT_FALSE(frame_sheet_layout(most + 1, view));
        EXPECT_GT(most, 500u);
        for (const std::size_t cells : {std::size_t{1}, std::size_t{2}, std::size_t{5},
                                        std::size_t{6}, std::size_t{50}, std::size_t{500}, most}) {
            const auto layout = frame_sheet_layout(cells, view);
            ASSERT_TRUE(layout) << cells;
            EXPECT_TRUE(fits(*layout)) << cells << " " << layout->width << "x" << layout->height;
            EXPECT_GE(static_cast<std::size_t>(layout->columns * layout->bands), cells);
            EXPECT_LE(layout->x(layout->columns), layout->width);
            EXPECT_GE(layout->view_width, std::min(100, view.width)) << cells;
            EXPECT_LE(layout->view_width, view.width) << cells;
            EXPECT_NEAR(1.0 * layout->view_height / layout->view_width,
                        1.0 * view.height / view.width, 0.01);
        }
    }
}

TEST(Shrunk, PixelsAreMeansOfThePart) {
    Image image{5, 3, {}};
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x)
            for (const int value : {10 * x, 100 * y, x == 0 || y == 0 ? 255 : 7, 255})
                image.rgba.push_back(static_cast<std::uint8_t>(value));
    const Image half = shrunk(image, {1, 1, 4, 2}, 2, 1);
    EXPECT_EQ(half.rgba, (std::vector<std::uint8_t>{15, 150, 7, 255, 35, 150, 7, 255}));
    EXPECT_EQ(shrunk(image, {0, 0, 5, 3}, 5, 3), image);
}

TEST(FrameSheet, LegendHasEveryKeyOnceAndSaysWhereScalesDiffer) {
    const Rgba8 blue{0, 0, 255}, red{255, 0, 0};
    FrameSheet sheet;
    const auto texts = [&] {
        std::string all;
        for (const PanelKey& key : sheet.keys) all += key.text + ";";
        return all;
    };
    add_legend(sheet, {PanelHeading{"h"}, PanelRow{"body", {"A", "B"}, {blue, red}, true},
                       PanelRow{"N_v", {"7"}}, PanelKey{red, "meets"}});
    add_legend(sheet, {PanelKey{red, "meets"}, PanelLegendRow{blue, "rejected", "9", "1 %"}});
    // Counts differ from picture to picture.
    for (const char* count : {"3", "8"})
        add_legend(sheet, {PanelRow{"body", {"A", "B"}, {blue, red}, true},
                           PanelRow{"in pairs", {count, "2"}, {red, blue}}});
    EXPECT_EQ(texts(), "body A;body B;meets;rejected;in pairs, A;in pairs, B;");
    EXPECT_FALSE(sheet.scale);
    const PanelScale to_ten{"tests", {{0, "0"}, {1, "10"}}}, to_hundred{"tests", {{1, "100"}}};
    add_legend(sheet, {to_ten});
    add_legend(sheet, {to_ten});
    EXPECT_TRUE(sheet.scale);
    EXPECT_FALSE(sheet.scales_differ);
    add_legend(sheet, {to_hundred});
    add_legend(sheet, {to_hundred});
    EXPECT_TRUE(sheet.scales_differ);
    EXPECT_EQ(scale_end({PanelKey{red, "meets"}, to_ten}), "10");
    EXPECT_EQ(scale_end({PanelKey{red, "meets"}}), "");
}

}  // namespace
}  // namespace scb::render
