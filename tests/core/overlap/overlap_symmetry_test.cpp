#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/overlap/overlap_checks.h"

namespace scb {
namespace {

// Calls `use` with random pairs whose verdict does not depend on rounding.
template <class Use>
void for_decided_pairs(OverlapTest test, Use use) {
    Random random(14);
    int decided = 0, overlapping = 0;
    for (int i = 0; i < pairs_tried; ++i) {
        const VolumePair<Scb> pair = random_scb_pair(random);
        if (!is_decided(pair, test)) continue;
        ++decided;
        overlapping += !rejected(pair, test);
        use(pair);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(decided, pairs_tried * 99 / 100);
    EXPECT_GT(overlapping, pairs_tried / 4);
    EXPECT_LT(overlapping, pairs_tried * 3 / 4);
}

TEST(OverlapVerdict, OfSymmetricAndExtentsStaysWhenAAndBAreExchanged) {
    for (const OverlapTest test : {OverlapTest::symmetric, OverlapTest::extents})
        for_decided_pairs(test, [&](const VolumePair<Scb>& pair) {
            EXPECT_EQ(rejected(exchanged(pair), test), rejected(pair, test));
        });
}

TEST(OverlapVerdict, OfCorrectedSymmetricAndExtentsStaysWhenASlabIsFlipped) {
    for (const OverlapTest test :
         {OverlapTest::corrected, OverlapTest::symmetric, OverlapTest::extents})
        for_decided_pairs(test, [&](const VolumePair<Scb>& p) {
            // Signs change without rounding, so the stage stays too.
            const auto stage = stage_name(stage_of_pair(p, test));
            const Pose& pose = p.b_to_a;
            EXPECT_EQ(stage_name(stage_of_pair({flipped(p.a), p.b, pose}, test)), stage);
            EXPECT_EQ(stage_name(stage_of_pair({p.a, flipped(p.b), pose}, test)), stage);
            EXPECT_EQ(stage_name(stage_of_pair({flipped(p.a), flipped(p.b), pose}, test)), stage);
        });
}

TEST(OverlapVerdict, OfEveryTestStaysWhenBothAreMovedRigidly) {
    for (const OverlapTest test : all_overlap_tests()) {
        Random motions(15);
        for_decided_pairs(test, [&](const VolumePair<Scb>& p) {
            const Pose m = random_pose(motions, 10), frame = random_pose(motions, 10);
            EXPECT_EQ(rejected({placed(p.a, m), p.b, compose(m, p.b_to_a)}, test),
                      rejected(p, test));
            EXPECT_EQ(rejected({p.a, placed(p.b, frame), compose(p.b_to_a, inverse(frame))}, test),
                      rejected(p, test));
        });
    }
}

TEST(OverlapVerdict, OfEveryTestStaysWhenBothAreScaledByAPowerOfTwo) {
    Random random(16);
    for (int i = 0; i < pairs_tried / 4; ++i) {
        const VolumePair<Scb> p = random_scb_pair(random);
        const double factor = std::ldexp(1.0, static_cast<int>(random.below(200)) - 100);
        const VolumePair<Scb> q{scaled(p.a, factor),
                                scaled(p.b, factor),
                                {p.b_to_a.rotation, factor * p.b_to_a.translation}};
        for (const OverlapTest test : all_overlap_tests())
            ASSERT_EQ(stage_name(stage_of_pair(q, test)), stage_name(stage_of_pair(p, test)))
                << overlap_test_name(test) << " at " << factor;
    }
}

}  // namespace
}  // namespace scb
