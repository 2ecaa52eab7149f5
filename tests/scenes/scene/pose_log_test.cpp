#include "scenes/scene/pose_log.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "scenes/scene/load_scene.h"
#include "scenes/scene/scene_file.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

const std::string identity_row = "1 0 0 0 0 1 0 0 0 0 1 0\n";

Motion read_log(const std::string& text, bool exact = false) {
    const TemporaryFolder folder;
    return PoseLogs(exact).read(folder.write("log.csv", text));
}

std::string log_refusal(const std::string& text, bool exact = false) {
    return refusal([&] { read_log(text, exact); });
}

/// That the log is refused, in this sentence.
void expect_log_refused(const std::string& text, const std::string& part) {
    const std::string sentence = log_refusal(text);
    expect_in("log.csv: " + part, sentence);
    EXPECT_TRUE(sentence.ends_with('.')) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
}

void expect_pose(const Pose& found, const Pose& expected, double tolerance = 1e-15) {
    EXPECT_LE((found.rotation - expected.rotation).cwiseAbs().maxCoeff(), tolerance);
    EXPECT_EQ(found.translation, expected.translation);
}

TEST(PoseLog, HasARowPerFrame) {
    const Motion motion = read_log("0 -1 0 1  1 0 0 2  0 0 1 3\n" + identity_row);
    ASSERT_EQ(motion.told.size(), 2u);
    Pose turned;
    turned.rotation = rotation_about(Vec3::UnitZ(), 90);
    turned.translation = Vec3(1, 2, 3);
    expect_pose(pose_at(motion, 0), turned, 0);
    expect_pose(pose_at(motion, 1), Pose{}, 0);
    EXPECT_EQ(motion.correction, 0);
}

TEST(PoseLog, MayHaveSeparatorsCommentsHeaderAndLineEndsOfAnyKind) {
    const Motion plain = read_log("0 -1 0 1 1 0 0 2 0 0 1 3\n" + identity_row);
    for (const std::string text :
         {"0,-1,0,1,1,0,0,2,0,0,1,3\n1,0,0,0,0,1,0,0,0,0,1,0",
          "0;-1;0;1;1;0;0;2;0;0;1;3\n1 ; 0 ;0;0;0;1;0;0;0;0;1;0\n",
          "\t0, -1, 0, 1 ,\t1, 0, 0, 2, 0, 0, 1, 3 \n\n1,0,0,0, 0,1,0,0, 0,0,1,0\n\n",
          "# by hand, 2 poses\nr00,r01,r02,tx,r10,r11,r12,ty,r20,r21,r22,tz\n"
          "0,-1,0,1,1,0,0,2,0,0,1,3\n  # 1 2 3\n1,0,0,0,0,1,0,0,0,0,1,0\n",
          "\xef\xbb\xbf"
          "pose\r\n0 -1 0 1 1 0 0 2 0 0 1 3\r\n\r\n1e0 0 +0 -0 0 1.0 0 0 0 0 1 0\r\n"}) {
        const Motion motion = read_log(text);
        ASSERT_EQ(motion.told.size(), 2u) << text;
        for (int frame : {0, 1}) expect_pose(pose_at(motion, frame), pose_at(plain, frame), 0);
    }
}

TEST(PoseLog, MayHaveQuaternionsAndTimeStamps) {
    const double s = std::sqrt(0.5);
    Pose turned;
    turned.rotation = rotation_about(Vec3::UnitX(), 90);
    turned.translation = Vec3(1, 2, 3);
    const std::string row = "1 2 3 " + std::to_string(s) + " 0 0 " + std::to_string(s) + "\n";
    // Six digits.
    expect_pose(pose_at(read_log(row), 0), turned, 1e-6);
    expect_pose(pose_at(read_log("1305031102.1758 " + row), 0), turned, 1e-6);
    const Motion turns = read_log("0 0 0 0.36 0.48 0.64 0.48\n0 0 0 -0.36 -0.48 -0.64 -0.48\n");
    Pose about;
    // cos(a/2) = 0.48, and the axis is (9, 12, 16) / sqrt(481).
    about.rotation =
        rotation_about(Vec3(9, 12, 16), 2 * std::acos(0.48) * 180 / 3.14159265358979323846);
    for (int frame : {0, 1}) expect_pose(pose_at(turns, frame), about, 1e-12);
    EXPECT_LE(rigidity_defect(pose_at(turns, 0)), 1e-15);
}

TEST(PoseLog, TakesTheNearestRotationOfRowsWithFewDigits) {
    const std::string rough = "0.866025 -0.5 0 1 0.5 0.866025 0 2 0 0 1 45\n";
    Pose turned;
    turned.rotation = rotation_about(Vec3::UnitZ(), 30);
    turned.translation = Vec3(1, 2, 45);
    const Motion motion = read_log("# three\n" + identity_row + rough + identity_row);
    expect_pose(pose_at(motion, 1), turned, 1e-6);
    EXPECT_LE(rigidity_defect(pose_at(motion, 1)), 1e-15);
    EXPECT_NEAR(motion.correction, 3e-7, 1e-7);
    EXPECT_EQ(motion.corrected_line, 3u);
    // The squared length of the quaternion is 1.0006.
    const Motion longer = read_log("0 0 0 0 0 0 1\n0 0 0 0 0 0 1.0003\n");
    expect_pose(pose_at(longer, 1), Pose{}, 1e-15);
    EXPECT_NEAR(longer.correction, 3e-4, 1e-6);
    EXPECT_EQ(longer.corrected_line, 2u);
    expect_in("line 2: the pose is not rigid", log_refusal(identity_row + rough, true));
    expect_in("line 2: the squared length of the quaternion differs from 1 by 0.000600",
              log_refusal("0 0 0 0 0 0 1\n0 0 0 0 0 0 1.0003\n", true));
    read_log(identity_row + "0 -1 0 1 1 0 0 2 0 0 1 3\n", true);
}

TEST(PoseLog, NamesTheRowThatItRefuses) {
    expect_log_refused("", "it has no poses");
    expect_log_refused("# nothing\n\ntx ty tz\n", "it has no poses");
    expect_log_refused(identity_row + "1 0 0 0 0 1 0 0 0 0 1\n",
                       "line 2: it has 11 columns, and the rows");
    expect_log_refused("1 0 0 0 0 1 0 0 0 0 1\n", "line 1: it has 11 columns; give 12 numbers");
    expect_log_refused("1 2 3 0 0 0 1\n0 1 2 3 0 0 0 1\n",
                       "line 2: it has 8 columns, and the rows");
    expect_log_refused("0,5;1,5;2,5;0,5;0,5;0,5;0,5\n", "line 1: it has 14 columns");
    expect_log_refused("1 0 0 0 0 1 0 0 0 0 1,\n", "line 1: '' is not a number");
    expect_log_refused("1,2,,0,0,0,1\n", "line 1: '' is not a number");
    expect_log_refused(",1,2,3,0,0,0,1\n", "line 1: '' is not a number");
    for (const char* word : {"nan", "-inf", "1e999", "1e71", "0x10", "1.0f", "\"1\""})
        expect_log_refused("# one\n1 0 0 " + std::string(word) + " 0 1 0 0 0 0 1 0\n",
                           "line 2: '" + std::string(word) + "' is not a number");
    expect_log_refused(identity_row + "1 0 0 0 0 1 0 0 0 0 -1 0\n",
                       "line 2: the pose is not rigid (it mir");
    expect_log_refused(identity_row + "2 0 0 0 0 2 0 0 0 0 2 0\n", "line 2: the pose is not rigid");
    expect_log_refused("0 0 0 0 0 0 0\n", "line 1: the squared length of the quaternion");
    expect_log_refused("0 0 0 0 0 0 1e60\n", "line 1: the squared length of the quaternion");
    expect_log_refused("words\nmore words\n1 2 3 0 0 0 1\n", "line 2: it has 2 columns");
    // Other formats write w first, which may also be a rotation.
    expect_log_refused("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n",
                       "line 2: the header names w before z");
    EXPECT_EQ(read_log("t,x,y,z,qx,qy,qz,qw\n0,0,0,0,1,0,0,0\n").told.size(), 1u);
    expect_log_refused(std::string("\0\x01\x89PNG\n", 7) + identity_row + "\xff\xfe\n",
                       "line 3: it has 1 column");
    expect_log_refused(std::string(100'000, '1'), "line 1: it has more than 64 KiB");
    expect_in("there is no such file", refusal([] { PoseLogs(false).read("gone.csv"); }));
    expect_in("not a regular file", refusal([] { PoseLogs(false).read("/dev/zero"); }));
}

TEST(PoseLog, HasAsManyRowsAsASceneMayHaveFrames) {
    const TemporaryFolder folder;
    const std::string file = folder / "long.csv";
    {
        std::ofstream out(file);
        for (int i = 0; i <= most_frames; ++i) out << "0 0 0 0 0 0 1\n";
    }
    expect_in("long.csv: line 1000001: more than 1,000,000 poses",
              refusal([&] { PoseLogs(false).read(file); }));
}

TEST(PoseLog, HasAsManyRowsAsTheOthers) {
    const TemporaryFolder folder;
    const std::string two = folder.write("two.csv", identity_row + identity_row),
                      one = folder.write("one.csv", identity_row);
    PoseLogs logs(false);
    EXPECT_EQ(logs.frames(), 0);
    logs.read(two);
    EXPECT_EQ(logs.frames(), 2);
    logs.read(two);
    EXPECT_EQ(refusal([&] { logs.read(one); }),
              one + ": it has 1 pose, and " + two + " has 2; all logs must have as many rows.");
}

std::string scene_of_boxes(const std::string& bodies, const std::string& more = "") {
    return R"({"scb_scene": 1, "name": "s", )" + more +
           R"("models": [{"name": "m", "box": {}}], "bodies": [)" + bodies + "]}";
}

TEST(PoseLog, MovesABodyOfASceneFile) {
    const TemporaryFolder folder;
    folder.write("log.csv", identity_row + "1 0 0 5 0 1 0 0 0 0 1 0\n");
    folder.write("one.csv", identity_row);
    const std::string rests = R"({"name": "A", "model": "m", "position": [1, 2, 3]})",
                      moves = R"({"name": "B", "model": "m", "poses": "log.csv"})";
    const auto load = [&](const std::string& text) {
        return load_scene_file(folder.write("s.json", text), "");
    };
    const Scene scene = load(scene_of_boxes(rests + ", " + moves, R"("default_frame": 1, )"));
    EXPECT_EQ(scene.frames, 2);
    EXPECT_EQ(scene.default_frame, 1);
    EXPECT_EQ(pose_at(scene.bodies[1].motion, 1).translation, Vec3(5, 0, 0));
    EXPECT_EQ(pose_at(scene.bodies[0].motion, 1).translation, Vec3(1, 2, 3));
    EXPECT_EQ(load(scene_of_boxes(moves, R"("frames": 2, )")).frames, 2);
    const auto refused_scene = [&](const std::string& text) {
        return refusal([&] { load(text); });
    };
    expect_in("s.json: frames: there are 3, and " + (folder / "log.csv") + " has 2 poses",
              refused_scene(scene_of_boxes(moves, R"("frames": 3, )")));
    expect_in("default_frame", refused_scene(scene_of_boxes(moves, R"("default_frame": 2, )")));
    const std::string other = R"({"name": "C", "model": "m", "poses": "one.csv"})";
    expect_in("s.json: bodies[1].poses: " + (folder / "one.csv") + ": it has 1 pose",
              refused_scene(scene_of_boxes(moves + ", " + other)));
    for (const char* more :
         {R"("pose": [1,0,0,0,0,1,0,0,0,0,1,0])", R"("position": [0,0,0])", R"("rotation": [])"})
        expect_in(
            "bodies[0]: poses stands for",
            refused_scene(scene_of_boxes(R"({"name": "B", "model": "m", "poses": "log.csv", )" +
                                         std::string(more) + "}")));
    expect_in("bodies[0].poses: there is no log of poses gone.csv in " + folder.path.string(),
              refused_scene(scene_of_boxes(R"({"name": "B", "model": "m", "poses": "gone.csv"})")));
    // The folder of models has it, too.
    EXPECT_EQ(parse_scene(scene_of_boxes(moves), {"t.json", "/nowhere", folder.path}).frames, 2);
}

TEST(PoseLog, MovesTwoMeshes) {
    const TemporaryFolder folder;
    const std::string mesh = folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                      log = folder.write("log.csv", identity_row + "1 0 0 5 0 1 0 0 0 0 1 0\n"),
                      one = folder.write("one.csv", identity_row);
    LoadOptions options;
    options.logs[1] = log;
    const Scene scene = load_scene({mesh, mesh}, options);
    EXPECT_EQ(scene.frames, 2);
    EXPECT_EQ(pose_at(scene.bodies[0].motion, 1).translation, Vec3(0, 0, 0));
    EXPECT_EQ(pose_at(scene.bodies[1].motion, 1).translation, Vec3(5, 0, 0));
    options.logs = {log, ""};
    EXPECT_EQ(pose_at(load_scene({mesh, mesh}, options).bodies[0].motion, 1).translation,
              Vec3(5, 0, 0));
    options.logs = {log, one};
    expect_in(one + ": it has 1 pose, and " + log + " has 2", refusal([&] {
                  load_scene({mesh, mesh}, options);
              }));
    expect_in("--poses: it moves two mesh files", refusal([&] { load_scene({mesh}, options); }));
}

}  // namespace
}  // namespace scb::scenes
