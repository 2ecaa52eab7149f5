#include "scenes/recordings/recorded_trace.h"

#include <gtest/gtest.h>

#include <set>

#include "core/analysis/ending.h"
#include "core/analysis/trace_diff.h"
#include "core/analysis/trace_words.h"
#include "core/model/tree.h"
#include "core/platform/number_list.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/recordings/test_input.h"
#include "scenes/recordings/trace_file.h"
#include "scenes/recordings/trace_recording.h"
#include "tests/core/analysis/made_query.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/fit/point_sets.h"
#include "tests/scenes/recordings/sample_records.h"
#include "tests/scenes/recordings/small_records.h"
#include "tests/scenes/recordings/trace_1_0.h"
#include "tests/scenes/support.h"
#include "tests/temporary_folder.h"
#include "tests/unless_sanitized.h"

namespace scb::scenes {
namespace {

const BuiltMesh& body_a() {
    static const BuiltMesh built(random_soup(1, 120, 0.15));
    return built;
}
const BuiltMesh& body_b() {
    static const BuiltMesh built(random_soup(2, 100, 0.15));
    return built;
}

/// Queries of this project, and the recording of them.
struct RecordedAndOwn {
    TemporaryFolder folder;
    std::string path = folder / "own.scbrec";
    Trace trace;

    explicit RecordedAndOwn(VolumeKind volume, OverlapTest test = OverlapTest::symmetric)
        : trace(record_trace(body_a(), body_b(), asking(volume, test), {0, 3, 6})) {
        const auto kind = static_cast<std::size_t>(volume);
        TraceRecording recording(trace.header,
                                 {TracedBody{&body_a().mesh, &body_a().hierarchies[kind]},
                                  TracedBody{&body_b().mesh, &body_b().hierarchies[kind]}});
        for (const QueryTrace& frame : trace.frames) recording.add(frame, {Pose{}, frame.b_to_a});
        folder.write("own.scbrec", recording.finish());
    }
};

/// How far it reaches from the origin.
double reach_of(const AnyVolume& volume, const Vec3& d) {
    return std::visit(
        [&d](const auto& v) {
            if constexpr (requires { v.center; })
                return dot(v.center, d) + support(v, d);
            else
                return dot(v.c, d) + support(v, d);
        },
        volume);
}

TEST(RecordedTrace, HasWhatTheTraceOfOwnQueriesHas) {
    for (std::size_t k = 0; k < all_volume_kinds().size();
         k += unless_sanitized<std::size_t>(1, 5)) {
        const VolumeKind volume = all_volume_kinds()[k];
        const RecordedAndOwn both(volume);
        RecordedTrace recorded(both.path, "", "all");
        EXPECT_EQ(recorded.frames(), (std::vector{0, 3, 6}));
        EXPECT_TRUE(same_meshes(recorded.header(), both.trace.header));
        EXPECT_EQ(endings_of(recorded.header()), endings_of(both.trace.header));
        for (const QueryTrace& own : both.trace.frames) {
            const QueryTrace& frame = recorded.frame(own.frame);
            EXPECT_EQ(frame.steps, own.steps) << own.frame;
            EXPECT_EQ(frame.found.pairs, own.found.pairs);
            EXPECT_EQ(frame.found.stages, own.found.stages);
            EXPECT_EQ(frame.found.n_p, own.found.n_p);
            EXPECT_EQ(frame.found.depth, own.found.depth);
            const Outcomes outcomes = outcomes_of(recorded.header(), frame),
                           of_own = outcomes_of(both.trace.header, own);
            EXPECT_EQ(outcomes, of_own) << volume_kind_name(volume);
        }
    }
}

TEST(RecordedTrace, HasTheTreesOfOwnHierarchies) {
    for (std::size_t k = 0; k < all_volume_kinds().size();
         k += unless_sanitized<std::size_t>(1, 5)) {
        const RecordedAndOwn both(all_volume_kinds()[k]);
        const RecordedTrace recorded(both.path, "", "3");
        const Tree own(body_b().hierarchies[k]);
        const BodyAtFrame body = recorded.body(1, 3);
        EXPECT_EQ(body.pose.translation, both.trace.frames[1].b_to_a.translation);
        EXPECT_EQ(body.mesh->triangles, body_b().mesh.triangles);
        const TreeShape &shape = body.tree->shape(), &of_own = own.shape();
        EXPECT_EQ(shape.parents, of_own.parents);
        EXPECT_EQ(shape.depths, of_own.depths);
        EXPECT_EQ(shape.holder, of_own.holder);
        EXPECT_EQ(items_below(shape), items_below(of_own));
        for (std::uint32_t node = 0; node < own.size(); ++node) {
            ASSERT_TRUE(body.tree->has_volume(node));
            const VolumeSize size = body.tree->volume_size(node), of = own.volume_size(node);
            EXPECT_NEAR(size.diameter, of.diameter, 1e-9)
                << volume_kind_name(all_volume_kinds()[k]);
            EXPECT_NEAR(size.thickness, of.thickness, 1e-9);
            EXPECT_NEAR(size.area, of.area, 1e-9);
            EXPECT_NEAR(size.volume, of.volume, 1e-9);
            const AnyVolume volume = body.tree->volume(node), own_volume = own.volume(node);
            for (const Vec3& d : touching_directions())
                ASSERT_NEAR(reach_of(volume, d), reach_of(own_volume, d), 1e-9);
        }
    }
}

TEST(RecordedTrace, AttributesTestsAsThoseOfOwnQueriesAre) {
    for (const auto& [volume, test] : {std::pair{VolumeKind::scb, OverlapTest::printed},
                                       {VolumeKind::scb2, {}},
                                       {VolumeKind::obb, {}},
                                       {VolumeKind::aabb, {}},
                                       {VolumeKind::rss, {}}}) {
        SCOPED_TRACE(volume_kind_name(volume));
        const RecordedAndOwn both(volume, test);
        const auto kind = static_cast<std::size_t>(volume);
        const AnyHierarchy &a = body_a().hierarchies[kind], &b = body_b().hierarchies[kind];
        RecordedTrace recorded(both.path, "", "all");
        std::uint64_t wrong = 0, missed = 0;
        for (const QueryTrace& own : both.trace.frames) {
            const TraceHeader& header = both.trace.header;
            const Attribution of_own = attribute(
                a, b, header, own, all_contacts(a, body_a().mesh, b, body_b().mesh, header, own));
            recorded.frame(own.frame);
            const Attribution found = recorded.attribution();
            EXPECT_EQ(found.counts.inner, of_own.counts.inner);
            EXPECT_EQ(found.counts.leaves, of_own.counts.leaves);
            EXPECT_EQ(found.counts.wasted().volume_tests, of_own.counts.wasted().volume_tests);
            ASSERT_EQ(found.wrongly_rejected.size(), of_own.wrongly_rejected.size());
            for (std::size_t i = 0; i < found.wrongly_rejected.size(); ++i) {
                EXPECT_EQ(found.wrongly_rejected[i].test, of_own.wrongly_rejected[i].test);
                EXPECT_EQ(found.wrongly_rejected[i].missed, of_own.wrongly_rejected[i].missed);
            }
            wrong += found.counts.wrongly_rejected;
            missed += found.counts.missed;
        }
        EXPECT_EQ(wrong > 0, volume == VolumeKind::scb);
        EXPECT_EQ(missed > 0, volume == VolumeKind::scb);
    }
}

TEST(RecordedTrace, SaysWhatItCannotOpen) {
    const RecordedAndOwn both(VolumeKind::scb);
    const auto refusal_of = [&](const std::string& bodies, const std::string& frames) {
        try {
            const RecordedTrace recorded(both.path, bodies, frames);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal_of("A,B", auto_frames), "");
    EXPECT_NE(refusal_of("A,C", "all").find("no query of these bodies"), std::string::npos);
    EXPECT_NE(refusal_of("", "1").find("has no frame 1"), std::string::npos);
}

/// Two trees of a root and three children, objects in place of triangles: numbers from `first` on.
void add_broadphase(RecordingWriter& writer, std::uint32_t first) {
    for (std::uint32_t tree = 0; tree < 2; ++tree) {
        writer.add(RecordedTree{tree, record_none, "", {}});
        const auto box = [](double from, double to) {
            return RecordedVolume{RecordedKind::aabb, {from, 0, 0, to, 1, 1}};
        };
        writer.add(RecordedNode{
            tree, first, record_none, 0, "", {first + 1, first + 2, first + 3}, {}, box(0, 3)});
        for (std::uint32_t i = 0; i < 3; ++i)
            writer.add(RecordedNode{tree,
                                    first + 1 + i,
                                    first,
                                    0,
                                    i == 2 ? "wheel" : "",
                                    {},
                                    {100 + i},
                                    box(i, i + 1)});
    }
}

/// Bodies of these trees, and a query that goes into both at once, at frame 5; and at frame 6, when
/// the trees are built anew with other numbers, one that goes into A and finds another pair.
std::string broadphase() {
    constexpr auto pair = static_cast<std::uint8_t>(RecordTag::pair);
    RecordingWriter writer;
    add_broadphase(writer, 10);
    for (std::uint32_t tree = 0; tree < 2; ++tree)
        writer.add(RecordedBody{tree, tree, tree == 0 ? "world" : "robot"});
    writer.add(RecordedFrame{5});
    writer.add(RecordedQuery{0, 1});
    for (const auto& [tag, a, b] :
         {RecordedEvent{0, 10, 10}, {0, 11, 11}, {7, 11, 12}, {pair, 100, 100}})
        writer.add(RecordedEvent{tag, a, b});
    writer.add(RecordedQueryEnd{true, 0});
    writer.add(RecordedFrame{6});
    add_broadphase(writer, 70);
    writer.add(RecordedQuery{0, 1});
    for (const auto& [tag, a, b] :
         {RecordedEvent{0, 70, 70}, {0, 72, 70}, {0, 72, 73}, {pair, 101, 102}})
        writer.add(RecordedEvent{tag, a, b});
    writer.add(RecordedQueryEnd{true, 0});
    writer.add(RecordedEnd{});
    return writer.finish();
}

/// No name of a stage.
TEST(RecordedTrace, ReadsObjectsInTreesWithAnyNumberOfChildren) {
    const TemporaryFolder folder;
    folder.write("objects.scbrec", broadphase());
    RecordedTrace recorded(folder / "objects.scbrec", "", "5");
    const TraceHeader& header = recorded.header();
    EXPECT_TRUE(pairs_are_nodes(header));
    EXPECT_EQ(header.engine->volumes, "AABB");
    ASSERT_EQ(header.engine->stages.size(), 1u);
    EXPECT_EQ(stage_words(header, header.engine->stages[0]), "stage 7");
    const QueryTrace& frame = recorded.frame(5);
    EXPECT_EQ(frame.found.pairs, (std::vector<IndexPair>{{1, 1}}));
    const Outcomes outcomes = outcomes_of(header, frame);
    EXPECT_EQ(parents_of(frame.steps), (std::vector<std::uint32_t>{no_step, 0, 0}));
    EXPECT_EQ(outcomes,
              (std::vector<Stage>{Stage::divided_both, Stage::found, header.engine->stages[0]}));
    EXPECT_EQ(stage_words(header, outcomes[2]), "stage 7");
    const BodyAtFrame body = recorded.body(0, 5);
    EXPECT_TRUE(body.mesh->triangles.empty());
    EXPECT_EQ(body.tree->shape().depths, (std::vector<std::uint32_t>{0, 1, 1, 1}));
}

TEST(RecordedTrace, CallsNodesByTheNumbersThatTheyHaveAtTheFrame) {
    const TemporaryFolder folder;
    folder.write("objects.scbrec", broadphase());
    RecordedTrace recorded(folder / "objects.scbrec", "", "all");
    EXPECT_EQ(recorded.all_frames(), (std::vector{5, 6}));
    for (const auto& [number, first] : {std::pair{5, 10u}, {6, 70u}}) {
        const QueryTrace& frame = recorded.frame(number);
        EXPECT_EQ(numbers_of(frame, {0, 3}), (IndexPair{first, first + 3}));
        EXPECT_EQ(nodes_of(frame, {first, first + 3}), (IndexPair{0, 3}));
        EXPECT_EQ(nodes_of(frame, {first, 3}), std::nullopt);
        const Tree& tree = *recorded.body(1, number).tree;
        EXPECT_TRUE(tree.has_own_numbers());
        EXPECT_EQ(tree.number(2), first + 2);
        EXPECT_EQ(tree.node_of(first + 2), 2u);
        EXPECT_EQ(tree.node_of(2), no_index);
        EXPECT_EQ(tree.node_words(2), "node " + std::to_string(first + 2));
        EXPECT_EQ(tree.node_words(3), "node " + std::to_string(first + 3) + " \"wheel\"");
    }
    // Its own hierarchies have indices for numbers.
    const Tree own(body_b().hierarchies[0]);
    EXPECT_FALSE(own.has_own_numbers());
    EXPECT_EQ(own.node_words(2), "node 2");
    const QueryTrace none;
    EXPECT_EQ(numbers_of(none, {4, 5}), (IndexPair{4, 5}));
    EXPECT_EQ(nodes_of(none, {4, 5}), (IndexPair{4, 5}));
}

TEST(RecordedTrace, SaysOfWhichNodesTheChildrenWereTested) {
    const TemporaryFolder folder;
    folder.write("objects.scbrec", broadphase());
    RecordedTrace recorded(folder / "objects.scbrec", "", "all");
    const auto words = [&](const QueryTrace& frame, std::size_t test) {
        const TracedTest traced =
            traced_test(recorded.header(), frame, outcomes_of(recorded.header(), frame), test);
        const BodyNames names = body_names(recorded.header());
        return words_of(traced, names) + "; " + words_of_parent(traced, names);
    };
    const QueryTrace& both = recorded.frame(5);
    EXPECT_EQ(words(both, 0), "overlap, passed on to the children of both; these are the roots");
    EXPECT_EQ(words(both, 2),
              "rejected at stage 7; reached from the nodes (10, 10) at depths (0, 0), where both "
              "nodes were divided");
    const QueryTrace& one = recorded.frame(6);
    EXPECT_EQ(words(one, 0),
              "overlap, passed on to the children of world's node; these are the roots");
    EXPECT_EQ(words(one, 1),
              "overlap, passed on to the children of robot's node; reached from the nodes (70, 70) "
              "at depths (0, 0), where world's node was divided");
    EXPECT_EQ(stage_name(Stage::divided_both), "divided both");
}

// Pairs of nodes in the trace of another engine.
TEST(RecordedTrace, ComparesPairsOfNodesByTheirNumbers) {
    const TemporaryFolder folder;
    folder.write("objects.scbrec", broadphase());
    TestInput a(folder / "objects.scbrec", "5"), b(folder / "objects.scbrec", "5");
    const TraceDiff same = diff(
        a.header(), [&] { return a.next(); }, b.header(), [&] { return b.next(); });
    EXPECT_TRUE(same.of_engines);
    EXPECT_TRUE(same.frames.empty());
    // The query of frame 6 as one of frame 5 in the eyes of the other.
    TestInput c(folder / "objects.scbrec", "5"), d(folder / "objects.scbrec", "6");
    TraceHeader later = d.header();
    later.engine->trees = c.header().engine->trees;
    QueryTrace moved;
    const TraceDiff other = diff(
        c.header(), [&] { return c.next(); }, later,
        [&]() -> const QueryTrace* {
            const QueryTrace* frame = d.next();
            if (frame == nullptr) return nullptr;
            moved = *frame;
            moved.frame = 5;
            return &moved;
        });
    ASSERT_TRUE(other.pairs_comparable);
    ASSERT_EQ(other.lost.size(), 2u);
    EXPECT_EQ(other.lost[0].pair, (IndexPair{11, 11}));
    EXPECT_EQ(other.lost[1].pair, (IndexPair{72, 73}));
    ASSERT_TRUE(other.first);
    EXPECT_EQ(other.first->a->test.nodes, (IndexPair{10, 10}));
    EXPECT_EQ(other.first->b->test.nodes, (IndexPair{70, 70}));
}

TEST(RecordedTrace, KeepsStagesOfOneNameApartAndNoneBeyondTheLast) {
    const RecordedAndOwn both(VolumeKind::obb);
    RecordingWriter writer;
    for (unsigned stage = 255; stage > 0; --stage)
        writer.add(RecordedStage{static_cast<std::uint8_t>(stage), stage % 2 ? "x" : "axis-a0"});
    const RecordingBytes bytes = recording_bytes(both.path);
    RecordingReader reader(bytes, "test");
    while (const Record* record = reader.next())
        if (!std::holds_alternative<RecordedStage>(*record)) writer.add(*record);
    const TemporaryFolder folder;
    folder.write("stages.scbrec", writer.finish());
    RecordedTrace recorded(folder / "stages.scbrec", "", "0");
    const TraceHeader& header = recorded.header();
    const std::vector<Stage>& stages = header.engine->stages;
    EXPECT_EQ(stages.size(), 127u);
    std::set<std::string> names;
    for (const Stage stage : stages) names.insert(stage_words(header, stage));
    EXPECT_EQ(names.size(), stages.size());
    const QueryTrace& frame = recorded.frame(0);
    std::uint64_t sum = 0;
    for (const auto& [name, count] : tests_by_stage(header, frame)) sum += count;
    EXPECT_EQ(sum, frame.found.n_v);
}

TEST(RecordedTrace, RefusesPosesThatMakeABodyFlat) {
    const RecordedAndOwn both(VolumeKind::obb);
    RecordingWriter writer;
    const RecordingBytes bytes = recording_bytes(both.path);
    RecordingReader reader(bytes, "test");
    while (const Record* record = reader.next()) {
        Record copy = *record;
        if (auto* pose = std::get_if<RecordedPose>(&copy); pose != nullptr && pose->body == 1)
            pose->rows = {};
        writer.add(copy);
    }
    const TemporaryFolder folder;
    folder.write("flat.scbrec", writer.finish());
    EXPECT_THROW(RecordedTrace(folder / "flat.scbrec", "", "all"), InputError);
    EXPECT_THROW(bodies_at(read_recording(folder / "flat.scbrec"), ""), InputError);
}

/// Queries of two pairs of three bodies: in frame 4 both, twice of the second, in frame 9 the
/// second, of the first tree refitted and the second one built anew.
std::shared_ptr<const Recording> queries_of_two_pairs() {
    std::vector<Record> records = two_balls();
    append(records, {RecordedBody{0, 0, "left"}, RecordedBody{1, 1, "right"},
                     RecordedBody{2, 1, "C"}, RecordedSetting{"engine", "e"},
                     RecordedSetting{"scene", "s"}, RecordedSetting{"results", "pairs"},
                     RecordedSetting{"margin", "0.5"}, RecordedFrame{4}, pose_at(2, 1)});
    append(records, query_with({{0, 0, 0}}));
    const std::vector<Record> of_c = {RecordedQuery{0, 2}, RecordedEvent{1, 0, 0},
                                      RecordedEvent{1, 0, 0}, RecordedQueryEnd{}};
    append(records, of_c);
    append(records, {pose_at(2, 2), RecordedQuery{0, 2}, RecordedQueryEnd{}, RecordedFrame{9},
                     RecordedRefit{0, 0, ball_volume(3)}});
    append(records, {RecordedTree{1, record_none, "", {}},
                     RecordedNode{1, 0, record_none, 0, "", {1}, {}, ball_volume(1)},
                     RecordedNode{1, 1, 0, 0, "", {}, {0}, ball_volume(1)}});
    append(records, of_c);
    return std::make_shared<const Recording>(
        read_recording(std::make_shared<const RecordingFile>(recording_of(records), "x.scbrec")));
}

TEST(RecordedTrace, IsOfThePairThatIsNamed) {
    for (const char* bodies : {"", "A,B", "C,left", "right,C"})
        EXPECT_THROW(RecordedTrace(queries_of_two_pairs(), bodies, "all"), InputError) << bodies;
    RecordedTrace recorded(queries_of_two_pairs(), "left,C", "all");
    EXPECT_EQ(recorded.sides(), (std::array<std::size_t, 2>{0, 2}));
    EXPECT_EQ(recorded.header().bodies[1].name, "C");
    EXPECT_EQ(recorded.frames(), (std::vector{4, 9}));
    EXPECT_EQ(RecordedTrace(queries_of_two_pairs(), "left,right", "all").frames(), std::vector{4});
}

TEST(RecordedTrace, IsOfNoPairWhereCommasInNamesMakeTwoPairsAlike) {
    const auto opened = [](const char* first, const char* second, const std::string& bodies) {
        std::vector<Record> records = two_balls();
        append(records, {RecordedBody{0, 0, first}, RecordedBody{1, 1, "b,c"},
                         RecordedBody{2, 0, second}, RecordedBody{3, 1, "c"}, RecordedFrame{0}});
        for (const std::uint32_t a : {0u, 2u})
            append(records, {RecordedQuery{a, a + 1}, RecordedQueryEnd{}});
        const auto recording = std::make_shared<const Recording>(read_recording(
            std::make_shared<const RecordingFile>(recording_of(records), "x.scbrec")));
        return RecordedTrace(recording, bodies, "all").sides();
    };
    EXPECT_EQ(opened("a", "x,y", "a,b,c"), (std::array<std::size_t, 2>{0, 1}));
    EXPECT_EQ(opened("a", "x,y", "x,y,c"), (std::array<std::size_t, 2>{2, 3}));
    EXPECT_THROW(opened("a", "a,b", "a,b,c"), InputError);
}

TEST(RecordedTrace, ShowsTheFirstQueryOfAFrame) {
    RecordedTrace recorded(queries_of_two_pairs(), "left,C", "all");
    EXPECT_EQ(recorded.body(1, 4).pose.translation, Vec3(1, 0, 0));
    EXPECT_EQ(recorded.test_count(4), 2u);
    EXPECT_EQ(recorded.frame(4).steps.volumes.size(), 2u);
    EXPECT_EQ(recorded.body(1, 9).pose.translation, Vec3(2, 0, 0));
}

TEST(RecordedTrace, KnowsTheTreesOfEachFrame) {
    RecordedTrace recorded(queries_of_two_pairs(), "left,C", "all");
    const TraceEngine& engine = *recorded.header().engine;
    for (const int frame : {4, 9})
        for (std::size_t side = 0; side < 2; ++side)
            EXPECT_EQ(engine.trees.at(frame)[side], recorded.body(side, frame).tree->hash());
    EXPECT_EQ(engine.trees.at(4)[0], engine.trees.at(9)[0]);
    EXPECT_NE(engine.trees.at(4)[1], engine.trees.at(9)[1]);
    EXPECT_EQ(recorded.body(0, 4).tree->volume_size(0).diameter, 2);
    EXPECT_EQ(recorded.body(0, 9).tree->volume_size(0).diameter, 6);
}

TEST(RecordedTrace, HasTheSettingsOfTheQueriesAlone) {
    const RecordedTrace recorded(queries_of_two_pairs(), "left,C", "all");
    const TraceEngine& engine = *recorded.header().engine;
    EXPECT_EQ(engine.name, "e");
    EXPECT_EQ(recorded.header().scene, "s");
    ASSERT_EQ(engine.settings.size(), 1u);
    EXPECT_EQ(engine.settings[0].name, "margin");
    EXPECT_EQ(engine.settings[0].value, "0.5");
}

TEST(TestInput, GivesTheFramesOfEachKindOfFile) {
    const RecordedAndOwn both(VolumeKind::obb);
    const std::vector<std::uint8_t> bytes = encode_trace(both.trace);
    const std::vector<std::uint8_t> of_1_0 =
        trace_file_1_0(both.trace.header, plain_frames(both.trace));
    const std::string trace = both.folder.write("trace.scbrec", {bytes.begin(), bytes.end()}),
                      trace_1_0 = both.folder.write("trace", {of_1_0.begin(), of_1_0.end()});
    for (const std::string& path : {trace, trace_1_0}) {
        EXPECT_TRUE(names_trace(path));
        EXPECT_FALSE(names_recording(path));
    }
    EXPECT_FALSE(names_trace(both.path));
    EXPECT_TRUE(names_recording(both.path));
    EXPECT_NE(scenes::refusal([&] { read_recording(trace); }).find("scb trace --records"),
              std::string::npos);
    for (const std::string& path : {both.path, trace, trace_1_0}) {
        TestInput input(path, "3,6");
        EXPECT_EQ(input.frames(), (std::vector{3, 6}));
        EXPECT_EQ(input.all_frames(), (std::vector{0, 3, 6}));
        EXPECT_EQ(input.recorded() != nullptr, path == both.path);
        for (const std::size_t i : {1u, 2u}) {
            const QueryTrace* frame = input.next();
            ASSERT_NE(frame, nullptr);
            EXPECT_EQ(frame->frame, both.trace.frames[i].frame);
            EXPECT_EQ(frame->steps, both.trace.frames[i].steps);
        }
        EXPECT_EQ(input.next(), nullptr);
    }
}

}  // namespace
}  // namespace scb::scenes
