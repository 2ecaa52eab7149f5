#include "core/analysis/assumed_time.h"

#include <gtest/gtest.h>

#include "core/analysis/cost_equation.h"

namespace scb {
namespace {

Collision query(std::uint64_t passed, std::uint64_t rejected, std::uint64_t n_p,
                std::size_t pairs) {
    Collision found;
    found.n_v = passed + rejected;
    found.n_p = n_p;
    found.stages[static_cast<std::size_t>(Stage::overlapping)] = passed;
    found.stages[static_cast<std::size_t>(Stage::ball_ball)] = rejected;
    found.pairs.resize(pairs);
    return found;
}

TEST(AssumedTime, IsTheSumOfTestsTrianglesAndPairs) {
    const Collision found = query(60, 40, 10, 3);
    EXPECT_EQ(assumed_time(VolumeKind::scb, {}, DescentRule::radius, found),
              60u * 28'000 + 40u * 6'000 + 10u * 45'000 + 3u * 215'000);
    const Work work = work_of(VolumeKind::scb, {}, DescentRule::radius, found);
    EXPECT_EQ(work, (Work{100, 10, operation_count(VolumeKind::scb, {}, found.stages),
                          assumed_time(VolumeKind::scb, {}, DescentRule::radius, found)}));
}

TEST(AssumedTime, DependsOnTheBoundAtWhichTestsEnd) {
    const auto time = [](VolumeKind volume, Stage stage) {
        Collision found;
        found.n_v = 1;
        found.stages[static_cast<std::size_t>(stage)] = 1;
        return assumed_time(volume, {}, DescentRule::radius, found);
    };
    EXPECT_LT(time(VolumeKind::scb, Stage::ball_ball), time(VolumeKind::scb, Stage::slab_cylinder));
    EXPECT_LT(time(VolumeKind::aabb_exact, Stage::axis_a2),
              time(VolumeKind::aabb_exact, Stage::axis_b0));
    // Of two slabs, the balls are before the line of centers.
    EXPECT_LT(time(VolumeKind::scb2, Stage::ball_ball), time(VolumeKind::scb2, Stage::center_line));
    EXPECT_LT(time(VolumeKind::dop26, Stage::center_line), time(VolumeKind::dop26, Stage::search));
}

TEST(AssumedTime, OfADescentByAreaIncludesTheMeasuresOfDivisions) {
    const Collision found = query(60, 40, 10, 3);
    const auto time = [&](DescentRule descent) {
        return assumed_time(VolumeKind::scb2, {}, descent, found);
    };
    // Ten of the pairs that passed are pairs of leaves.
    EXPECT_EQ(time(DescentRule::area), time(DescentRule::radius) + 50u * 430'000);
    EXPECT_EQ(time(DescentRule::volume), time(DescentRule::area));
    EXPECT_EQ(time(DescentRule::alternating), time(DescentRule::radius));
    // A query of a level tests no triangles; one of a body with itself skips neighbors.
    EXPECT_GE(assumed_time(VolumeKind::scb2, {}, DescentRule::area, query(1, 0, 5, 0)), 150'000u);
}

TEST(AssumedTime, EachVolumeAndTestHasOne) {
    for (const VolumeKind volume : all_volume_kinds())
        for (const OverlapTest test : all_overlap_tests())
            for (std::size_t stage = 0; stage < stage_count; ++stage) {
                Collision found;
                found.n_v = 1;
                found.stages[stage] = 1;
                const std::uint64_t time = assumed_time(volume, {test}, DescentRule::radius, found);
                EXPECT_GE(time, 6'000u);
                EXPECT_GE(time, least_test_time(volume, test));
            }
}

}  // namespace
}  // namespace scb
