#include "tests/peers/pair_difference.h"

#include <gtest/gtest.h>

namespace scb {
namespace {

/// Triangles in the plane z = 0 for A; for B one that crosses it, one 1e-9 above it, one far off,
/// and one that is a point in it.
struct Meshes {
    Mesh a{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    Mesh b{{{0.2, 0.2, -1},
            {0.3, 0.2, 1},
            {0.2, 0.3, 1},
            {0, 0, 1e-9},
            {1, 0, 1e-9},
            {0, 1, 1e-9},
            {0, 0, 9},
            {1, 0, 9},
            {0, 1, 9},
            {0.1, 0.1, 0}},
           {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 9, 9}}};
    PairScene scene{a, b, Pose{}, 1e-6};
};

TEST(PairDifference, IsNoneForTheSamePairs) {
    const Meshes meshes;
    PairDifference difference;
    const std::vector<IndexPair> pairs = {{0, 0}, {0, 3}};
    add_frame(difference, pairs, pairs, meshes.scene);
    add_frame(difference, {}, {}, meshes.scene);
    EXPECT_TRUE(difference.none());
    EXPECT_EQ(difference.frames, 2u);
    EXPECT_EQ(difference.pairs, 2u);
}

TEST(PairDifference, TellsWhyAPairIsInOneAnswerOnly) {
    const Meshes meshes;
    PairDifference difference;
    const std::vector<IndexPair> reference = {{0, 0}, {0, 3}}, found = {{0, 1}, {0, 2}};
    add_frame(difference, reference, found, meshes.scene);
    EXPECT_FALSE(difference.none());
    EXPECT_EQ(difference.missing.count, 2u);
    EXPECT_EQ(difference.missing.degenerate, 1u);
    EXPECT_EQ(difference.missing.close, 0u);
    EXPECT_EQ(difference.extra.count, 2u);
    EXPECT_EQ(difference.extra.degenerate, 0u);
    EXPECT_EQ(difference.extra.close, 1u);
}

}  // namespace
}  // namespace scb
