#include "scenes/recordings/recording.h"

#include <gtest/gtest.h>

#include "core/platform/number_list.h"
#include "scb/error.h"
#include "scenes/recordings/recorded_bodies.h"
#include "scenes/recordings/recording_input.h"
#include "tests/scenes/recordings/sample_records.h"
#include "tests/scenes/recordings/small_records.h"
#include "tests/temporary_folder.h"

namespace scb::scenes {
namespace {

Recording read_records(const std::vector<Record>& records) {
    return read_recording(
        std::make_shared<const RecordingFile>(recording_of(records), "folder/engine.scbrec"));
}

/// The frames from which on the body is somewhere else, and where on x.
std::vector<std::pair<int, double>> moves_of(const Recording& recording, std::uint32_t body) {
    std::vector<std::pair<int, double>> moves;
    for (const PoseKey& key : recording.scene.bodies[recording.bodies.at(body)].motion.told)
        moves.emplace_back(key.frame, key.pose.translation[0]);
    return moves;
}

TEST(Recording, HasThePosesOfEachFrameAtItsFirstQuery) {
    std::vector<Record> records = two_balls();
    append(records, {RecordedFrame{2}, pose_at(1, 3)});
    append(records, query_with({}));
    append(records, {pose_at(1, 4)});
    append(records, query_with({}));
    append(records, {RecordedFrame{3}, pose_at(1, 3)});
    append(records, query_with({}));
    append(records, {RecordedFrame{7}, pose_at(1, 5), pose_at(1, 6)});
    const Recording recording = read_records(records);
    EXPECT_EQ(moves_of(recording, 1), (std::vector<std::pair<int, double>>{{2, 3}, {7, 6}}));
    EXPECT_EQ(moves_of(recording, 0), (std::vector<std::pair<int, double>>{{2, 0}}));
    EXPECT_EQ(recording.scene.frames, 8);
    EXPECT_EQ(recording.scene.listed, (std::vector{2, 3, 7}));
    EXPECT_EQ(recording.scene.default_frame, 2);
}

TEST(Recording, ShowsTheFirstFrameWithTheMostPairs) {
    constexpr auto pair = static_cast<std::uint8_t>(RecordTag::pair);
    std::vector<Record> records = two_balls();
    const RecordedEvent test{0, 0, 0}, found{pair, 0, 0}, other{pair, 1, 0};
    append(records, {RecordedFrame{0}});
    append(records, query_with({test, test, test, found}));
    append(records, {RecordedFrame{1}});
    append(records, query_with({test, found, other}));
    // The second query of a frame is not shown.
    append(records, query_with({test, found, found, other}));
    append(records, {RecordedFrame{2}});
    append(records, query_with({test, found, other}));
    append(records, {RecordedFrame{3}});
    append(records, query_with({test, test, found}));
    const Recording recording = read_records(records);
    ASSERT_EQ(recording.pairs.size(), 1u);
    EXPECT_EQ(recording.pairs[0].bodies, (std::array<std::uint32_t, 2>{0, 1}));
    EXPECT_EQ(recording.pairs[0].frames, (std::vector{0, 1, 2, 3}));
    EXPECT_EQ(recording.pairs[0].fullest, 1);
}

TEST(Recording, TellsItsBodiesApartByTheirNames) {
    std::vector<Record> records = {RecordedTree{0, record_none, "", {}}};
    for (const char* name : {"x", "x (2)", "x", "left, right", ""})
        records.emplace_back(RecordedBody{static_cast<std::uint32_t>(records.size() - 1), 0, name});
    const Recording recording = read_records(records);
    std::vector<std::string> names;
    for (const Body& body : recording.scene.bodies) names.push_back(body.name);
    EXPECT_EQ(names,
              (std::vector<std::string>{"x", "x (2)", "x (2) (2)", "left, right", "body 4"}));
}

TEST(Recording, IsCalledByTheSettingThatWasToldLastOrByItsFile) {
    const RecordedTree tree{0, record_none, "", {}};
    EXPECT_EQ(read_records({tree}).engine, "engine");
    EXPECT_EQ(read_records({RecordedSetting{"engine", "old"}, tree,
                            RecordedSetting{"engine", "new"}, RecordedSetting{"scene", "street"}})
                  .engine,
              "new");
}

/// A triangle at this height.
RecordedMesh triangle_at(double z) { return {0, "m", 8, {0, 0, z, 1, 0, z, 0, 1, z}, {0, 1, 2}}; }

TEST(Recording, OfAMeshThatChangesIsOneOfEachFrame) {
    std::vector<Record> records = {triangle_at(0), RecordedTree{0, 0, "", {}},
                                   RecordedBody{0, 0, "A"}, RecordedBody{1, 0, "B"}};
    EXPECT_EQ(read_records(records).refusal, "");
    for (const std::uint32_t frame : {0u, 1u, 2u}) {
        append(records, {RecordedFrame{frame}, triangle_at(frame)});
        append(records, query_with({}));
        // What moves behind the first query is of later ones.
        append(records, {triangle_at(frame + 0.5)});
    }
    const Recording recording = read_records(records);
    EXPECT_TRUE(recording.changes_meshes);
    EXPECT_NE(recording.refusal.find("the mesh of 'm' changes at frame 0"), std::string::npos);
    for (const int frame : {0, 1, 2}) {
        const Scene scene = scene_at(recording, frame);
        EXPECT_EQ(scene.default_frame, frame);
        for (const Body& body : scene.bodies)
            EXPECT_EQ(scene.meshes[body.mesh].mesh.vertices[0][2], frame);
    }
    const TemporaryFolder folder;
    const std::string file = folder.write("x.scbrec", recording_of(records));
    EXPECT_EQ(scene_of_recording(file, "1").default_frame, 1);
    EXPECT_EQ(scene_of_recording(file, "").default_frame, 0);
    EXPECT_THROW(scene_of_recording(file, "0,1"), InputError);
}

TEST(Recording, WhosePoseMakesABodyFlatHasNoQueriesOfThisProject) {
    std::vector<Record> records = two_balls();
    RecordedPose flat = pose_at(1, 0);
    flat.rows[5] = 0;
    records.emplace_back(flat);
    const TemporaryFolder folder;
    EXPECT_THROW(scene_of_recording(folder.write("x.scbrec", recording_of(records)), ""),
                 InputError);
}

TEST(Recording, HasBodiesAsTheyAreAtTheEndOfAFrame) {
    std::vector<Record> records = body_of_one_node(0, ball_volume(1));
    append(records, body_of_one_node(1, {RecordedKind::aabb, {0, 0, 0, 1, 1, 1}}));
    append(records, {RecordedFrame{0}});
    append(records, query_with({}));
    append(records, {RecordedRefit{0, 0, ball_volume(3)}, pose_at(0, 5), RecordedFrame{1},
                     RecordedRefit{0, 0, ball_volume(4)}, pose_at(0, 6)});
    const Recording recording = read_records(records);
    for (const auto& [frame, radius, x] : {std::tuple(0, 3.0, 5.0), {1, 4.0, 6.0}}) {
        const RecordedBodies bodies = bodies_at(recording, std::to_string(frame));
        ASSERT_EQ(bodies.bodies.size(), 2u);
        EXPECT_EQ(bodies.frame, frame);
        EXPECT_EQ(bodies.bodies[0].pose.translation[0], x);
        EXPECT_EQ(bodies.bodies[0].tree->volume_size(0).diameter, 2 * radius);
        EXPECT_EQ(bodies.volumes, "ball and AABB");
    }
    EXPECT_EQ(bodies_at(recording, "").frame, 0);
    EXPECT_THROW(bodies_at(recording, "0,1"), InputError);
}

TEST(Recording, OfSelectedQueriesHasBodiesAsTheseQueriesSawThem) {
    // Two queries of A and B, which B moves between, and one of A and C, which is recorded late.
    const std::string text = R"({"tree": 0}
{"node": 0, "in_tree": 0, "items": [0], "volume": ["ball", 0, 0, 0, 1]}
{"body": 0, "name": "a", "of_tree": 0}
{"body": 1, "name": "b", "of_tree": 0}
{"frame": 0}
{"pose": 1, "rows": [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0]}
{"query": [0, 1], "name": "first", "tags": ["some"]}
{"complete": true}
{"pose": 1, "rows": [1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0]}
{"query": [0, 1], "name": "second", "tags": ["some"]}
{"complete": true}
{"body": 2, "name": "c", "of_tree": 0}
{"pose": 2, "rows": [1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0]}
{"query": [0, 2], "name": "third", "tags": ["some"]}
{"complete": true}
{"pose": 1, "rows": [1, 0, 0, 3, 0, 1, 0, 0, 0, 0, 1, 0]}
{"pose": 2, "rows": [1, 0, 0, 6, 0, 1, 0, 0, 0, 0, 1, 0]}
{"end": true}
)";
    const TemporaryFolder folder;
    const std::string file = folder.write("q.jsonl", text);
    // `b` and `c`: where they are in the scene of this selection. `at_end`: whether levels show the
    // end of the frame.
    const auto expect = [&file](const QuerySelection& selection, double b, double c, bool at_end) {
        const Recording recording = read_recording(file, selection);
        using Moves = std::vector<std::pair<int, double>>;
        EXPECT_EQ(moves_of(recording, 1), (Moves{{0, b}})) << selection.words();
        EXPECT_EQ(moves_of(recording, 2), (Moves{{0, c}})) << selection.words();
        const RecordedBodies shown = bodies_at(recording, "0");
        ASSERT_EQ(shown.bodies.size(), 3u);
        EXPECT_EQ(shown.bodies[1].pose.translation[0], at_end ? 3 : b) << selection.words();
        EXPECT_EQ(shown.bodies[2].pose.translation[0], at_end ? 6 : c) << selection.words();
        EXPECT_EQ(bodies_at(recording, 0, Moment::end).bodies[1].pose.translation[0], 3);
    };
    expect({}, 1, 5, true);
    expect({"", "some"}, 1, 5, false);
    expect({"second", ""}, 2, 6, false);
    expect({"third", ""}, 3, 5, false);
}

TEST(Recording, IsReadAsJsonLinesWhateverItIsCalled) {
    const TemporaryFolder folder;
    const std::string text = "\n{\"tree\": 4, \"of_mesh\": null}\n";
    for (const char* name : {"x.jsonl", "x.txt"})
        EXPECT_EQ(records_of(recording_bytes(folder.write(name, text))),
                  (std::vector<Record>{RecordedTree{4, record_none, "", {}}}))
            << name;
    EXPECT_TRUE(names_recording(folder / "gone.jsonl"));
    EXPECT_TRUE(names_recording(folder.write("x", recording_of(two_balls()))));
    EXPECT_FALSE(names_recording(folder / "x.txt"));
    EXPECT_THROW(recording_bytes(folder.write("x.ply", "ply\n")), InputError);
}

}  // namespace
}  // namespace scb::scenes
