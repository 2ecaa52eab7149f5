#include "core/explain/pair_explanation.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/core/overlap/overlap_checks.h"
#include "tests/core/overlap/random_scb_pairs.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

constexpr int many_explained = unless_sanitized(2000, 50);

TEST(Judged, ByWhatIsSo) {
    EXPECT_EQ(judged(Stage::overlapping, Contact::disjoint), Answer::false_positive);
    EXPECT_EQ(judged(Stage::ball_slab, Contact::overlapping), Answer::false_negative);
    for (const Stage stage : {Stage::overlapping, Stage::slab_a})
        EXPECT_EQ(judged(stage, Contact::touching), Answer::correct);
    EXPECT_EQ(judged(Stage::ball_ball, Contact::disjoint), Answer::correct);
    EXPECT_EQ(judged(Stage::overlapping, Contact::overlapping), Answer::correct);
}

TEST(PairExplanation, OnlyThePrintedTestMissesWhatOverlaps) {
    Random random(3);
    std::array<int, 5> missed{};
    for (int i = 0; i < many_explained; ++i) {
        const ScbPair pair = random_scb_pair(
            random, scb_pair_families[static_cast<std::size_t>(i) % scb_pair_families.size()]);
        const Placement placed = placement(pair.b_to_a, reach(pair.a), reach(pair.b));
        for (const OverlapTest test : {OverlapTest::symmetric, OverlapTest::printed}) {
            const PairExplanation found = explain(pair.a, pair.b, placed, {test, 0.7});
            ASSERT_EQ(found.tests.size(), 5u);
            for (const TestAnswer& t : found.tests) {
                EXPECT_EQ(t.stage, overlap(pair.a, pair.b, pair.b_to_a, {t.test, 0.7}));
                EXPECT_TRUE(t.test != test || t.answer == found.answer);
                missed[static_cast<std::size_t>(t.test)] += t.answer == Answer::false_negative;
            }
            EXPECT_EQ(found.verified, found.certificate.contact != Contact::touching);
        }
    }
    EXPECT_GT(missed[0], 0);
    for (std::size_t test = 1; test < 5; ++test) EXPECT_EQ(missed[test], 0) << test;
}

// Where rounding decides, far from the origin, no verdict is claimed against the test.
TEST(PairExplanation, FarFromTheOriginClosePairsTouch) {
    Random random(4);
    for (int i = 0; i < many_explained; ++i) {
        const ScbPair pair =
            touching_scb_pair(random, scb_pair_families[static_cast<std::size_t>(i) % 6], 1e9);
        const Placement placed = placement(pair.b_to_a, reach(pair.a), reach(pair.b));
        const PairExplanation found = explain(pair.a, pair.b, placed, {OverlapTest::corrected});
        EXPECT_NE(found.answer, Answer::false_negative);
    }
}

TEST(PairExplanation, OfBallsAndBoxesIsCorrect) {
    const Ball a{Vec3(1, 0, 0), 1}, b{Vec3(1, 0, 2.5), 1};
    const PairExplanation apart = explain(a, b, placement(Pose{}, reach(a), reach(b)));
    EXPECT_EQ(apart.certificate.contact, Contact::disjoint);
    EXPECT_NEAR(apart.certificate.margin, 0.5, 1e-9);
    EXPECT_EQ(apart.answer, Answer::correct);
    EXPECT_TRUE(apart.tests.empty() && apart.verified);
    const Obb box{Vec3::Zero(), Mat3::Identity(), Vec3(1, 2, 3)};
    const PairExplanation same = explain(box, box, placement(Pose{}, reach(box), reach(box)));
    EXPECT_EQ(same.certificate.contact, Contact::overlapping);
    EXPECT_NEAR(same.certificate.margin, 2, 1e-9);
    EXPECT_EQ(same.answer, Answer::correct);
}

// Two balls 0.5 apart, each turned into a slab: points have no size to compare a gap with.
TEST(PairExplanation, OfPoints) {
    const Scb point{Vec3(1, 2, 3), 0, Vec3::UnitZ(), 0, 0};
    Scb other = point;
    const auto explained = [&] {
        return explain(point, other, placement(Pose{}, reach(point), reach(other)), {});
    };
    EXPECT_EQ(explained().certificate.contact, Contact::touching);
    other.c[0] += 0.5;
    EXPECT_EQ(explained().certificate.contact, Contact::disjoint);
    EXPECT_EQ(explained().answer, Answer::correct);
}

}  // namespace
}  // namespace scb
