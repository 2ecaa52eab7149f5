#include "scb/overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "scb/collide.h"
#include "tests/core/overlap/overlap_checks.h"

namespace scb {
namespace {

TEST(Overlap, OfTwoBallsEndsAtTheirDistance) {
    expect_stage(Ball{Vec3(0, 0, 0), 1}, Ball{Vec3(0, 3, 4), 3.9}, Stage::ball_ball);
    expect_stage(Ball{Vec3(0, 0, 0), 1}, Ball{Vec3(0, 3, 4), 4.1}, Stage::overlapping);
    expect_stage(Ball{Vec3(1, 1, 1), 0}, Ball{Vec3(1, 1, 1), 0}, Stage::overlapping);
}

TEST(Overlap, OfScbsEndsWhereTheBallsAreApart) {
    for (const OverlapTest test : all_overlap_tests())
        for (const Vec3& c : {Vec3(2.01, 0, 0), Vec3(0, 0, -2.01)}) {
            expect_stage(slab_at({0, 0, 0}, 1, unit_z, 0.25, -0.25), whole_ball_at(c, 1),
                         Stage::ball_ball, test);
            expect_stage(whole_ball_at(c, 1), slab_at({0, 0, 0}, 1, unit_x, 0.25, -0.25),
                         Stage::ball_ball, test);
        }
}

TEST(Overlap, OfScbsEndsWhereABallIsAboveOrBelowASlab) {
    const Scb slab = slab_at({0, 0, 0}, 1, unit_z, 0.25, -0.5);
    for (const Scb& ball : {whole_ball_at({0.3, 0, 1.3}, 1), whole_ball_at({0.3, 0, -1.55}, 1)}) {
        for (const OverlapTest test : all_overlap_tests()) {
            if (test == OverlapTest::extents) continue;
            expect_stage(slab, ball, Stage::slab_ball, test);
            expect_stage(ball, slab, Stage::ball_slab, test);
        }
        expect_stage(slab, ball, Stage::slab_a, OverlapTest::extents);
        Scb turned = ball;
        turned.n = unit_x;
        expect_stage(turned, slab, Stage::slab_b, OverlapTest::extents);
    }
    for (const OverlapTest test : sound_tests) {
        expect_stage(slab, whole_ball_at({0.3, 0, 1.2}, 1), Stage::overlapping, test);
        expect_stage(slab, whole_ball_at({0.3, 0, -1.45}, 1), Stage::overlapping, test);
    }
}

// A large ball with a slab high above its center, a small ball in it: its own radius must not be
// taken for the other's, as line 8 does in print.
TEST(Overlap, MeasuresTheBallOfAAgainstTheSlabOfBByTheRadiusOfA) {
    const Scb a = whole_ball_at({0, 0, 0}, 2), b = slab_at({0, 0, -0.5}, 1, unit_z, 1, 0.9);
    // A point of both.
    EXPECT_TRUE(contains(a, Vec3(0, 0, 0.45)) && contains(b, Vec3(0, 0, 0.45)));
    const Scb low = slab_at({0, 0, 1}, 0.5, unit_z, 0.5, 0.1);
    EXPECT_TRUE(contains(a, Vec3(0, 0, 1.2)) && contains(low, Vec3(0, 0, 1.2)));
    for (const OverlapTest test : sound_tests) {
        expect_stage(a, b, Stage::overlapping, test);
        expect_stage(a, low, Stage::overlapping, test);
    }
    expect_stage(a, low, Stage::ball_slab, OverlapTest::printed);
}

TEST(Overlap, OfScbsEndsWhereTwoParallelSlabsAreApart) {
    const Scb a = slab_at({0, 0, 0}, 1, unit_z, 0.25, -0.25);
    for (const double side : {-1.0, 1.0})
        for (const bool opposed : {false, true}) {
            const Scb b =
                slab_at({0.1, 0, side * 0.6}, 1, opposed ? Vec3(-unit_z) : unit_z, 0.25, -0.25);
            const Scb near = slab_at({0.1, 0, side * 0.45}, 1, b.n, 0.25, -0.25);
            for (const OverlapTest test : slab_cylinder_tests) {
                expect_stage(a, b, Stage::slab_cylinder, test);
                expect_stage(a, near, Stage::overlapping, test);
            }
            expect_stage(a, b, Stage::slab_cylinder, OverlapTest::printed);
            expect_stage(a, b, Stage::slab_a, OverlapTest::extents);
            expect_stage(a, near, Stage::overlapping, OverlapTest::extents);
        }
}

// A is small and tilted against the large flat B: the cylinder about A stays clear of B's slab,
// though its ball does not, and though B's cylinder reaches A's slab.
TEST(Overlap, OfScbsEndsWhereATiltedCylinderIsOffASlab) {
    const double cosine = 12.0 / 13, sine = 5.0 / 13;
    for (const double side : {-1.0, 1.0})
        for (const double sign : {-1.0, 1.0}) {
            const bool opposed = sign < 0;
            const Scb a =
                slab_at({0, 0, side * 0.25}, 0.2, sign * Vec3(sine, 0, cosine), 0.05, -0.05);
            const Scb b = slab_at({0, 0, 0}, 1, unit_z, 0.1, -0.1);
            expect_stage(a, b, Stage::cylinder_slab, OverlapTest::corrected);
            expect_stage(a, b, Stage::cylinder_slab, OverlapTest::symmetric);
            expect_stage(a, b, Stage::slab_b, OverlapTest::extents);
            // Lines 20 and 23 as printed never reject.
            expect_stage(a, b, opposed ? Stage::cylinder_slab : Stage::overlapping,
                         OverlapTest::line8);
            const Scb nearer =
                slab_at({0, 0, side * 0.21}, 0.2, sign * Vec3(sine, 0, cosine), 0.05, -0.05);
            for (const OverlapTest test : sound_tests)
                expect_stage(nearer, b, Stage::overlapping, test);
        }
}

TEST(Overlap, ByExtentsEndsWhereTheLineOfCentersSeparates) {
    const double sine = std::sqrt(0.75);
    const Scb a = slab_at({0, 0, 0}, 1, Vec3(0.5, sine, 0), 0.2, -1);
    const auto b = [&](double at) { return slab_at({at, 0, 0}, 1, Vec3(-0.5, sine, 0), 0.2, -1); };
    const double reach = 2 * (0.2 * 0.5 + std::sqrt(0.96 * 0.75));
    expect_stage(a, b(reach + 0.01), Stage::center_line, OverlapTest::extents);
    expect_stage(a, b(reach - 0.01), Stage::overlapping, OverlapTest::extents);
    for (const OverlapTest test : slab_cylinder_tests)
        expect_stage(a, b(reach + 0.01), Stage::overlapping, test);
}

TEST(Names, OfTestsStagesAndRulesAreReadBack) {
    std::set<std::string_view> names;
    for (const OverlapTest test : all_overlap_tests()) {
        EXPECT_EQ(overlap_test_of(overlap_test_name(test)), test);
        names.insert(overlap_test_name(test));
    }
    EXPECT_EQ(names.size(), all_overlap_tests().size());
    EXPECT_FALSE(overlap_test_of("exact"));
    EXPECT_FALSE(overlap_test_of(""));

    names.clear();
    for (std::size_t s = 0; s < named_stage_count; ++s) {
        const Stage stage = static_cast<Stage>(s);
        EXPECT_EQ(stage_of(stage_name(stage)), stage);
        names.insert(stage_name(stage));
    }
    EXPECT_EQ(names.size(), named_stage_count);
    EXPECT_FALSE(stage_of("ball_ball"));

    for (const DescentRule rule : all_descent_rules())
        EXPECT_EQ(descent_rule_of(descent_rule_name(rule)), rule);
    EXPECT_EQ(all_descent_rules().size(), 4u);
    EXPECT_FALSE(descent_rule_of("Radius"));
}

TEST(Stages, OfEveryTestAreListedInTheOrderInWhichTheyAreTried) {
    for (const OverlapTest test : all_overlap_tests()) {
        const auto stages = stages_of(test);
        EXPECT_TRUE(std::is_sorted(stages.begin(), stages.end()));
        EXPECT_EQ(stages.front(), Stage::ball_ball);
    }
    EXPECT_EQ(ball_stages().size(), 1u);
    EXPECT_EQ(obb_stages().size(), 15u);
    EXPECT_EQ(obb_stages().front(), Stage::axis_a0);
    EXPECT_EQ(obb_stages().back(), Stage::axis_a2_b2);
}

}  // namespace
}  // namespace scb
