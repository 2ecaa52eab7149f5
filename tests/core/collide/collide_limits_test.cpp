#include <gtest/gtest.h>

#include <algorithm>

#include "core/collide/query_placement.h"
#include "core/overlap/test_functors.h"
#include "scb/level_cover.h"
#include "tests/core/collide/collide_checks.h"
#include "tests/core/overlap/volume_pairs.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

TEST(CollideMaxPairs, EndsTheQueryWithSoManyOfAllPairs) {
    const BuiltMesh a(random_soup(61, unless_sanitized(60, 45), unless_sanitized(0.4, 0.55))),
        b(random_soup(62, unless_sanitized(60, 45), unless_sanitized(0.4, 0.55)));
    const std::vector<IndexPair> all = brute_force(a.mesh, b.mesh, Pose{});
    ASSERT_GT(all.size(), 20u);
    for (QueryVariant variant : all_query_variants()) {
        SCOPED_TRACE(variant.name());
        const Collision whole = query(a, b, Pose{}, variant);
        std::uint64_t tests = 0;
        for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{7},
                                        all.size() - 1, all.size(), all.size() + 1}) {
            variant.options.max_pairs = count;
            StepRecorder recorder;
            const Collision found = query(a, b, Pose{}, variant, recorder);
            EXPECT_EQ(found.pairs.size(), std::min(count, all.size()));
            EXPECT_TRUE(
                std::includes(all.begin(), all.end(), found.pairs.begin(), found.pairs.end()));
            EXPECT_EQ(found.complete, count > all.size());
            expect_consistent(found, recorder.steps, a, b, Pose{}, variant);
            if (!found.complete) {
                // It ended at once, with the test that found the last pair.
                EXPECT_TRUE(recorder.steps.items.back().hit);
                EXPECT_EQ(recorder.steps.items.back().step + 1, recorder.steps.volumes.size());
            }
            EXPECT_GT(found.n_v, tests - (found.complete ? 1 : 0));
            tests = found.n_v;
        }
        EXPECT_LE(tests, whole.n_v);
    }
}

TEST(CollideMaxPairs, IsCompleteWhereNothingIsFound) {
    const BuiltMesh a(random_soup(61, 20, 0.1)), b(random_soup(62, 20, 0.1));
    for (QueryVariant variant : all_query_variants()) {
        variant.options.max_pairs = 1;
        const Collision found = query(a, b, {Mat3::Identity(), {9, 0, 0}}, variant);
        EXPECT_TRUE(found.pairs.empty());
        EXPECT_TRUE(found.complete);
        EXPECT_EQ(found.n_v, 1u);
    }
}

// Pairs of the two covers that overlap by the test itself, one by one.
std::vector<IndexPair> overlapping_in_covers(const BuiltMesh& a, const BuiltMesh& b,
                                             const Pose& pose, const QueryVariant& variant) {
    const int level = variant.options.stop_level;
    std::vector<IndexPair> pairs;
    std::visit(
        [&]<class V>(const Hierarchy<V>& p) {
            const auto& q = std::get<Hierarchy<V>>(b.hierarchies[variant.kind]);
            const Placement placed = query_placement(p, q, pose);
            with_overlap_test<V>(variant.options.overlap, [&](const auto& test) {
                for (const std::uint32_t i : level_cover(*p.topology, level))
                    for (const std::uint32_t j : level_cover(*q.topology, level))
                        if (test(p.volumes[i], q.volumes[j], placed) == Stage::overlapping)
                            pairs.push_back({i, j});
            });
        },
        a.hierarchies[variant.kind]);
    return pairs;
}

// The node of the cover that holds each triangle.
std::vector<std::uint32_t> cover_node_of(const Topology& topology, int level) {
    std::vector<std::uint32_t> node_of(topology.order.size());
    for (const std::uint32_t node : level_cover(topology, level))
        for (std::uint32_t k = 0; k < topology.nodes[node].count; ++k)
            node_of[topology.order[topology.nodes[node].first + k]] = node;
    return node_of;
}

// A volume may stick out of its parent's, so a pair that overlaps may have ancestors that do not.
// So the query finds some of the overlapping pairs of the two covers, among them every pair with
// triangles that intersect.
TEST(CollideStopLevel, FindsPairsOfTheCoversThatOverlapAndAllThatHoldIntersections) {
    const BuiltMesh a(random_soup(63, unless_sanitized(80, 55), unless_sanitized(0.4, 0.55))),
        b(random_soup(64, unless_sanitized(60, 50), unless_sanitized(0.4, 0.55)));
    Random random(65);
    const Pose pose = random_pose(random, 0.2);
    const std::vector<IndexPair> triangles = brute_force(a.mesh, b.mesh, pose);
    ASSERT_GT(triangles.size(), 20u);
    const int deepest = std::max(depth(a.topology()), depth(b.topology()));
    std::size_t left_out = 0;
    for (QueryVariant variant : all_query_variants())
        for (int level = 0; level <= deepest + 1; ++level) {
            variant.options.stop_level = level;
            SCOPED_TRACE(variant.name() + ", level " + std::to_string(level));
            StepRecorder recorder;
            const Collision found = query(a, b, pose, variant, recorder);
            const std::vector<IndexPair> covers = overlapping_in_covers(a, b, pose, variant);
            EXPECT_TRUE(std::includes(covers.begin(), covers.end(), found.pairs.begin(),
                                      found.pairs.end()));
            left_out += covers.size() - found.pairs.size();
            const auto node_a = cover_node_of(a.topology(), level),
                       node_b = cover_node_of(b.topology(), level);
            for (const IndexPair& t : triangles)
                EXPECT_TRUE(std::binary_search(found.pairs.begin(), found.pairs.end(),
                                               IndexPair{node_a[t.a], node_b[t.b]}));
            EXPECT_TRUE(found.complete);
            EXPECT_EQ(found.n_p, 0u);
            EXPECT_LE(found.depth, 2 * level);
            expect_consistent(found, recorder.steps, a, b, pose, variant);
            if (level == 0) {
                EXPECT_EQ(found.pairs, (std::vector<IndexPair>{{0, 0}}));
            }
            if (HasFailure()) return;
        }
    EXPECT_GT(left_out, 0u);  // else the sentence above says less than it could
}

TEST(CollideStopLevel, EndsAtMaxPairsToo) {
    const BuiltMesh a(random_soup(63, 80, 0.3));
    for (QueryVariant variant : all_query_variants()) {
        variant.options.stop_level = 3;
        const Collision all = query(a, a, Pose{}, variant);
        ASSERT_GT(all.pairs.size(), 8u);
        variant.options.max_pairs = 5;
        const Collision some = query(a, a, Pose{}, variant);
        EXPECT_EQ(some.pairs.size(), 5u);
        EXPECT_FALSE(some.complete);
        EXPECT_TRUE(std::includes(all.pairs.begin(), all.pairs.end(), some.pairs.begin(),
                                  some.pairs.end()));
    }
}

}  // namespace
}  // namespace scb
