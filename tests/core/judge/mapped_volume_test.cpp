#include "core/judge/mapped_volume.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace scb {
namespace {

std::vector<NodeVolume> one_of_each() {
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
    Polytope hull{Vec3(1, 2, 3), {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, {}};
    return {Obb{Vec3(1, 2, 3), Mat3::Identity(), Vec3(1, 0.5, 0.25)},
            Ball{Vec3(1, -1, 0), 0.75},
            Capsule{Vec3(1, 1, 1), Vec3(0.5, 0.25, 0), 0.25},
            Rss{Vec3(0, 1, 0), {x, 0.5 * y}, 0.25},
            Scb{Vec3(1, 0, 0), 1, x, 0.5, -0.25},
            Scb2{Vec3(1, 0, 0), 1, {Slab{x, 0.5, -0.25}, Slab{y, 0.25, -0.5}}},
            std::make_shared<const Polytope>(
                slabs_polytope(std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0},
                               std::vector<double>{-1, 1, -1, 1, -1, 1, -1, 1})),
            std::make_shared<const Polytope>(hull)};
}

// The image of a point is inside of the mapped volume where the point is inside of the volume.
void expect_maps(const NodeVolume& volume, const Mat3& map) {
    const NodeVolume image = mapped(volume, map);
    ASSERT_TRUE(has_volume(image));
    Random random(3);
    int inside = 0;
    for (int i = 0; i < 500; ++i) {
        Vec3 p;
        for (int k = 0; k < 3; ++k) p[k] = random.uniform(-2, 4);
        const double before = excess(volume, p), after = excess(image, rotate(map, p));
        if (before > 0 && before < 1e-6) continue;
        EXPECT_EQ(before > 0, after > 1e-9);
        inside += before <= 0;
    }
    EXPECT_GT(inside, 0);
}

TEST(MappedVolume, AScaleAndAMirrorKeepEachKind) {
    for (const NodeVolume& volume : one_of_each())
        for (const Mat3& map : {Mat3(2 * Mat3::Identity()), Mat3(Vec3(-3, 3, 3).asDiagonal()),
                                Mat3(Vec3(0.5, 0.5, 0.5).asDiagonal())}) {
            SCOPED_TRACE(volume.index());
            expect_maps(volume, map);
            EXPECT_EQ(mapped(volume, map).index(), volume.index());
        }
}

TEST(MappedVolume, AShearKeepsBoxesAndPolytopes) {
    Mat3 shear = Mat3::Identity();
    shear(0, 1) = 0.5;
    shear(2, 2) = -2;
    for (const NodeVolume& volume : one_of_each()) {
        SCOPED_TRACE(volume.index());
        const bool is_flat_sided = std::holds_alternative<Obb>(volume) ||
                                   std::holds_alternative<std::shared_ptr<const Polytope>>(volume);
        if (is_flat_sided)
            expect_maps(volume, shear);
        else
            EXPECT_FALSE(has_volume(mapped(volume, shear)));
    }
    // A box along the axes that are scaled is a box.
    EXPECT_TRUE(
        std::holds_alternative<Obb>(mapped(one_of_each()[0], Mat3(Vec3(1, 2, 3).asDiagonal()))));
}

TEST(MappedVolume, AnOpenBoxStaysOpen) {
    const OpenBox half{Vec3(-HUGE_VAL, -HUGE_VAL, -HUGE_VAL), Vec3(HUGE_VAL, HUGE_VAL, 2)};
    const auto image = mapped(half, Mat3(Vec3(1, 1, -2).asDiagonal()));
    const auto* open = std::get_if<OpenBox>(&image);
    ASSERT_NE(open, nullptr);
    EXPECT_EQ(open->lower, Vec3(-HUGE_VAL, -HUGE_VAL, -4));
    EXPECT_EQ(open->upper[2], HUGE_VAL);
}

TEST(MappedVolume, TheScaleIsThatOfAllLengths) {
    EXPECT_NEAR(uniform_scale(Mat3(2 * Mat3::Identity())).value_or(0), 2, 1e-15);
    EXPECT_FALSE(uniform_scale(Mat3(Vec3(1, 2, 1).asDiagonal())));
    EXPECT_FALSE(uniform_scale(Mat3::Zero()));
    EXPECT_LT(determinant(Mat3(Vec3(-1, 1, 1).asDiagonal())), 0);
}

}  // namespace
}  // namespace scb
