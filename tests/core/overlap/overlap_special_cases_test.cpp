#include <gtest/gtest.h>

#include "tests/core/overlap/overlap_checks.h"

namespace scb {
namespace {

TEST(Overlap, OfScbsWithOneCenterIsDecidedByTheirSlabs) {
    const Vec3 c(0.5, -0.25, 2);
    for (const OverlapTest test : sound_tests) {
        expect_stage(slab_at(c, 1, unit_z, 0.1, -0.1), slab_at(c, 2, unit_x, 0.1, -0.1),
                     Stage::overlapping, test);
        expect_stage(whole_ball_at(c, 1), whole_ball_at(c, 1), Stage::overlapping, test);
        expect_stage(whole_ball_at(c, 0), whole_ball_at(c, 0), Stage::overlapping, test);
    }
    // Caps on either side of the center that they share.
    const Scb upper = slab_at(c, 1, unit_z, 0.6, 0.5), lower = slab_at(c, 1, unit_z, -0.5, -0.6);
    for (const Scb& a : {upper, flipped(upper)})
        for (const Scb& b : {lower, flipped(lower)}) {
            expect_stage(a, b, Stage::slab_cylinder, OverlapTest::symmetric);
            expect_stage(b, a, Stage::slab_cylinder, OverlapTest::symmetric);
            expect_stage(a, b, Stage::slab_a, OverlapTest::extents);
            expect_stage(b, a, Stage::slab_a, OverlapTest::extents);
        }
}

TEST(Overlap, TakesPointsForScbsOfRadiusZero) {
    const Scb s = slab_at({0, 0, 0}, 1, unit_z, 0.25, -0.5);
    const auto point = [](const Vec3& p) { return slab_at(p, 0, unit_x, 0, 0); };
    for (const OverlapTest test : sound_tests) {
        for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0.25), Vec3(0, 0, -0.5), Vec3(1, 0, 0)})
            expect_stage(s, point(p), Stage::overlapping, test);
        const bool extents = test == OverlapTest::extents;
        expect_stage(s, point({1.001, 0, 0}), Stage::ball_ball, test);
        expect_stage(s, point({0, 0, 0.251}), extents ? Stage::slab_a : Stage::slab_ball, test);
        expect_stage(point({0, 0, -0.501}), s, extents ? Stage::slab_b : Stage::ball_slab, test);
    }
}

TEST(Overlap, TakesDiscsForScbsOfThicknessZero) {
    const Scb disc = slab_at({0, 0, 0}, 1, unit_z, 0, 0);
    for (const OverlapTest test : sound_tests) {
        expect_stage(disc, slab_at({0.5, 0, 0.001}, 1, unit_z, 0, 0),
                     test == OverlapTest::extents ? Stage::slab_a : Stage::slab_cylinder, test);
        expect_stage(disc, slab_at({0.5, 0, 0}, 1, unit_z, 0, 0), Stage::overlapping, test);
        expect_stage(disc, slab_at({0.5, 0, 0}, 1, unit_x, 0, 0), Stage::overlapping, test);
    }
}

// A slab that leaves the center out: the two caps face each other though the centers do not.
TEST(Overlap, HoldsForSlabsThatLeaveTheCenterOut) {
    const Scb cap = slab_at({0, 0, 0}, 1, unit_z, 1, 0.75);
    for (const OverlapTest test : {OverlapTest::symmetric, OverlapTest::extents}) {
        const Stage stage = test == OverlapTest::extents ? Stage::slab_a : Stage::slab_cylinder;
        expect_stage(cap, slab_at({0, 0, 0.5}, 1, unit_z, 0, -1), stage, test);
        expect_stage(cap, slab_at({0, 0, 0.5}, 1, unit_z, 0.5, -1), Stage::overlapping, test);
    }
    for (const OverlapTest test : sound_tests) {
        // Crossed: B's center is below A's slab, its slab above its center.
        expect_stage(cap, slab_at({0, 0, -0.5}, 1.5, unit_z, 1.5, 1.3), Stage::overlapping, test);
        expect_stage(cap, slab_at({0, 0, 2}, 1, -unit_z, 1, 0.75), Stage::overlapping, test);
    }
}

}  // namespace
}  // namespace scb
