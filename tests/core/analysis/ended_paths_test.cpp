#include "core/analysis/ended_paths.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/core/analysis/traces.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

const BuiltMesh& mesh() {
    static const BuiltMesh built(height_field(12));
    return built;
}

QueryTrace some_frame(const TraceHeader& header) {
    Pose pose;
    pose.translation = Vec3(0.3, 0.11, 0.02);
    return record_frame(mesh(), mesh(), 3, pose, header);
}

std::vector<TraceHeader> headers() {
    TraceHeader to_level = asking(VolumeKind::scb, OverlapTest::symmetric),
                first = asking(VolumeKind::ball, OverlapTest::symmetric);
    to_level.options.stop_level = 4;
    first.options.max_pairs = 3;
    return {asking(VolumeKind::scb, OverlapTest::corrected),
            asking(VolumeKind::obb, OverlapTest::corrected), to_level, first};
}

TEST(Endings, AreTheTestsThatWereNotPassedOn) {
    for (const TraceHeader& header : headers()) {
        const QueryTrace frame = some_frame(header);
        const Outcomes outcomes = outcomes_of(header, frame);
        std::uint64_t passed_on = 0;
        for (const Stage outcome : outcomes)
            passed_on += outcome == Stage::divided_a || outcome == Stage::divided_b;
        EndingCounts sum{};
        std::uint64_t ended = 0;
        for (const EndingCounts& counts : endings_by_depth(frame, outcomes))
            for (std::size_t i = 0; i < named_stage_count; ++i) {
                sum[i] += counts[i];
                ended += counts[i];
            }
        EXPECT_EQ(ended + passed_on, frame.found.n_v);
        for (std::size_t s = 1; s < stage_count; ++s) EXPECT_EQ(sum[s], frame.found.stages[s]);
        const auto at = [&](Stage ending) { return sum[static_cast<std::size_t>(ending)]; };
        EXPECT_EQ(at(Stage::triangles_meet) + at(Stage::found), frame.found.pairs.size());
        EXPECT_EQ(at(Stage::triangles_meet) + at(Stage::triangles_apart), frame.found.n_p);
        EXPECT_EQ(at(Stage::left_over) > 0, !frame.found.complete);
        // What a query of these options can have covers what it has.
        const std::vector<Stage> known = endings_of(header.volume, header.options);
        for (std::size_t i = 1; i < named_stage_count; ++i)
            EXPECT_TRUE(sum[i] == 0 || std::find(known.begin(), known.end(),
                                                 static_cast<Stage>(i)) != known.end());
    }
}

TEST(Endings, AreCountedByTheDepthsOfBothNodesTogether) {
    QueryTrace frame;
    frame.steps.volumes = {{{0, 0}, 0, 0, Stage::overlapping},
                           {{1, 0}, 1, 0, Stage::ball_ball},
                           {{2, 0}, 1, 0, Stage::overlapping},
                           {{2, 1}, 1, 1, Stage::ball_ball},
                           {{2, 2}, 1, 1, Stage::slab_ball}};
    const Outcomes outcomes = outcomes_of(frame.steps, {});
    const std::vector<EndingCounts> counts = endings_by_depth(frame, outcomes);
    ASSERT_EQ(counts.size(), 3u);
    const auto at = [&](std::size_t depth, Stage stage) {
        return counts[depth][static_cast<std::size_t>(stage)];
    };
    EXPECT_EQ(at(1, Stage::ball_ball), 1u);
    EXPECT_EQ(at(2, Stage::ball_ball), 1u);
    EXPECT_EQ(at(2, Stage::slab_ball), 1u);
    EXPECT_EQ(ending_counts(outcomes)[static_cast<std::size_t>(Stage::ball_ball)], 2u);
}

TEST(Endings, AreFoundByTheirNames) {
    for (const TraceHeader& header : headers()) {
        for (const Stage ending : endings_of(header))
            EXPECT_EQ(ending_of(header, stage_name(ending)), ending);
        EXPECT_FALSE(ending_of(header, "overlapping"));
    }
}

TEST(EndedPathsOf, SumsUpThePathsThatEndedAtEachNode) {
    for (const TraceHeader& header : headers())
        for (const std::size_t side : {0u, 1u}) {
            const QueryTrace frame = some_frame(header);
            const Outcomes outcomes = outcomes_of(header, frame);
            std::map<std::uint32_t, std::vector<Stage>> ends;
            std::map<std::uint32_t, std::uint32_t> tested;
            for (std::size_t i = 0; i < outcomes.size(); ++i) {
                const Step& test = frame.steps.volumes[i];
                const std::uint32_t node = side == 0 ? test.nodes.a : test.nodes.b;
                ++tested[node];
                if (is_ending(outcomes[i])) ends[node].push_back(outcomes[i]);
            }
            const std::vector<EndedPaths> front = ended_paths(frame, outcomes, side);
            ASSERT_EQ(front.size(), ends.size());
            auto expected = ends.begin();
            for (const EndedPaths& node : front) {
                ASSERT_EQ(node.node, expected->first);
                const std::vector<Stage>& list = expected->second;
                EXPECT_EQ(node.tests, list.size());
                EXPECT_EQ(node.tested, tested[node.node]);
                EXPECT_EQ(node.first, list.front());
                EXPECT_EQ(node.last, list.back());
                EXPECT_EQ(node.rejected, std::count_if(list.begin(), list.end(), is_rejection));
                for (std::size_t i = 0; i < named_stage_count; ++i) {
                    const auto ending = static_cast<Stage>(i);
                    const auto count = std::count(list.begin(), list.end(), ending);
                    EXPECT_LE(count, node.of_dominant);
                    EXPECT_TRUE(ending >= node.dominant || count < node.of_dominant);
                    EXPECT_TRUE(ending != node.dominant || count == node.of_dominant);
                }
                ++expected;
            }
        }
}

TEST(EndedPathsOf, KeepsWhatTheFilterAsksFor) {
    const TraceHeader header = asking(VolumeKind::scb, OverlapTest::corrected);
    const QueryTrace frame = some_frame(header);
    const Outcomes outcomes = outcomes_of(header, frame);
    const std::vector<std::uint16_t> depths = node_depths(mesh().topology());
    EndedPathsFilter filter;
    filter.endings = {Stage::triangles_apart, Stage::ball_ball};
    filter.least_depth = 3;
    filter.most_depth = 9;
    std::uint64_t tests = 0, all = 0;
    for (const EndedPaths& node : ended_paths(frame, outcomes, 1, filter)) {
        EXPECT_EQ(node.depth, depths[node.node]);
        EXPECT_TRUE(node.depth >= 3 && node.depth <= 9);
        EXPECT_TRUE(node.dominant == filter.endings[0] || node.dominant == filter.endings[1]);
        tests += node.tests;
    }
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const Step& test = frame.steps.volumes[i];
        all += test.depth_b >= 3 && test.depth_b <= 9 &&
               (outcomes[i] == Stage::triangles_apart || test.stage == Stage::ball_ball);
    }
    EXPECT_GT(all, 0u);
    EXPECT_EQ(tests, all);
}

TEST(EndedPathsOf, InnermostNodesHoldNoOther) {
    const TraceHeader header = asking(VolumeKind::scb, OverlapTest::corrected);
    const QueryTrace frame = some_frame(header);
    const std::vector<EndedPaths> front = ended_paths(frame, outcomes_of(header, frame), 0);
    const std::vector<EndedPaths> inner = innermost(front, tree_shape(mesh().topology()));
    const auto& nodes = mesh().topology().nodes;
    const auto holds = [&](std::uint32_t outer, std::uint32_t node) {
        return outer != node && nodes[outer].first <= nodes[node].first &&
               nodes[node].first + nodes[node].count <= nodes[outer].first + nodes[outer].count;
    };
    std::set<std::uint32_t> kept;
    for (const EndedPaths& node : inner) kept.insert(node.node);
    ASSERT_LT(kept.size(), front.size());
    for (const EndedPaths& outer : front) {
        const bool has_below = std::any_of(front.begin(), front.end(), [&](const EndedPaths& node) {
            return holds(outer.node, node.node);
        });
        EXPECT_EQ(kept.contains(outer.node), !has_below);
    }
}

}  // namespace
}  // namespace scb
