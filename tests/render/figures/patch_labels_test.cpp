#include "render/figures/patch_labels.h"

#include <gtest/gtest.h>

namespace scb::render {
namespace {

/// At (0, 0, 10), looking down; the view is 2 high.
Camera camera_above() {
    Camera camera;
    camera.position = {0, 0, 10};
    camera.orthographic = true;
    return camera;
}

Segment point(const Vec3& at, std::uint32_t pair) { return {at, at, Rgba8{}, pair}; }

TEST(PatchLabels, StandWhereTheContactIsNearestToTheEye) {
    const std::vector<ContactPatch> patches = {{{0, 2}, {}}, {{1}, {}}};
    const auto labels = patch_labels(
        patches, {}, std::vector{point({0, 0, 0}, 0), point({0.5, 0, 3}, 1), point({0.2, 0, 2}, 2)},
        camera_above(), light_theme);
    ASSERT_EQ(labels.size(), 2u);
    EXPECT_EQ(labels[0].text, "1");
    EXPECT_EQ(labels[0].at, Vec3(0.2, 0, 2));
    EXPECT_EQ(labels[1].text, "2");
    EXPECT_EQ(labels[1].at, Vec3(0.5, 0, 3));
}

TEST(PatchLabels, KeepClearOfLargerPatches) {
    const std::vector<ContactPatch> patches = {{{0}, {}}, {{1, 2}, {}}, {{3}, {}}};
    const auto labels = patch_labels(patches, {},
                                     std::vector{point({0, 0, 5}, 0), point({0.01, 0, 4}, 1),
                                                 point({0.4, 0, 1}, 2), point({0, 0.01, 3}, 3)},
                                     camera_above(), light_theme);
    ASSERT_EQ(labels.size(), 3u);
    EXPECT_EQ(labels[1].at, Vec3(0.4, 0, 1));
    EXPECT_EQ(labels[2].at, Vec3(0, 0.01, 3)) << "there is no other place";
}

TEST(PatchLabels, AreOfTheLargestAlone) {
    std::vector<ContactPatch> patches;
    std::vector<Segment> contact;
    for (std::uint32_t i = 0; i < 30; ++i) {
        patches.push_back({{i}, {}});
        contact.push_back(point({i / 30.0, 0, 0}, i));
    }
    EXPECT_EQ(patch_labels(patches, {}, contact, camera_above(), light_theme).size(), 20u);
    const auto rows = patch_rows(patches);
    ASSERT_EQ(rows.size(), 9u);
    EXPECT_EQ(std::get<PanelRow>(rows.front()).values.front(), "30");
    EXPECT_EQ(std::get<PanelRow>(rows.back()).label, "pairs in others");
    EXPECT_EQ(std::get<PanelRow>(rows.back()).values.front(), "23");
}

}  // namespace
}  // namespace scb::render
