#include "core/overlap/overlap_figure8.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/core/overlap/overlap_checks.h"

namespace scb {
namespace {

// How many of the random pairs get another verdict from `change`.
template <class Verdict, class Change>
int verdicts_changed(Verdict verdict, Change change) {
    Random random(17);
    int changed = 0;
    for (int i = 0; i < pairs_tried; ++i) {
        const VolumePair<Scb> p = random_scb_pair(random);
        changed += verdict(p) != verdict(change(p));
    }
    return changed;
}

VolumePair<Scb> with_b_flipped(const VolumePair<Scb>& p) { return {p.a, flipped(p.b), p.b_to_a}; }

// Each of the two errors of Figure 8 alone is caught by flipping, which the corrected form stands;
// exchanging it does not stand, since the sign of d0 picks the sides of both slabs.
TEST(OverlapVerdict, OfEitherErrorOfFigure8ChangesWhenASlabIsFlipped) {
    const auto verdict = []<Figure8Errata errata>() {
        return [](const VolumePair<Scb>& p) {
            const Placement placed = placement(p.b_to_a, reach(p.a), reach(p.b));
            return overlap_figure8<errata>(p.a, p.b, placed, 0.7) != Stage::overlapping;
        };
    };
    const auto line_8 = verdict.operator()<Figure8Errata{true, false}>();
    const auto lines_20_23 = verdict.operator()<Figure8Errata{false, true}>();
    const auto both = verdict.operator()<Figure8Errata{true, true}>();
    const auto none = verdict.operator()<Figure8Errata{}>();
    EXPECT_GT(verdicts_changed(line_8, with_b_flipped), 100);
    EXPECT_GT(verdicts_changed(lines_20_23, with_b_flipped), 100);
    EXPECT_GT(verdicts_changed(both, with_b_flipped), 100);
    EXPECT_EQ(verdicts_changed(none, with_b_flipped), 0);

    EXPECT_GT(verdicts_changed(line_8, exchanged), 100);
    EXPECT_GT(verdicts_changed(both, exchanged), 100);
    EXPECT_GT(verdicts_changed(none, exchanged), 0);
}

TEST(OverlapVerdict, OfSymmetricRejectsWhateverCorrectedRejectsAndMore) {
    for (const double threshold : {0.0, 0.3, 0.7, 1.0}) {
        Random random(18);
        int corrected = 0, symmetric = 0;
        for (int i = 0; i < pairs_tried; ++i) {
            const VolumePair<Scb> p = random_scb_pair(random);
            corrected += rejected(p, OverlapTest::corrected, threshold);
            symmetric += rejected(p, OverlapTest::symmetric);
            if (!is_decided(p, OverlapTest::symmetric)) continue;
            if (rejected(p, OverlapTest::corrected, threshold)) {
                ASSERT_TRUE(rejected(p, OverlapTest::symmetric)) << i;
            }
        }
        EXPECT_GT(symmetric, corrected);
    }
}

TEST(OverlapVerdict, OfFigure8RejectsMoreTheLowerTheThreshold) {
    Random random(19);
    constexpr std::array thresholds = {0.0, 0.3, 0.7, 0.95, 1.0};
    std::array<int, thresholds.size()> count{};
    for (int i = 0; i < pairs_tried; ++i) {
        const VolumePair<Scb> p = random_scb_pair(random);
        bool before = true;
        for (std::size_t k = 0; k < thresholds.size(); ++k) {
            const Stage stage = stage_of_pair(p, OverlapTest::corrected, thresholds[k]);
            const bool now = stage != Stage::overlapping;
            count[k] += now;
            ASSERT_LE(now, before);
            before = now;
            if (thresholds[k] == 1.0) {
                EXPECT_NE(stage, Stage::slab_cylinder);
                EXPECT_NE(stage, Stage::cylinder_slab);
            }
        }
    }
    for (std::size_t k = 1; k < thresholds.size(); ++k) EXPECT_LT(count[k], count[k - 1]) << k;
}

TEST(Figure8, MakesCylinderTestsOnlyBeyondTheThreshold) {
    const double cosine = 0.8, sine = 0.6;
    const Scb a = slab_at({0, 0, 0}, 0.1, unit_z, 0.01, -0.01);
    for (const double sign : {-1.0, 1.0}) {
        const Scb b = slab_at({0, 0, 0.0995}, 0.1, sign * Vec3(sine, 0, cosine), 0.01, -0.01);
        expect_stage(a, b, Stage::slab_cylinder, OverlapTest::corrected, 0.79);
        expect_stage(a, b, Stage::overlapping, OverlapTest::corrected, 0.81);
    }
}

}  // namespace
}  // namespace scb
