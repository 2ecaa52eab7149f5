#include "core/analysis/depth_matrix.h"

#include <gtest/gtest.h>

#include "core/analysis/outcome.h"
#include "core/analysis/traversal_part.h"
#include "scb/any_collide.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

QueryTrace recorded(VolumeKind kind, TraceHeader& header) {
    static const BuiltMesh a(random_soup(1, 400, 0.15)), b(random_soup(2, 300, 0.15));
    header.volume = kind;
    return record_trace(a, b, header, {4}).frames[0];
}

/// The roots overlap and A's is divided; its first child is rejected, the second one overlaps and
/// B's root is divided; of the two pairs that follow one is rejected.
Steps small_query() {
    return {{{{0, 0}, 0, 0, Stage::overlapping, no_step},
             {{1, 0}, 1, 0, Stage::ball_ball, 0},
             {{2, 0}, 1, 0, Stage::overlapping, 0},
             {{2, 1}, 1, 1, Stage::overlapping, 2},
             {{2, 2}, 1, 1, Stage::slab_ball, 2}},
            {{{5, 7}, 3, true}}};
}

TEST(DepthMatrix, OfASmallQueryByHand) {
    const DepthMatrix matrix = depth_matrix(small_query());
    ASSERT_EQ(matrix.depths_a, 2u);
    ASSERT_EQ(matrix.depths_b, 2u);
    EXPECT_EQ(matrix.at(0, 0), (DepthCell{1, 0}));
    EXPECT_EQ(matrix.at(1, 0), (DepthCell{2, 1}));
    EXPECT_EQ(matrix.at(0, 1), (DepthCell{0, 0}));
    EXPECT_EQ(matrix.at(1, 1), (DepthCell{2, 1}));
}

TEST(DepthMatrix, SumsAreTheQuerysCounts) {
    for (const VolumeKind kind : all_volume_kinds()) {
        TraceHeader header;
        const QueryTrace frame = recorded(kind, header);
        const DepthMatrix matrix = depth_matrix(frame.steps);
        std::uint64_t tests = 0, rejected = 0;
        std::size_t deepest = 0;
        for (std::size_t b = 0; b < matrix.depths_b; ++b)
            for (std::size_t a = 0; a < matrix.depths_a; ++a) {
                tests += matrix.at(a, b).tests;
                rejected += matrix.at(a, b).rejected;
                EXPECT_LE(matrix.at(a, b).rejected, matrix.at(a, b).tests);
                if (matrix.at(a, b).tests > 0) deepest = std::max(deepest, a + b);
            }
        EXPECT_EQ(tests, frame.found.n_v);
        EXPECT_EQ(rejected, frame.found.n_v - frame.found.stages[0]);
        EXPECT_EQ(deepest, static_cast<std::size_t>(frame.found.depth));
        EXPECT_GT(rejected, 0u);
    }
}

TEST(DepthMatrix, OfNothingIsEmpty) {
    const DepthMatrix matrix = depth_matrix({});
    EXPECT_EQ(matrix.depths_a, 0u);
    EXPECT_TRUE(matrix.cells.empty());
    EXPECT_TRUE(coarser(matrix, 3).cells.empty());
}

TEST(DepthMatrix, CoarserCellsAddUp) {
    TraceHeader header;
    const DepthMatrix fine = depth_matrix(recorded(VolumeKind::scb, header).steps);
    const DepthMatrix coarse = coarser(fine, 3);
    ASSERT_EQ(coarse.depths_a, (fine.depths_a + 2) / 3);
    ASSERT_EQ(coarse.depths_b, (fine.depths_b + 2) / 3);
    std::vector<DepthCell> left = coarse.cells;
    for (std::size_t b = 0; b < fine.depths_b; ++b)
        for (std::size_t a = 0; a < fine.depths_a; ++a) {
            DepthCell& cell = left[b / 3 * coarse.depths_a + a / 3];
            cell.tests -= fine.at(a, b).tests;
            cell.rejected -= fine.at(a, b).rejected;
        }
    for (const DepthCell& cell : left) EXPECT_EQ(cell, DepthCell{});
}

TEST(TestSizes, OfASmallQueryByHand) {
    EXPECT_EQ(subtree_sizes(small_query()), (std::vector<std::uint32_t>{5, 1, 3, 1, 1}));
    EXPECT_TRUE(subtree_sizes({}).empty());
}

TEST(TestSizes, AreOneMoreThanThoseOfTheChildren) {
    for (const VolumeKind kind : all_volume_kinds())
        for (const std::size_t most : {std::numeric_limits<std::size_t>::max(), std::size_t{2}}) {
            TraceHeader header;
            header.options.max_pairs = most;
            const QueryTrace frame = recorded(kind, header);
            const std::vector<std::uint32_t> sizes = subtree_sizes(frame.steps);
            ASSERT_EQ(sizes.size(), frame.found.n_v);
            EXPECT_EQ(sizes[0], frame.found.n_v);
            std::vector<std::uint32_t> below(sizes.size(), 1);
            for (std::size_t i = 1; i < sizes.size(); ++i)
                below[frame.steps.volumes[i].parent] += sizes[i];
            EXPECT_EQ(sizes, below);
        }
}

}  // namespace
}  // namespace scb
