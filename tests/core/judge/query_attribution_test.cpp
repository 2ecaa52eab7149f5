#include "core/judge/query_attribution.h"

#include <gtest/gtest.h>

#include "core/judge/engine_trace.h"
#include "tests/core/judge/judged_rows.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

Attribution attributed(const Rows& rows) {
    TraceHeader header;
    header.engine.emplace();
    const QueryTrace frame =
        trace_frame(rows.query, {{1, Stage::slab_a}, {2, Stage::slab_b}, {5, Stage::slab_ball}});
    return attribution(rows.query, rows.judged(), header, frame);
}

TEST(QueryAttribution, SaysOfEachTestThatPassedWhatCameOfIt) {
    auto nodes = nodes_of_row();
    Obb elsewhere = box_of_row(2, 3);
    elsewhere.center[2] = 5;
    nodes[2].volume = elsewhere;
    Rows rows(nodes);
    rows.contacts = {{0, 0}};
    rows.query.events = {{Kind::volumes, 0, 99, 0},  // no node
                         {Kind::volumes, 0, 0, 0},  {Kind::volumes, 0, 1, 1},
                         {Kind::volumes, 0, 3, 3},  {Kind::items_meet, 0, 0, 0},
                         {Kind::volumes, 0, 2, 2},  // passed although they are apart
                         {Kind::volumes, 0, 5, 5},  {Kind::items_apart, 0, 2, 2},
                         {Kind::volumes, 5, 6, 6}};  // rejected although they overlap
    const Attribution found = attributed(rows);
    ASSERT_EQ(found.passed.size(), 5u);
    const PassedPair &roots = found.passed[0], &above = found.passed[1], &leaves = found.passed[2],
                     &weak = found.passed[3], &loose = found.passed[4];
    for (const PassedPair* pair : {&roots, &above, &leaves}) {
        EXPECT_EQ(pair->reason, PassReason::triangles_meet);
        EXPECT_EQ(pair->exact, Contact::overlapping);
    }
    EXPECT_EQ(leaves.test, 2u) << "the test of no node is not in the frame";
    EXPECT_EQ(weak.reason, PassReason::weak_test);
    EXPECT_EQ(weak.exact, Contact::disjoint);
    EXPECT_GT(weak.gap, 4);
    EXPECT_EQ(weak.below.volume_tests, 2u);
    EXPECT_EQ(loose.reason, PassReason::loose_fit);
    EXPECT_EQ(loose.gap, 0);
    EXPECT_EQ(loose.within, PassReason::weak_test);
    ASSERT_EQ(found.wrongly_rejected.size(), 1u);
    EXPECT_EQ(found.wrongly_rejected[0].test, 5u);
    EXPECT_EQ(found.wrongly_rejected[0].exact, Contact::overlapping);
    EXPECT_EQ(found.wrongly_rejected[0].missed, 0u);
}

TEST(QueryAttribution, APairIsOfLeavesWhereBothNodesAre) {
    Rows rows;
    rows.query.events = {{Kind::volumes, 0, 0, 0},
                         {Kind::volumes, 0, 3, 0},
                         {Kind::volumes, 0, 0, 3},
                         {Kind::volumes, 0, 3, 3}};
    std::vector<bool> leaves;
    for (const PassedPair& pair : attributed(rows).passed) leaves.push_back(pair.leaves);
    EXPECT_EQ(leaves, (std::vector{false, false, false, true}));
}

TEST(QueryAttribution, AMissedPairIsBelowTheTestThatLostItAndAllAboveThat) {
    Rows rows;
    rows.query.events = {{Kind::volumes, 0, 0, 0},
                         {Kind::volumes, 0, 1, 1},
                         {Kind::volumes, 5, 3, 3},
                         {Kind::volumes, 5, 4, 4},
                         {Kind::volumes, 5, 2, 2}};
    const Attribution found = attributed(rows);
    ASSERT_EQ(found.passed.size(), 2u);
    for (const PassedPair& pair : found.passed) EXPECT_EQ(pair.reason, PassReason::triangles_meet);
    std::vector<std::uint64_t> missed;
    for (const WrongRejection& rejection : found.wrongly_rejected)
        missed.push_back(rejection.missed);
    EXPECT_EQ(missed, (std::vector<std::uint64_t>{1, 1, 2}));
}

TEST(QueryAttribution, APairThatATriangleTestLostIsBelowTheTestOfItsLeaves) {
    Rows rows;
    rows.contacts = {{0, 0}};
    rows.query.events = {{Kind::volumes, 0, 0, 0},
                         {Kind::volumes, 0, 1, 1},
                         {Kind::volumes, 0, 3, 3},
                         {Kind::items_apart, 0, 0, 0}};
    const Attribution found = attributed(rows);
    ASSERT_EQ(found.passed.size(), 3u);
    for (const PassedPair& pair : found.passed) EXPECT_EQ(pair.reason, PassReason::triangles_meet);
}

TEST(QueryAttribution, WithoutAVolumeNothingIsClaimed) {
    auto nodes = nodes_of_row();
    nodes[2].volume = NodeVolume{};
    Rows rows(nodes);
    rows.contacts = {};
    rows.query.events = {{Kind::volumes, 0, 0, 0}, {Kind::volumes, 0, 2, 2}};
    const Attribution found = attributed(rows);
    ASSERT_EQ(found.passed.size(), 1u);
    EXPECT_EQ(found.passed[0].test, 0u);
}

TEST(QueryAttribution, WithoutResultsNothingIsClaimed) {
    Rows rows;
    EXPECT_FALSE(attributed(rows).passed.empty());
    rows.query.has_item_tests = rows.query.has_pairs = false;
    EXPECT_TRUE(attributed(rows).passed.empty());
}

}  // namespace
}  // namespace scb
