#include "core/analysis/trace.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/analysis/trace_words.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

const BuiltMesh& mesh_a() {
    static const BuiltMesh mesh(random_soup(1, 400, 0.15));
    return mesh;
}
const BuiltMesh& mesh_b() {
    static const BuiltMesh mesh(random_soup(2, 300, 0.15));
    return mesh;
}
const std::vector<int> three_frames = {2, 4, 7};

Trace slide(OverlapTest test, const std::vector<int>& frames = three_frames) {
    return record_trace(mesh_a(), mesh_b(), asking(VolumeKind::scb, test), frames);
}

void expect_in(const std::string& part, const std::string& whole) {
    EXPECT_NE(whole.find(part), std::string::npos) << part << " is not in " << whole;
}

// ------------------------------------------------------------------------------------ test tree

TEST(Outcomes, FollowsTheHierarchies) {
    for (const VolumeKind kind : all_volume_kinds())
        for (const DescentRule descent : all_descent_rules())
            for (const int level : {-1, 0, 3}) {
                TraceHeader header = asking(kind, OverlapTest::symmetric);
                header.options.descent = descent;
                header.options.stop_level = level;
                const QueryTrace frame = record_trace(mesh_a(), mesh_b(), header, {4}).frames[0];
                const Outcomes outcomes = outcomes_of(header, frame);
                const auto& tests = frame.steps.volumes;
                const auto& nodes_a = mesh_a().topology().nodes;
                const auto& nodes_b = mesh_b().topology().nodes;
                ASSERT_EQ(outcomes.size(), tests.size());
                EXPECT_EQ(tests[0].parent, no_step);
                std::vector<int> children(tests.size());
                for (std::size_t i = 1; i < tests.size(); ++i) {
                    const std::uint32_t p = tests[i].parent;
                    ASSERT_LT(p, i);
                    const IndexPair parent = tests[p].nodes, child = tests[i].nodes;
                    const auto turn = static_cast<std::uint32_t>(children[p]++);
                    if (outcomes[p] == Stage::divided_a) {
                        EXPECT_EQ(child, (IndexPair{nodes_a[parent.a].left + turn, parent.b}));
                    } else {
                        ASSERT_EQ(outcomes[p], Stage::divided_b);
                        EXPECT_EQ(child, (IndexPair{parent.a, nodes_b[parent.b].left + turn}));
                    }
                }
                std::size_t meet = 0, found = 0;
                for (std::size_t i = 0; i < tests.size(); ++i) {
                    const Stage o = outcomes[i];
                    EXPECT_EQ(is_rejection(o), tests[i].stage != Stage::overlapping);
                    EXPECT_EQ(children[i], o == Stage::divided_a || o == Stage::divided_b ? 2 : 0);
                    EXPECT_NE(o, Stage::left_over);
                    meet += o == Stage::triangles_meet;
                    found += o == Stage::found;
                }
                EXPECT_EQ(level < 0 ? meet : found, frame.found.pairs.size());
                EXPECT_EQ(level < 0 ? found : meet, 0u);
            }
}

TEST(Outcomes, PairsMayBeLeftOver) {
    TraceHeader header = asking(VolumeKind::scb, OverlapTest::symmetric);
    header.options.max_pairs = 1;
    const QueryTrace frame = record_trace(mesh_a(), mesh_b(), header, {4}).frames[0];
    const Outcomes outcomes = outcomes_of(header, frame);
    EXPECT_EQ(outcomes.back(), Stage::triangles_meet);
    EXPECT_GT(std::count(outcomes.begin(), outcomes.end(), Stage::left_over), 0);
}

// ---------------------------------------------------------------------------------- fingerprint

TEST(Fingerprint, SeesEveryBitAndTheOrder) {
    const Mesh mesh = random_soup(3, 20, 0.2);
    const MeshFingerprint before = fingerprint(mesh);
    EXPECT_EQ(before, fingerprint(mesh));
    EXPECT_EQ(before.triangles, 20u);
    EXPECT_EQ(before.vertices, mesh.vertices.size());
    Mesh nudged = mesh;
    nudged.vertices.back()[2] = std::nextafter(nudged.vertices.back()[2], 2);
    EXPECT_NE(before, fingerprint(nudged));
    Mesh swapped = mesh;
    std::swap(swapped.triangles[3], swapped.triangles[4]);
    EXPECT_NE(before, fingerprint(swapped));
    // A number for all machines.
    EXPECT_EQ(fingerprint({{Vec3(0, 0.5, -1)}, {{0, 0, 0}}}).hash, 665755891519075928u);
}

// ----------------------------------------------------------------------------------------- diff

TEST(TraceDiff, EqualWhateverTheVersionAndTheSource) {
    const Trace a = slide(OverlapTest::symmetric);
    Trace b = a;
    b.header.scb_version = "9.9.9";
    b.header.source = {"/elsewhere/a.ply"};
    const TraceDiff d = diff(a, b);
    EXPECT_TRUE(d.equal());
    EXPECT_EQ(d.common, 3u);
    EXPECT_FALSE(d.first);
    EXPECT_EQ(d.sum_a, d.sum_b);
}

TEST(TraceDiff, TwoOverlapTestsPartWhereTheirStagesFirstDo) {
    const Trace a = slide(OverlapTest::corrected), b = slide(OverlapTest::printed);
    const TraceDiff d = diff(a, b);
    EXPECT_FALSE(d.equal());
    ASSERT_EQ(d.asked.size(), 1u);
    EXPECT_EQ(d.asked[0].name, "test");
    EXPECT_EQ(d.asked[0].a, "corrected");
    EXPECT_EQ(d.asked[0].b, "printed");
    ASSERT_TRUE(d.first && d.first->a && d.first->b);
    ASSERT_FALSE(d.frames.empty());
    EXPECT_EQ(d.first->frame, d.frames[0].frame);
    const auto index = static_cast<std::size_t>(
        std::find(three_frames.begin(), three_frames.end(), d.first->frame) - three_frames.begin());
    const auto& tests_a = a.frames[index].steps.volumes;
    const auto& tests_b = b.frames[index].steps.volumes;
    for (std::size_t i = 0; i < d.first->test; ++i) ASSERT_EQ(tests_a[i], tests_b[i]);
    EXPECT_EQ(d.first->a->test, tests_a[d.first->test]);
    EXPECT_EQ(d.first->b->test, tests_b[d.first->test]);
    EXPECT_EQ(d.first->a->test.nodes, d.first->b->test.nodes);
    EXPECT_NE(d.first->a->test.stage, d.first->b->test.stage);
    ASSERT_TRUE(d.first->a->parent);
    EXPECT_EQ(d.first->a->parent, d.first->b->parent);
    // The counts of the sum are the sums over the frames.
    std::uint64_t n_v = 0;
    for (const QueryTrace& f : b.frames) n_v += f.found.n_v;
    EXPECT_EQ(d.sum_b.n_v, n_v);

    const std::string text = words_of(*d.first, d.bodies);
    expect_in("frame " + std::to_string(d.first->frame) + ", test " + std::to_string(d.first->test),
              text);
    expect_in(words_of(*d.first->a, d.bodies), text);
    expect_in("reached from the nodes", text);
}

TEST(TraceDiff, FindsAnEventThatWasChanged) {
    const Trace a = slide(OverlapTest::symmetric);
    for (const std::size_t index : {std::size_t{0}, std::size_t{17}, std::size_t{40}}) {
        Trace b = a;
        Step& test = b.frames[1].steps.volumes[index];
        if (test.stage == Stage::overlapping) continue;
        test.stage = Stage::center_line;
        const TraceDiff d = diff(a, b);
        EXPECT_TRUE(d.asked.empty());
        ASSERT_TRUE(d.first);
        EXPECT_EQ(d.first->frame, 4);
        EXPECT_EQ(d.first->test, index);
        expect_in("rejected at center-line", words_of(*d.first->b, d.bodies));
        EXPECT_EQ(d.frames.size(), 1u);
    }
}

TEST(TraceDiff, FindsATriangleTestThatWasChanged) {
    const Trace a = slide(OverlapTest::symmetric);
    Trace b = a;
    auto& triangles = b.frames[0].steps.items;
    ASSERT_GT(triangles.size(), 5u);
    triangles[5].hit = !triangles[5].hit;
    // Later than the triangles, so not the first.
    b.frames[0].steps.volumes.back().stage = Stage::center_line;
    const TraceDiff d = diff(a, b);
    ASSERT_TRUE(d.first);
    EXPECT_EQ(d.first->frame, 2);
    EXPECT_EQ(d.first->test, triangles[5].step);
    ASSERT_TRUE(d.first->a->triangles && d.first->b->triangles);
    EXPECT_NE(d.first->a->triangles->hit, d.first->b->triangles->hit);
    EXPECT_NE(words_of(*d.first->a, d.bodies), words_of(*d.first->b, d.bodies));
}

// Other triangles in the same leaves: what another version's topology would give.
TEST(TraceDiff, FindsTrianglesThatWereChanged) {
    const Trace a = slide(OverlapTest::symmetric);
    Trace b = a;
    QueryTrace& frame = b.frames[1];
    const auto met = std::find_if(frame.steps.items.begin(), frame.steps.items.end(),
                                  [](const ItemStep& t) { return t.hit; });
    ASSERT_NE(met, frame.steps.items.end());
    auto& pairs = frame.found.pairs;
    const auto pair = std::find(pairs.begin(), pairs.end(), met->items);
    met->items.a += 1000;
    pair->a += 1000;
    std::sort(pairs.begin(), pairs.end());
    const TraceDiff d = diff(a, b);
    EXPECT_FALSE(d.equal());
    ASSERT_TRUE(d.first);
    EXPECT_EQ(d.first->test, met->step);
    EXPECT_EQ(d.pairs_only_in_a, 1u);
    EXPECT_EQ(d.pairs_only_in_b, 1u);
    for (const LostPair& lost : d.lost) EXPECT_FALSE(lost.other_ended);
}

TEST(TraceDiff, AQueryThatEndsEarlierLeavesPairsOver) {
    TraceHeader first = asking(VolumeKind::scb, OverlapTest::symmetric);
    first.options.max_pairs = 1;
    const Trace a = slide(OverlapTest::symmetric),
                b = record_trace(mesh_a(), mesh_b(), first, three_frames);
    const TraceDiff d = diff(a, b);
    // They part where the second leaves over what the first divides, not where it ends.
    ASSERT_TRUE(d.first && d.first->b);
    EXPECT_LT(d.first->test, b.frames[0].steps.volumes.size());
    EXPECT_EQ(d.first->b->outcome, Stage::left_over);
    EXPECT_NE(d.first->a->outcome, Stage::left_over);
    EXPECT_EQ(d.first->a->test, d.first->b->test);
    // Of the pairs that it lacks it left the nodes over, or had ended.
    EXPECT_EQ(d.pairs_only_in_b, 0u);
    EXPECT_EQ(d.pairs_only_in_a, d.sum_a.pairs - d.sum_b.pairs);
    ASSERT_FALSE(d.lost.empty());
    for (const LostPair& lost : d.lost)
        EXPECT_TRUE(!lost.lost_at || lost.lost_at->outcome == Stage::left_over);
}

TEST(TraceDiff, OneThatEndsEarlierHasNothingThere) {
    const Trace a = slide(OverlapTest::symmetric);
    Trace b = a;
    // The second child of the last pair that was divided, which led to nothing.
    b.frames[2].steps.volumes.pop_back();
    const TraceDiff d = diff(a, b);
    ASSERT_TRUE(d.first);
    EXPECT_EQ(d.first->test, b.frames[2].steps.volumes.size());
    EXPECT_TRUE(d.first->a);
    EXPECT_FALSE(d.first->b);
    expect_in("the second had ended", words_of(*d.first, d.bodies));
}

// The test that lost a pair is a rejection, of nodes above both triangles.
TEST(TraceDiff, SaysWhereAPairWasLost) {
    for (const DescentRule descent : {DescentRule::radius, DescentRule::alternating}) {
        TraceHeader asked = asking(VolumeKind::scb, OverlapTest::printed);
        asked.options.descent = descent;
        const Trace a = slide(OverlapTest::corrected),
                    b = record_trace(mesh_a(), mesh_b(), asked, three_frames);
        const TraceDiff d = diff(a, b);
        std::size_t only_a = 0;
        for (std::size_t f = 0; f < a.frames.size(); ++f) {
            const auto &pairs = a.frames[f].found.pairs, &others = b.frames[f].found.pairs;
            for (const IndexPair& pair : pairs)
                only_a += !std::binary_search(others.begin(), others.end(), pair);
        }
        ASSERT_GT(only_a, 0u) << "the test needs a pair that `printed` misses";
        EXPECT_EQ(d.pairs_only_in_a, only_a);
        EXPECT_EQ(d.pairs_only_in_b, 0u);
        EXPECT_EQ(d.lost.size(), std::min(only_a, TraceDiff::most_lost));
        for (const LostPair& lost : d.lost) {
            EXPECT_TRUE(lost.found_by_a);
            ASSERT_TRUE(lost.lost_at);
            EXPECT_TRUE(is_rejection(lost.lost_at->outcome));
            const auto frame = std::find_if(b.frames.begin(), b.frames.end(),
                                            [&](const auto& f) { return f.frame == lost.frame; });
            EXPECT_EQ(frame->steps.volumes[lost.test], lost.lost_at->test);
            const auto holds = [](const BuiltMesh& mesh, std::uint32_t node,
                                  std::uint32_t triangle) {
                const Topology& topology = topology_of(mesh.hierarchies[0]);
                const TopologyNode& n = topology.nodes[node];
                const auto first = topology.order.begin() + n.first;
                return std::find(first, first + n.count, triangle) != first + n.count;
            };
            EXPECT_TRUE(holds(mesh_a(), lost.lost_at->test.nodes.a, lost.pair.a));
            EXPECT_TRUE(holds(mesh_b(), lost.lost_at->test.nodes.b, lost.pair.b));
            expect_in("the second left them out at test", words_of(lost, false, d.bodies));
        }
        EXPECT_EQ(diff(b, a).pairs_only_in_b, only_a);
        EXPECT_FALSE(diff(b, a).lost[0].found_by_a);
    }
}

TEST(TraceDiff, LevelsToStopAtPartWhereOneGoesOn) {
    const auto to_level = [](int level) {
        TraceHeader asked = asking(VolumeKind::scb, OverlapTest::symmetric);
        asked.options.stop_level = level;
        return record_trace(mesh_a(), mesh_b(), asked, three_frames);
    };
    const TraceDiff d = diff(to_level(2), to_level(3));
    EXPECT_FALSE(d.pairs_comparable);
    EXPECT_EQ(d.pairs_only_in_a, 0u);
    ASSERT_TRUE(d.first && d.first->a && d.first->b);
    EXPECT_EQ(d.first->a->test, d.first->b->test);
    EXPECT_EQ(d.first->a->outcome, Stage::found);
    EXPECT_NE(d.first->b->outcome, Stage::found);
}

TEST(TraceDiff, FramesThatOnlyOneHas) {
    const TraceDiff d = diff(slide(OverlapTest::symmetric, {1, 2, 4, 9}),
                             slide(OverlapTest::symmetric, {2, 3, 4, 10, 11}));
    EXPECT_FALSE(d.equal());
    EXPECT_EQ(d.only_in_a, (std::vector<int>{1, 9}));
    EXPECT_EQ(d.only_in_b, (std::vector<int>{3, 10, 11}));
    EXPECT_EQ(d.common, 2u);
    EXPECT_TRUE(d.frames.empty());
    EXPECT_FALSE(d.first);
}

TEST(TraceDiff, OtherPosesDiffer) {
    const Trace a = slide(OverlapTest::symmetric);
    Trace b = a;
    b.frames[2].b_to_a.translation[1] = std::nextafter(b.frames[2].b_to_a.translation[1], 1);
    const TraceDiff d = diff(a, b);
    EXPECT_FALSE(d.equal());
    ASSERT_EQ(d.frames.size(), 1u);
    EXPECT_EQ(d.frames[0].frame, 7);
    EXPECT_TRUE(d.frames[0].poses_differ);
    EXPECT_FALSE(d.first);
}

TEST(TraceDiff, OtherVolumesOfTheSameMeshAreComparedNodeByNode) {
    const Trace a = slide(OverlapTest::symmetric),
                b = record_trace(mesh_a(), mesh_b(), asking(VolumeKind::ball, OverlapTest::printed),
                                 three_frames);
    const TraceDiff d = diff(a, b);
    EXPECT_TRUE(d.nodes_comparable);
    ASSERT_EQ(d.asked.size(), 3u);
    EXPECT_EQ(d.asked[0].name, "volume");
    for (const std::size_t i : {1u, 2u})
        EXPECT_EQ(d.asked[i].b, "-");  // margin and test mean nothing there
    EXPECT_TRUE(d.first);
}

TEST(TraceDiff, NamesGrowthAndMarginWhereTheyMatter) {
    for (const VolumeKind kind : all_volume_kinds()) {
        const TraceHeader header = asking(kind, OverlapTest::symmetric);
        Trace a = {header, {}}, b = a;
        b.header.growth = BallGrowth::radius;
        b.header.margin = 0.2;
        std::vector<std::string> asked;
        for (const FieldDifference& field : diff(a, b).asked) asked.push_back(field.name);
        std::vector<std::string> matter;
        if (has_growth(kind)) matter.emplace_back("growth");
        if (has_margin(kind)) matter.emplace_back("margin");
        EXPECT_EQ(asked, matter) << volume_kind_name(kind);

        // They matter where the volumes are others.
        BuildOptions options = build_options(b.header);
        const AnyHierarchy built =
            build_hierarchies(mesh_a().mesh, std::span(&kind, 1), options).front();
        const auto volumes_differ = [&](const auto& x) {
            const auto& y = std::get<std::decay_t<decltype(x)>>(
                mesh_a().hierarchies[static_cast<std::size_t>(kind)]);
            return std::memcmp(x.volumes.data(), y.volumes.data(),
                               x.volumes.size() * sizeof(x.volumes[0])) != 0;
        };
        EXPECT_EQ(std::visit(volumes_differ, built), has_growth(kind)) << volume_kind_name(kind);
    }
}

TEST(TraceDiff, OfOtherSplitsPairsAreCompared) {
    const Trace a = slide(OverlapTest::symmetric);
    Trace b = a;
    b.header.split = SplitMethod::cost;
    ASSERT_FALSE(b.frames[1].found.pairs.empty());
    b.frames[1].found.pairs.pop_back();
    const TraceDiff d = diff(a, b);
    EXPECT_FALSE(d.nodes_comparable);
    EXPECT_TRUE(d.pairs_comparable);
    EXPECT_FALSE(d.first);
    EXPECT_EQ(d.pairs_only_in_a, 1u);
    EXPECT_EQ(d.pairs_only_in_b, 0u);
    ASSERT_EQ(d.lost.size(), 1u);
    EXPECT_EQ(d.lost[0].pair, a.frames[1].found.pairs.back());
    EXPECT_FALSE(d.lost[0].lost_at) << "its nodes are others";
}

TEST(TraceDiff, OtherMeshesAreComparedByCountsAlone) {
    const Trace a = slide(OverlapTest::symmetric),
                b = record_trace(mesh_b(), mesh_a(),
                                 asking(VolumeKind::scb, OverlapTest::symmetric), three_frames);
    const TraceDiff d = diff(a, b);
    EXPECT_FALSE(d.nodes_comparable);
    EXPECT_FALSE(d.first);
    EXPECT_EQ(d.asked.size(), 2u);
    EXPECT_EQ(d.frames.size(), 3u);
}

// Leaves of other engines have several triangles.
TEST(TracedTest, OfSeveralTrianglesSaysHowManyAndNamesOneThatIntersects) {
    QueryTrace frame;
    frame.steps.volumes = {{{5, 7}, 0, 0, Stage::overlapping}};
    frame.steps.items = {{{1, 2}, 0, false}, {{3, 4}, 0, true}, {{5, 6}, 0, true}};
    Outcomes outcomes = {Stage::triangles_meet};
    EXPECT_EQ(words_of(traced_test({}, frame, outcomes, 0), {"A", "B"}),
              "overlap; of 3 pairs of their triangles 2 intersect, the first (3, 4)");
    frame.steps.items[2].hit = false;
    EXPECT_EQ(words_of(traced_test({}, frame, outcomes, 0), {"A", "B"}),
              "overlap; of 3 pairs of their triangles 1 intersects, (3, 4)");
    frame.steps.items[1].hit = false;
    outcomes = {Stage::triangles_apart};
    EXPECT_EQ(words_of(traced_test({}, frame, outcomes, 0), {"A", "B"}),
              "overlap; of 3 pairs of their triangles none intersects");
}

}  // namespace
}  // namespace scb
