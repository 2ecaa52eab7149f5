#include "core/analysis/traversal_part.h"

#include <gtest/gtest.h>

#include "tests/core/analysis/made_query.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

TEST(TraversalPart, IsTheQueryBelowATest) {
    const BuiltMesh mesh(height_field(9));
    for (const TraceHeader& header : queries_to_divide()) {
        const QueryTrace whole = record_frame(mesh, mesh, 3, pose_to_divide(), header);
        const Outcomes outcomes = outcomes_of(header, whole);
        const std::vector<std::uint32_t> sizes = subtree_sizes(whole.steps);
        for (std::uint32_t root = 0; root < sizes.size(); root += root < 20 ? 1 : 31) {
            const QueryTrace part = traversal_part(header, whole, root);
            EXPECT_EQ(part.found.n_v, sizes[root]);
            EXPECT_EQ(part.found.n_p, part.steps.items.size());
            ASSERT_FALSE(part.steps.volumes.empty());
            Step first = whole.steps.volumes[root];
            first.parent = no_step;
            EXPECT_EQ(part.steps.volumes[0], first);
            EXPECT_TRUE(std::includes(whole.found.pairs.begin(), whole.found.pairs.end(),
                                      part.found.pairs.begin(), part.found.pairs.end()));
            // As a query of its own it has the same tree.
            const Outcomes of_part = outcomes_of(header, part);
            const std::vector<std::uint32_t> part_sizes = subtree_sizes(part.steps);
            for (std::uint32_t i = 0; i < part_sizes.size(); ++i) {
                const auto at = test_of(whole.steps, part.steps.volumes[i].nodes);
                ASSERT_TRUE(at.has_value());
                EXPECT_EQ(part_sizes[i], sizes[*at]);
                EXPECT_EQ(of_part[i], outcomes[*at]);
            }
        }
        const QueryTrace all = traversal_part(header, whole, 0);
        EXPECT_EQ(all.steps, whole.steps);
        EXPECT_EQ(all.found.pairs, whole.found.pairs);
        EXPECT_EQ(all.found.n_u, whole.found.n_u);
        EXPECT_EQ(test_of(whole.steps, {100000, 0}), std::nullopt);
    }
}

TEST(TraversalPart, TheLargestAreApartAndNotTooLarge) {
    const BuiltMesh mesh(height_field(9));
    Pose pose;
    pose.translation = Vec3(0.3, 0.11, 0.02);
    const TraceHeader header = asking(VolumeKind::scb, OverlapTest::symmetric);
    const QueryTrace whole = record_frame(mesh, mesh, 3, pose, header);
    const std::vector<std::uint32_t> sizes = subtree_sizes(whole.steps);
    const std::vector<std::uint32_t> parts = largest_parts(whole.steps, 1000);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        EXPECT_LE(4 * sizes[parts[i]], sizes[0]);
        EXPECT_GT(4 * sizes[whole.steps.volumes[parts[i]].parent], sizes[0]);
        if (i > 0) {
            EXPECT_LE(sizes[parts[i]], sizes[parts[i - 1]]);
        }
        sum += sizes[parts[i]];
    }
    // All but the few tests above them.
    EXPECT_LT(sum, sizes[0]);
    EXPECT_GT(sum + 20, sizes[0]);
    EXPECT_EQ(largest_parts(whole.steps, 2),
              std::vector<std::uint32_t>(parts.begin(), parts.begin() + 2));
    EXPECT_TRUE(largest_parts({}, 8).empty());
}

TEST(TraversalPart, OfSeveralRootsThePartsOfEachAreFound) {
    MadeQuery query;
    for (std::uint32_t root = 0; root < 6; ++root) {
        query.test(MadeQuery::none, {root, root});
        if (root == 4) query.test(root, {root, 10});
    }
    // Of seven tests one is a quarter, two are more.
    EXPECT_EQ(largest_parts(query.frame.steps, 100),
              (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 6}));
    query.test(MadeQuery::none, {7, 7});
    EXPECT_EQ(largest_parts(query.frame.steps, 100),
              (std::vector<std::uint32_t>{4, 0, 1, 2, 3, 6, 7}))
        << "of eight two are a quarter";
}

TEST(TraversalPart, OfAnEnginesQueryTestsKeepTheirParentsAndTriangles) {
    MadeQuery query;
    query.test(MadeQuery::none, {0, 0});
    query.test(0, {1, 0});
    query.test(0, {2, 0});
    query.test(2, {3, 0});
    query.triangles({5, 5}, false);
    query.triangles({6, 5}, true);
    query.test(2, {4, 0}, false);
    const QueryTrace part = traversal_part(query.header, query.frame, 2);
    EXPECT_EQ(parents_of(part.steps), (std::vector<std::uint32_t>{MadeQuery::none, 0, 0}));
    EXPECT_EQ(part.steps.items, (std::vector<ItemStep>{{{5, 5}, 1, false}, {{6, 5}, 1, true}}));
    EXPECT_EQ(part.found.pairs, (std::vector<IndexPair>{{6, 5}}));
    EXPECT_EQ(part.found.n_v, 3u);
    EXPECT_EQ(part.found.n_p, 2u);
}

TEST(CostlyTests, AreThoseThatAreNamedThenThoseWithTheMostBelow) {
    // 0 led to 1 and 4, 1 to 2 and 3, 4 to 5.
    const Steps steps = steps_with_parents({no_step, 0, 1, 1, 0, 4});
    using Tests = std::vector<std::uint32_t>;
    EXPECT_EQ(costly_tests(steps, {}, 3), (Tests{0, 1, 4}));
    EXPECT_EQ(costly_tests(steps, Tests{5, 3}, 3), (Tests{0, 3, 5}));
    EXPECT_EQ(costly_tests(steps, Tests{5, 3}, 1), (Tests{5}));
    EXPECT_EQ(costly_tests(steps, Tests{0}, 2), (Tests{0, 1}));
    EXPECT_EQ(costly_tests(steps, {}, 100), (Tests{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(costly_tests(steps, {}, 0), (Tests{}));
}

}  // namespace

}  // namespace scb
