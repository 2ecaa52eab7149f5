#include "scenes/recordings/tree_state.h"

#include <gtest/gtest.h>

#include "tests/scenes/recordings/read_steps.h"
#include "tests/scenes/recordings/small_records.h"

namespace scb::scenes {
namespace {

RecordedNode node_of(std::uint32_t node, std::vector<std::uint32_t> children,
                     std::vector<std::uint32_t> items, double radius) {
    return {
        0, node, record_none, 0, "", std::move(children), std::move(items), ball_volume(radius)};
}

TEST(TreeState, ANodeThatIsToldTwiceIsAsItWasFirst) {
    ReadSteps read(
        std::vector<Record>{RecordedTree{0, record_none, "", {}},
                            RecordedNode{0, 5, record_none, 0, "", {}, {0}, ball_volume(1)},
                            RecordedNode{0, 5, record_none, 0, "", {}, {1}, ball_volume(2)},
                            RecordedNode{0, 6, 5, 0, "", {}, {2}, ball_volume(2)}});
    read.read_all();
    const EngineNodes& tree = read.queries.trees().at(0).tree;
    ASSERT_EQ(tree.size(), 2u);
    EXPECT_EQ(std::get<Ball>(tree[0].volume).radius, 1);
    EXPECT_EQ(std::get<Ball>(tree[1].volume).radius, 2);
    EXPECT_EQ(tree.recorded_twice(), std::vector<std::uint32_t>{5});
}

// An engine that rotates its tree records the nodes that changed.
TEST(TreeState, ANodeThatIsRecordedInALaterFrameIsAnotherOne) {
    const std::vector<Record> tree = {RecordedTree{0, record_none, "", {}},
                                      node_of(0, {1, 2}, {}, 3), node_of(1, {}, {0}, 1),
                                      node_of(2, {}, {1}, 1), RecordedFrame{0}};
    std::vector<Record> records = tree;
    append(records, {RecordedFrame{1}, node_of(0, {2, 1}, {}, 3), node_of(1, {}, {0}, 2)});
    ReadSteps read(records);
    read.read_all();
    const EngineNodes& rotated = read.queries.trees().at(0).tree;
    EXPECT_TRUE(rotated.recorded_twice().empty());
    EXPECT_EQ(rotated.children(0)[0], 2u);
    EXPECT_EQ(rotated[0].links_at, 1);
    EXPECT_EQ(rotated[0].recorded_at, 0) << "it kept its volume";
    EXPECT_EQ(rotated[1].links_at, 0);
    EXPECT_EQ(rotated[1].recorded_at, 1);
    EXPECT_EQ(std::get<Ball>(rotated[1].volume).radius, 2);
    // In one go, the second node of a number is a fault.
    append(records, {node_of(1, {}, {0}, 2)});
    ReadSteps twice(records);
    twice.read_all();
    EXPECT_EQ(twice.queries.trees().at(0).tree.recorded_twice(), std::vector{1u});
}

TEST(TreeState, ANodeThatListsAnEarlierOneBecomesItsParent) {
    const auto node = [](std::uint32_t number, std::uint32_t parent,
                         std::vector<std::uint32_t> children) {
        RecordedNode made = node_of(number, std::move(children), {}, 1);
        made.parent = parent;
        return made;
    };
    ReadSteps read({RecordedTree{0, record_none, "", {}}, node(0, record_none, {1, 2}),
                    node(1, 0, {3}), node(2, 0, {}), node(3, 1, {}), RecordedFrame{0},
                    RecordedFrame{1}, node(1, 0, {}), node(2, 0, {3})});
    read.read_all();
    const EngineNodes& tree = read.queries.trees().at(0).tree;
    EXPECT_EQ(tree.parent(tree.index_of(3)), 2u);
    // A leaf that says so itself.
    ReadSteps moved({RecordedTree{0, record_none, "", {}}, node(0, record_none, {1, 2}),
                     node(1, 0, {3}), node(2, 0, {}), node(3, 1, {}), RecordedFrame{0},
                     RecordedFrame{1}, node(3, 2, {}), node(1, 0, {}), node(2, 0, {3})});
    moved.read_all();
    EXPECT_EQ(moved.queries.trees().at(0).tree.parent(3), 2u);
    // What a node says in the same frame counts.
    ReadSteps wrong({RecordedTree{0, record_none, "", {}}, node(0, record_none, {1, 2}),
                     node(1, 0, {}), node(2, 1, {})});
    wrong.read_all();
    EXPECT_EQ(wrong.queries.trees().at(0).tree.parent(2), 1u);
}

TEST(TreeState, ATreeThatIsBuiltAnewKnowsWhichNodesAreTheSame) {
    std::vector<Record> records = {RecordedTree{0, record_none, "", {}},
                                   node_of(0, {1, 2}, {}, 3),
                                   node_of(1, {}, {0}, 1),
                                   node_of(2, {}, {1}, 1),
                                   RecordedFrame{0},
                                   RecordedFrame{1},
                                   RecordedTree{0, record_none, "", {}},
                                   node_of(0, {2, 1}, {}, 3),
                                   node_of(1, {}, {0}, 2),
                                   node_of(2, {}, {1}, 1)};
    ReadSteps read(records);
    read.read_all();
    const EngineNodes& tree = read.queries.trees().at(0).tree;
    EXPECT_EQ(tree[0].links_at, 1);
    EXPECT_EQ(tree[0].recorded_at, 0);
    EXPECT_EQ(tree[1].links_at, 0);
    EXPECT_EQ(tree[1].recorded_at, 1);
}

TEST(TreeState, TheReachOfATreeIsThatOfItsVolumesNow) {
    std::vector<Record> records = two_balls();
    append(records, {RecordedRefit{0, 0, ball_volume(1e9)}, RecordedQuery{0, 1}, RecordedQueryEnd{},
                     RecordedRefit{0, 0, ball_volume(1)}, RecordedQuery{0, 1}, RecordedQueryEnd{}});
    EXPECT_NEAR(ReadSteps(records).query(0).tolerance, (1e9 + 1) * 1e-6, 1e-6);
    EXPECT_NEAR(ReadSteps(records).query(1).tolerance, 2e-6, 1e-15);
}

TEST(TreeState, DirectionsAreNoLengths) {
    std::vector<Record> records = two_balls();
    append(records,
           {RecordedRefit{
                0, 0, {RecordedKind::obb, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1e-7, 1e-7, 1e-7}}},
            RecordedRefit{1, 0, ball_volume(1e-7)}, RecordedQuery{0, 1}, RecordedQueryEnd{}});
    EXPECT_LT(ReadSteps(records).query(0).tolerance, 1e-12);
}

}  // namespace
}  // namespace scb::scenes
