#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/packed/packed_query.h"
#include "scb/triangle_overlap.h"
#include "tests/core/geometry/triangle_pairs.h"
#include "tests/core/packed/touching_triangles.h"

namespace scb {
namespace {

// Triangles that touch, or nearly so. What is decided on is gone from the undecided.
TEST(DoublePairs, AreDecidedOnlyWhereTheExactTestDecidesSo) {
    Random random(5);
    Mesh a, b;
    std::vector<IndexPair> all, expected;
    for (std::uint32_t t = 0; t < static_cast<std::uint32_t>(200'000 / effort); ++t) {
        const TrueCorners truth = touching(random);
        const Vec3 at =
            std::ldexp(1.0, static_cast<int>(random.below(40)) - 20) * grid_point(random);
        // Not by whole numbers any more: all sums round.
        const double size = 0.1 + random.uniform();
        for (std::size_t i = 0; i < 3; ++i) {
            a.vertices.push_back(size * corner_p(truth, i) + at);
            b.vertices.push_back(size * corner_q(truth, i) + at);
        }
        for (Mesh* mesh : {&a, &b}) mesh->triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        all.push_back({t, t});
        if (triangles_overlap(corners(a, t), corners(b, t))) expected.push_back({t, t});
    }
    for (const SimdLevel level : available_simd_levels()) {
        PackedFindings found;
        found.undecided = all;
        decide_in_doubles(a, b, Pose{}, level, found);
        EXPECT_GT(found.pairs.size(), expected.size() / 4) << simd_level_name(level);
        EXPECT_LT(found.undecided.size(), all.size() / 2) << simd_level_name(level);
        EXPECT_GT(found.undecided.size(), 0u) << "some touch";
        for (const IndexPair& pair : found.undecided)
            if (triangles_overlap(corners(a, pair.a), corners(b, pair.b)))
                found.pairs.push_back(pair);
        std::sort(found.pairs.begin(), found.pairs.end());
        EXPECT_EQ(found.pairs, expected) << simd_level_name(level);
    }
}

}  // namespace
}  // namespace scb
