#include "render/plots/ending_colors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scb::render {
namespace {

/// CIELAB of linear sRGB, white D65.
Vec3 lab(const Vec3& linear) {
    Mat3 to_xyz;
    to_xyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339,
        0.1191920, 0.9503041;
    const Vec3 xyz = to_xyz * linear, white(0.95047, 1, 1.08883);
    Vec3 f;
    for (int i = 0; i < 3; ++i) {
        const double t = xyz[i] / white[i];
        f[i] = t > 216.0 / 24389 ? std::cbrt(t) : t * 841 / 108 + 4.0 / 29;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

/// As most see it, and as a deuteranope does: Machado, Oliveira, Fernandes, "A
/// Physiologically-based Model for Simulation of Color Vision Deficiency", 2009, severity 1.
std::array<Vec3, 2> seen(Rgba8 color) {
    Vec3 linear;
    for (int i = 0; i < 3; ++i) {
        const double c = (i == 0 ? color.r : i == 1 ? color.g : color.b) / 255.0;
        linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    Mat3 deuteranope;
    deuteranope << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
        0.968881;
    const Vec3 turned = deuteranope * linear;
    return {lab(linear), lab(turned.cwiseMax(0.0).cwiseMin(1.0))};
}

TEST(EndingColors, OfSecondSlabsAreFarFromAllOthers) {
    for (const Theme* theme : {&light_theme, &dark_theme}) {
        std::vector<std::pair<std::string_view, Rgba8>> looks = {
            {"body A", body_a_color}, {"body B", body_b_color}, {"background", theme->background}};
        for (const EndingGroup& group : ending_groups(endings_of(VolumeKind::scb2, {}), *theme))
            looks.emplace_back(group.label, group.color);
        for (const Stage stage : {Stage::second_slab_a, Stage::second_slab_b}) {
            const Rgba8 own = ending_color(stage, *theme);
            std::size_t same = 0;
            for (const auto& [name, color] : looks) {
                same += color == own;
                if (color == own) continue;
                for (std::size_t eye = 0; eye < 2; ++eye)
                    EXPECT_GT((seen(own)[eye] - seen(color)[eye]).norm(), eye == 0 ? 30 : 25)
                        << stage_name(stage) << " and " << name << ", eye " << eye;
            }
            EXPECT_EQ(same, 1u) << stage_name(stage);
        }
    }
}

TEST(EndingColors, WhatIsLeftOverIsSeenToBeNoBall) {
    for (const Theme* theme : {&light_theme, &dark_theme}) {
        const Rgba8 ball = ending_color(Stage::ball_ball, *theme);
        // As it is, and as volumes have it.
        for (const double part : {1.0, 0.36}) {
            const Rgba8 left = mix(theme->background, theme->left_over, part);
            for (std::size_t eye = 0; eye < 2; ++eye)
                EXPECT_GT((seen(left)[eye] - seen(ball)[eye]).norm(), 15) << part << ' ' << eye;
        }
    }
}

}  // namespace
}  // namespace scb::render
