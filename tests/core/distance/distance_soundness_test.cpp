#include <gtest/gtest.h>

#include "tests/core/distance/gap_tally.h"
#include "tests/core/distance/triangle_tally.h"
#include "tests/unless_sanitized.h"

// tests/stress/distance_soundness.cpp has the same with more pairs.
namespace scb {
namespace {

constexpr std::uint64_t volume_pairs = unless_sanitized<std::uint64_t>(10000, 500),
                        triangle_pairs = unless_sanitized<std::uint64_t>(10000, 500);

void expect_below(const GapTally& tally) {
    EXPECT_EQ(tally.above, 0) << tally.first_above;
    EXPECT_EQ(tally.loose, 0) << "the distances are not known";
    EXPECT_GT(tally.touching, volume_pairs / 20);
    EXPECT_GT(tally.positive, volume_pairs / 4);
}

TEST(DistanceSoundness, NoBoundOfVolumesIsAboveTheDistanceOfTwoPreciseInnerPoints) {
    print_gap_header();
    for (const VolumeKind kind : all_volume_kinds()) {
        SCOPED_TRACE(volume_kind_name(kind));
        const GapTally tally = tally_gaps(kind, 1, volume_pairs);
        print_tally(volume_kind_name(kind), tally);
        expect_below(tally);
        EXPECT_GT(tally.sum_of_shares / static_cast<double>(tally.pairs), 0.4);
        EXPECT_LT(tally.least_room, 150) << "the margin is far too large";
    }
}

TEST(DistanceSoundness, NoBoundOfPackedVolumesIsAboveTheDistanceOfTwoPreciseInnerPoints) {
    print_gap_header();
    for (const int slabs : {1, 2}) {
        SCOPED_TRACE(slabs);
        const GapTally tally = tally_packed_gaps(slabs, 1, volume_pairs);
        print_tally(slabs == 1 ? "packed scb" : "packed scb2", tally);
        expect_below(tally);
        const GapTally without = tally_packed_gaps(slabs, 1, volume_pairs, false);
        EXPECT_GE(without.above, unless_sanitized<std::uint64_t>(1, 0)) << "is a margin needed?";
    }
}

TEST(DistanceSoundness, DistancesOfTrianglesAreWithinTheStatedErrorOfProvenOnes) {
    print_triangle_header();
    for (std::size_t k = 0; k < triangle_pair_families.size(); ++k) {
        SCOPED_TRACE(triangle_pair_families[k].name);
        const TriangleTally tally =
            tally_triangles(triangle_pair_families[k], k + 1, triangle_pairs);
        print_tally(triangle_pair_families[k].name, tally);
        EXPECT_EQ(tally.wrong, 0) << tally.first_wrong;
        EXPECT_EQ(tally.unproven, 0);
        EXPECT_LT(tally.intersecting, tally.pairs);
    }
}

}  // namespace
}  // namespace scb
