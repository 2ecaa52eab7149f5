#include "core/analysis/worst_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "scenes/scene/builtin.h"
#include "tests/scenes/scene/attributed_query.h"

namespace scb::scenes {
namespace {

TEST(WorstRejections, AreTheSameInWhateverOrderFramesAreAdded) {
    QueryTrace early, late;
    early.frame = 1;
    late.frame = 2;
    for (QueryTrace* frame : {&early, &late})
        for (std::uint32_t i = 0; i < 3; ++i)
            frame->steps.volumes.push_back({{i, i}, 0, 0, Stage::ball_slab});
    Attribution found;
    found.wrongly_rejected = {{0, 5}, {1, 7}, {2, 5}};
    WorstRejections forward(3), backward(3);
    forward.add(early, found);
    forward.add(late, found);
    backward.add(late, found);
    backward.add(early, found);
    for (const WorstRejections* worst : {&forward, &backward}) {
        ASSERT_EQ(worst->pairs().size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(worst->pairs()[i].frame, 1);
            EXPECT_EQ(worst->pairs()[i].rejection.test, (std::array{1u, 0u, 2u})[i]);
        }
    }
}

using Nodes = std::pair<std::uint32_t, std::uint32_t>;

/// Each pair of nodes once, with the most that it has at any frame, the worst first.
std::vector<std::uint64_t> ranked(const std::map<Nodes, std::uint64_t>& most_of) {
    std::vector<std::uint64_t> most;
    for (const auto& [nodes, value] : most_of) most.push_back(value);
    std::sort(most.rbegin(), most.rend());
    return most;
}

TEST(WorstPairs, AreEachListedOnceAtTheirWorstFrame) {
    const Scene scene = load_builtin(*find_builtin("line-8"));
    const BuiltMesh a(scene.meshes[scene.bodies[0].mesh].mesh),
        b(scene.meshes[scene.bodies[1].mesh].mesh);
    WorstRejections rejections(5);
    WorstPairs weak(PassReason::weak_test, 6);
    std::map<Nodes, std::uint64_t> missed, wasted;
    for (int frame = 80; frame < 160; frame += 4) {
        const Pose pose = relative_pose(pose_at(scene.bodies[0].motion, frame),
                                        pose_at(scene.bodies[1].motion, frame));
        AttributedQuery query(a, b, pose, VolumeKind::scb, OverlapTest::printed);
        query.frame.frame = frame;
        rejections.add(query.frame, query.result);
        weak.add(query.frame, query.result);
        const auto raise = [&](std::map<Nodes, std::uint64_t>& most, std::uint32_t test,
                               std::uint64_t value) {
            const IndexPair nodes = query.frame.steps.volumes[test].nodes;
            std::uint64_t& so_far = most[{nodes.a, nodes.b}];
            so_far = std::max(so_far, value);
        };
        for (const WrongRejection& rejection : query.result.wrongly_rejected)
            raise(missed, rejection.test, rejection.missed);
        for (const PassedPair& pair : query.result.passed)
            if (pair.reason == PassReason::weak_test && pair.within != PassReason::weak_test)
                raise(wasted, pair.test, pair.below.volume_tests + pair.below.triangle_tests);
    }
    EXPECT_GT(ranked(missed)[4], 0u);
    ASSERT_EQ(rejections.pairs().size(), 5u);
    std::set<Nodes> seen;
    for (std::size_t i = 0; i < 5; ++i) {
        const WronglyRejectedPair& pair = rejections.pairs()[i];
        EXPECT_EQ(pair.rejection.missed, ranked(missed)[i]);
        EXPECT_NE(pair.test.stage, Stage::overlapping);
        EXPECT_TRUE(seen.insert({pair.test.nodes.a, pair.test.nodes.b}).second);
    }
    ASSERT_EQ(weak.pairs().size(), 6u);
    seen.clear();
    for (std::size_t i = 0; i < 6; ++i) {
        const FalsePair pair = weak.pairs()[i];
        EXPECT_EQ(pair.pair.below.volume_tests + pair.pair.below.triangle_tests, ranked(wasted)[i]);
        EXPECT_TRUE(seen.insert({pair.test.nodes.a, pair.test.nodes.b}).second);
    }
}

}  // namespace
}  // namespace scb::scenes
