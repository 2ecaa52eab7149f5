#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>
#include <string>

#include "scb/overlap.h"
#include "scb/overlap_options.h"
#include "tests/core/overlap/scb2_tally.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

constexpr std::uint64_t pairs_per_scb2_family = unless_sanitized<std::uint64_t>(20000, 300);

std::string text_of(const VolumePair<Scb2>& pair) {
    std::ostringstream out;
    out << std::setprecision(17);
    for (const Scb2& s : {pair.a, pair.b}) {
        out << "c " << s.c.transpose() << " r " << s.r;
        for (const Slab& slab : s.slabs)
            out << " n " << slab.n.transpose() << " e " << slab.e << " f " << slab.f;
        out << '\n';
    }
    out << pair.b_to_a.rotation << "\n+ " << pair.b_to_a.translation.transpose() << '\n';
    return out.str();
}

TEST(OverlapOfTwoSlabs, RejectsNoPairThatOverlaps) {
    print_scb2_tally_header();
    Scb2Tally all;
    for (std::size_t k = 0; k < scb2_pair_families.size(); ++k) {
        const Scb2Tally tally = tally_scb2(scb2_pair_families[k], k + 1, pairs_per_scb2_family);
        print_tally(scb2_pair_families[k].name, tally);
        EXPECT_EQ(tally.unproven, 0) << scb2_pair_families[k].name;
        EXPECT_FALSE(tally.wrongly_rejected) << scb2_pair_families[k].name << ", the first:\n"
                                             << text_of(*tally.wrongly_rejected);
        all += tally;
    }
    print_tally("all", all);
    // Needles and discs some 1e-9 thick are no deeper in each other than that.
    EXPECT_LT(all.pairs[static_cast<std::size_t>(Contact::touching)],
              pairs_per_scb2_family * scb2_pair_families.size() / 30);
    for (const Stage stage : scb2_stages())
        EXPECT_GT(all.stages[static_cast<std::size_t>(stage)], 0u) << stage_name(stage);
    EXPECT_GT(all.stages[static_cast<std::size_t>(Stage::overlapping)], 0u);
}

// Two that share a point, up to rounding, and no more: however far from the origins, the margin
// keeps the pair.
TEST(OverlapOfTwoSlabs, KeepsPairsThatTouch) {
    Random random(21);
    for (const Scb2PairFamily& family : scb2_pair_families)
        for (std::uint64_t i = 0; i < pairs_per_scb2_family; ++i) {
            const VolumePair<Scb2> pair =
                scb2_pair_at_gap(random, family, 0, i % 2 == 0 ? 1 : 1000);
            ASSERT_EQ(stage_name(overlap(pair.a, pair.b, pair.b_to_a)), "overlapping")
                << family.name << " " << i << "\n"
                << text_of(pair);
        }
}

TEST(OverlapOfTwoSlabs, DoesNotChangeWithOrderFlipsMotionAndScale) {
    Random random(22);
    int rejected = 0;
    for (std::uint64_t i = 0; i < pairs_per_scb2_family; ++i) {
        const Scb2PairFamily& family = scb2_pair_families[i % scb2_pair_families.size()];
        const VolumePair<Scb2> p = random_scb2_pair(random, family);
        const auto rejects = [](const Scb2& a, const Scb2& b, const Pose& b_to_a) {
            return overlap(a, b, b_to_a) != Stage::overlapping;
        };
        const bool answer = rejects(p.a, p.b, p.b_to_a);
        // Where rounding may turn it, it says nothing: of long axes that are nearly parallel, the
        // product is that far from where it should be.
        const Vec3 long_b = transform_direction(p.b_to_a, long_axis(p.b));
        const double sine = std::sqrt(squared_norm(cross(long_axis(p.a), long_b)));
        const double tiny = 1e-12 * (p.a.r + p.b.r + 10) / std::max(sine, 1e-9);
        if (rejects(enlarged(p.a, tiny), p.b, p.b_to_a) != answer ||
            rejects(enlarged(p.a, -tiny), p.b, p.b_to_a) != answer)
            continue;
        rejected += answer;
        EXPECT_EQ(rejects(p.b, p.a, inverse(p.b_to_a)), answer) << text_of(p);
        EXPECT_EQ(rejects(flipped(p.a), p.b, p.b_to_a), answer) << text_of(p);
        EXPECT_EQ(rejects(p.a, flipped(flipped(flipped(p.b))), p.b_to_a), answer) << text_of(p);
        const Pose moved = random_pose(random);
        EXPECT_EQ(rejects(placed(p.a, moved), p.b, compose(moved, p.b_to_a)), answer) << text_of(p);
        const auto scaled = [](Scb2 s) {
            s.c *= 0x1p20;
            s.r *= 0x1p20;
            for (Slab& slab : s.slabs) {
                slab.e *= 0x1p20;
                slab.f *= 0x1p20;
            }
            return s;
        };
        EXPECT_EQ(
            rejects(scaled(p.a), scaled(p.b), {p.b_to_a.rotation, 0x1p20 * p.b_to_a.translation}),
            answer);
    }
    EXPECT_GT(rejected, static_cast<int>(pairs_per_scb2_family / 5));
}

}  // namespace
}  // namespace scb
