#include "core/judge/engine_trace.h"

#include <gtest/gtest.h>

#include "tests/core/analysis/made_query.h"
#include "tests/core/judge/judged_rows.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

constexpr std::uint32_t none = no_step;

TEST(EngineTrace, HasTheTestsInTheirOrderAndWhatLedToEach) {
    Rows rows;
    rows.query.frame = 7;
    rows.query.events = {{Kind::volumes, 0, 0, 0},    {Kind::volumes, 5, 1, 2},
                         {Kind::volumes, 0, 1, 1},    {Kind::volumes, 0, 3, 3},
                         {Kind::items_meet, 0, 0, 0}, {Kind::volumes, 6, 3, 4},
                         {Kind::pair, 0, 0, 0}};
    const QueryTrace frame = trace_frame(rows.query, {{5, Stage::slab_ball}, {6, Stage::slab_a}});
    EXPECT_EQ(frame.frame, 7);
    EXPECT_EQ(frame.steps.volumes, (std::vector<Step>{{{0, 0}, 0, 0, Stage::overlapping, none},
                                                      {{1, 2}, 1, 1, Stage::slab_ball, 0},
                                                      {{1, 1}, 1, 1, Stage::overlapping, 0},
                                                      {{3, 3}, 2, 2, Stage::overlapping, 2},
                                                      {{3, 4}, 2, 2, Stage::slab_a, 2}}));
    EXPECT_EQ(frame.steps.items, (std::vector<ItemStep>{{{0, 0}, 3, true}}));
    EXPECT_EQ(frame.found.pairs, (std::vector<IndexPair>{{0, 0}}));
    EXPECT_EQ(frame.found.n_v, 5u);
    EXPECT_EQ(frame.found.n_p, 1u);
    EXPECT_EQ(frame.found.depth, 4);
    EXPECT_EQ(frame.found.stages[0], 3u);
    EXPECT_EQ(frame.found.stages[static_cast<std::size_t>(Stage::slab_ball)], 1u);
    EXPECT_TRUE(frame.found.complete);
}

TEST(EngineTrace, StepsHaveTheParentsThatTheEngineRecorded) {
    Rows rows;
    rows.query.events = {{Kind::volumes, 0, 99, 0},
                         {Kind::volumes, 0, 0, 0},
                         {Kind::volumes, 0, 1, 1},
                         {Kind::volumes, 0, 1, 1, 1},
                         {Kind::volumes, 0, 3, 3, 2}};
    const QueryTrace frame = trace_frame(rows.query, {});
    EXPECT_EQ(parents_of(frame.steps), (std::vector<std::uint32_t>{none, 0, 0, 1}))
        << "not the latest; the first test is of no node";
}

TEST(EngineTrace, LeavesOutTestsOfNodesThatThereAreNot) {
    Rows rows;
    rows.query.events = {{Kind::volumes, 0, 99, 0},   {Kind::volumes, 0, 0, 0},
                         {Kind::volumes, 0, 1, 99},   {Kind::volumes, 0, 1, 1},
                         {Kind::volumes, 0, 3, 3},    {Kind::items_apart, 0, 0, 0},
                         {Kind::items_apart, 0, 9, 0}};
    const QueryTrace frame = trace_frame(rows.query, {});
    EXPECT_EQ(frame.steps.volumes.size(), 3u);
    EXPECT_EQ(frame.found.n_v, 3u);
    EXPECT_EQ(parents_of(frame.steps), (std::vector<std::uint32_t>{none, 0, 1}));
    EXPECT_EQ(frame.steps.items, (std::vector<ItemStep>{{{0, 0}, 2, false}}));
    EXPECT_EQ(frame.found.n_p, 2u) << "the engine made the test of no triangle, too";
}

TEST(EngineTrace, TestsOfTrianglesFollowThoseOfTheirLeaves) {
    Rows rows;
    rows.query.events = {{Kind::volumes, 0, 4, 4},
                         {Kind::volumes, 0, 3, 3},
                         {Kind::items_apart, 0, 0, 0},
                         {Kind::items_meet, 0, 1, 1},
                         {Kind::items_meet, 0, 0, 0}};
    EXPECT_EQ(trace_frame(rows.query, {}).steps.items,
              (std::vector<ItemStep>{{{1, 1}, 0, true}, {{0, 0}, 1, false}, {{0, 0}, 1, true}}));
}

TEST(EngineTrace, PairsAreThoseReportedOrElseThoseWhoseTestsMet) {
    Rows rows;
    rows.query.events = {{Kind::items_meet, 0, 1, 1}, {Kind::items_meet, 0, 0, 0},
                         {Kind::items_meet, 0, 9, 0}, {Kind::pair, 0, 3, 3},
                         {Kind::pair, 0, 2, 2},       {Kind::pair, 0, 3, 3},
                         {Kind::pair, 0, 0, 4}};
    using Pairs = std::vector<IndexPair>;
    EXPECT_EQ(trace_frame(rows.query, {}).found.pairs, (Pairs{{2, 2}, {3, 3}}));
    rows.query.has_pairs = false;
    rows.query.complete = false;
    std::erase_if(rows.query.events, [](const EngineEvent& e) { return e.kind == Kind::pair; });
    EXPECT_EQ(trace_frame(rows.query, {}).found.pairs, (Pairs{{0, 0}, {1, 1}}));
    EXPECT_FALSE(trace_frame(rows.query, {}).found.complete);
}

TEST(EngineTrace, PairsOfObjectsAreThoseOfTheNodesThatHoldThem) {
    auto nodes = nodes_of_row();
    nodes[6].items = {3, 1};  // 1 is in a node before it, too
    Rows rows(nodes);
    for (EngineSide& side : rows.query.sides) side.mesh = nullptr;
    rows.query.events = {{Kind::volumes, 0, 3, 3},
                         {Kind::items_meet, 0, 0, 0},
                         {Kind::pair, 0, 3, 0},
                         {Kind::pair, 0, 1, 2},
                         {Kind::pair, 0, 1, 50}};
    const QueryTrace frame = trace_frame(rows.query, {});
    EXPECT_EQ(frame.found.pairs, (std::vector<IndexPair>{{4, 5}, {6, 3}}));
    EXPECT_TRUE(frame.steps.items.empty()) << "objects are no triangles";
    EXPECT_EQ(frame.found.n_p, 1u);
}

TEST(EngineTrace, TheDepthIsThatOfBothNodesTogether) {
    Rows rows;
    rows.query.events = {{Kind::volumes, 0, 3, 0}, {Kind::volumes, 0, 0, 1}};
    EXPECT_EQ(trace_frame(rows.query, {}).found.depth, 2);
    rows.query.events = {{Kind::volumes, 0, 1, 3}, {Kind::volumes, 0, 3, 0}};
    EXPECT_EQ(trace_frame(rows.query, {}).found.depth, 3);
}

}  // namespace
}  // namespace scb
