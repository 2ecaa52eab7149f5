#include "render/figures/comparison_figure.h"

#include <gtest/gtest.h>

#include "render/draw/image_operations.h"

namespace scb::render {
namespace {

constexpr Rgba8 pure_red{255, 0, 0}, pure_green{0, 255, 0};

VolumeInstance ball(std::uint32_t id, Rgba8 color) { return {Ball{Vec3::Zero(), 1}, color, id}; }

using Ids = std::vector<std::uint32_t>;

TEST(PaneDifference, IsWhatOnlyOneHasOrHasInAnotherColor) {
    Pane a, b;
    a.volumes = {ball(9, pure_red), ball(2, pure_red), ball(4, pure_red), ball(0, pure_red)};
    b.volumes = {ball(4, pure_green), ball(9, pure_red), ball(7, pure_red), ball(0, pure_green)};
    EXPECT_EQ(differing_ids(a, b), (Ids{2, 4, 7}));
    EXPECT_EQ(differing_ids(b, a), (Ids{2, 4, 7}));
    EXPECT_EQ(differing_ids(a, a), Ids{});
}

TEST(PaneDifference, SeesTrianglesOfMeshes) {
    Pane a, b;
    for (Pane* pane : {&a, &b}) {
        MeshDraw mesh;
        mesh.first_id = 100;
        mesh.triangle_colors = {pure_red, pure_red, pure_green};
        pane->meshes.push_back(mesh);
    }
    EXPECT_EQ(differing_ids(a, b), Ids{});
    b.meshes[0].triangle_colors[2] = with_opacity(pure_green, 0.5);
    EXPECT_EQ(differing_ids(a, b), Ids{102});
}

bool inside(const PixelRect& inner, int width, int height) {
    return inner.x >= 0 && inner.y >= 0 && inner.width >= 1 && inner.height >= 0 &&
           inner.x + inner.width <= width && inner.y + inner.height <= height;
}

bool disjoint(const PixelRect& a, const PixelRect& b) {
    return a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y ||
           b.y + b.height <= a.y;
}

TEST(ComparisonLayout, PartsNeitherOverlapNorLeaveThePicture) {
    for (const auto& [width, height] :
         {std::pair{1280, 720}, {640, 480}, {320, 240}, {480, 800}, {320, 400}, {3840, 2160}})
        for (const ComparisonRows rows : {ComparisonRows{6, 5}, {6, 9}, {6, 13}}) {
            const ComparisonLayout layout = comparison_layout(width, height, rows);
            std::vector<PixelRect> parts = {layout.heading};
            for (const ComparisonLayout::Side& side : layout.sides)
                for (const PixelRect& part : {side.caption, side.view, side.numbers, side.legend})
                    parts.push_back(part);
            for (std::size_t i = 0; i < parts.size(); ++i) {
                EXPECT_TRUE(inside(parts[i], width, height)) << width << " part " << i;
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_TRUE(disjoint(parts[i], parts[j])) << width << " " << i << " " << j;
            }
            const PixelRect &a = layout.sides[0].view, &b = layout.sides[1].view;
            EXPECT_EQ(std::pair(a.width, a.height), std::pair(b.width, b.height));
            EXPECT_GE(a.height * 4, height / (height > width ? 2 : 1)) << "the subject is small";
        }
}

}  // namespace
}  // namespace scb::render
