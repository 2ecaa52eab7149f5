#include "core/overlap/overlap_extents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "tests/core/overlap/overlap_checks.h"

namespace scb {
namespace {

TEST(ReachAtCosine, IsTheExtentAndNeverLess) {
    Random random(20);
    for (int i = 0; i < 100000; ++i) {
        const Scb s = random_scb(random, random_unit_vector(random));
        Vec3 d = random_unit_vector(random);
        const std::uint32_t kind = random.below(4);
        if (kind == 0) d = s.n;
        if (kind == 1) d = (s.n + 1e-7 * d).normalized();
        if (random.below(2) == 0) d = -d;
        const double exact = support(s, d), found = reach_at_cosine(s, dot(s.n, d), 1 + 0x1p-47);
        ASSERT_GE(found, exact - 1e-15);
        // The bound of the squared sine is 2^-47 above 1, which is 9e-8 of the radius.
        ASSERT_LE(found, exact + 1e-7 * s.r);
        if (kind > 1) {
            ASSERT_NEAR(found, exact, 1e-11);
        }
    }
}

TEST(OverlapByExtents, EndsAtTheFirstOfItsAxesThatSeparatesTheExtents) {
    Random random(21);
    std::set<Stage> seen;
    int undecided = 0;
    for (int i = 0; i < pairs_tried; ++i) {
        const VolumePair<Scb> p = random_scb_pair(random);
        const Scb b = placed(p.b, p.b_to_a);
        const Vec3 c = b.c - p.a.c;
        const auto gap = [&](const Vec3& d) {
            return dot(d, c) - support(p.a, d) - support(b, -d);
        };
        const auto gap_both = [&](const Vec3& n) { return std::max(gap(n), gap(-n)); };
        const std::array<double, 4> gaps = {c.norm() - p.a.r - b.r, gap_both(p.a.n), gap_both(b.n),
                                            gap(c.normalized())};
        if (std::any_of(gaps.begin(), gaps.end(), [](double g) { return std::abs(g) < 1e-6; })) {
            ++undecided;
            continue;
        }
        Stage stage = Stage::overlapping;
        for (std::size_t k = gaps.size(); k-- > 0;)
            if (gaps[k] > 0) stage = stages_of(OverlapTest::extents)[k];
        ASSERT_EQ(stage_name(stage_of_pair(p, OverlapTest::extents)), stage_name(stage)) << i;
        seen.insert(stage);
    }
    EXPECT_EQ(seen.size(), 5u);
    EXPECT_LT(undecided, pairs_tried / 1000);
}

}  // namespace
}  // namespace scb
