#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

struct FolderIndex : testing::Test {
    TemporaryFolder folder;
    std::string out = folder / "out", file = out + "/index.json";

    json run(const std::string& arguments) {
        const ProgramRun ended = run_scb(arguments + " --size 320x240 -o " + out);
        EXPECT_LT(ended.status, 2) << ended.err;
        return json::parse(file_text(file));
    }
    static std::vector<std::string> files_of(const json& of_run) {
        std::vector<std::string> files;
        for (const json& entry : of_run["files"]) files.push_back(entry["file"]);
        return files;
    }
};

TEST_F(FolderIndex, CollectsTheRunsOfAFolder) {
    const std::string levels = "render levels cone --levels 2",
                      pairs = "render pairs cone --frames 80",
                      inspect = "inspect cone --frames 80 --top 1";
    const json first = run(levels);
    EXPECT_FALSE(first.contains("earlier"));
    const std::string alone = file_text(file);
    EXPECT_EQ(run(levels), first) << "a run replaces itself";
    EXPECT_EQ(file_text(file), alone);

    json second = run(pairs);
    EXPECT_EQ(second["command"], "render pairs");
    ASSERT_EQ(second["earlier"].size(), 1u);
    EXPECT_EQ(second["earlier"][0], first);
    json third = run(inspect);
    EXPECT_EQ(third["command"], "inspect");
    ASSERT_EQ(third["earlier"].size(), 2u);
    second.erase("earlier");
    EXPECT_EQ(third["earlier"], (json{second, first})) << "the latest first";

    // A run again is the latest, and there once.
    const json again = run(levels);
    ASSERT_EQ(again["earlier"].size(), 2u);
    EXPECT_EQ(again["earlier"][0]["command"], "inspect");
    EXPECT_EQ(again["earlier"][1], second);
    json itself = again;
    itself.erase("earlier");
    EXPECT_EQ(itself, first);

    // Each picture in the folder is there once.
    std::set<std::string> all;
    std::size_t count = 0;
    for (const std::string& name : files_of(again)) all.insert(name), ++count;
    for (const json& earlier : again["earlier"])
        for (const std::string& name : files_of(earlier)) all.insert(name), ++count;
    EXPECT_EQ(all.size(), count);
    for (const std::string& name : all)
        EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;

    // What is printed is of the run.
    const ProgramRun printed = run_scb(levels + " --json --size 320x240 -o " + out);
    EXPECT_EQ(json::parse(printed.out), first);
    // --camera with this index takes the camera of its latest run.
    EXPECT_EQ(run_scb(levels + " --camera " + file + " -o " + (folder / "other")).status, 0);
}

TEST_F(FolderIndex, KeepsWhatIsLeftOfAnEarlierRun) {
    const json first = run("render traversal cone --frames 70,80");
    ASSERT_EQ(first["files"].size(), 2u);
    const json second = run("render traversal cone --frames 80,90");
    EXPECT_EQ(second["files"].size(), 2u);
    ASSERT_EQ(second["earlier"].size(), 1u);
    EXPECT_EQ(second["earlier"][0]["files"], json::array({first["files"][0]}));
}

// Of one scene there are many: each has the name of its own file in its pictures' names.
TEST_F(FolderIndex, KeepsThePicturesOfTwoRecordingsApart) {
    const std::string small = " --size 320x240", before = folder / "before.scbrec",
                      after = folder / "after.scbrec", trace = folder / "own.scbrec";
    ASSERT_EQ(run_scb("trace cone --records --frames 80 -o " + before).status, 0);
    ASSERT_EQ(run_scb("trace cone --records --frames 80 --split cost -o " + after).status, 0);
    ASSERT_EQ(run_scb("trace cone --frames 80 -o " + trace).status, 0);
    std::set<std::string> names;
    std::size_t count = 0;
    const std::vector<std::string> commands = {
        "render levels",   "render pairs", "render pairs --volume obb",      "render traversal",
        "tune --no-time ", "inspect",      "explain --volume obb --pair 0,0"};
    for (const std::string& command : commands)
        for (const std::string& recording : {before, after}) {
            const ProgramRun made = run_scb(command + " " + recording + small + " -o " + out);
            EXPECT_LT(made.status, 2) << command << made.err;
            EXPECT_EQ(made.err.find("replaced"), std::string::npos) << made.err;
            for (const std::string& line : lines(made.out)) {
                if (!line.ends_with(".png") || !line.starts_with(out)) continue;
                names.insert(line);
                ++count;
                const std::string stem = std::filesystem::path(recording).stem();
                EXPECT_TRUE(line.starts_with(out + "/" + stem + "_")) << line;
            }
        }
    EXPECT_GE(count, 2 * commands.size());
    EXPECT_EQ(names.size(), count);
    // Of two that are compared both are named; a trace has the names of its scene.
    const auto pairs_of = [&](const std::string& files) {
        return run_scb("render pairs " + files + small + " -o " + out).out;
    };
    EXPECT_NE(pairs_of(before + " " + after).find("/before-after_"), std::string::npos);
    EXPECT_EQ(pairs_of(trace), pairs_of("cone --frames 80"));
}

TEST_F(FolderIndex, SaysThatPicturesOfAnotherSourceWereReplaced) {
    for (const char* name : {"one", "two"}) {
        std::filesystem::create_directories(folder / name);
        ASSERT_EQ(run_scb("export cone --levels 2 -o " + (folder / name) + "/ball.ply").status, 0);
    }
    const std::string words = " --levels 2,3 --no-sheet --size 320x240 -o " + out,
                      one = "render levels " + (folder / "one") + "/ball.ply" + words,
                      two = "render levels " + (folder / "two") + "/ball.ply" + words;
    EXPECT_EQ(run_scb(one).err, "");
    EXPECT_EQ(run_scb(one).err, "") << "a run replaces itself";
    EXPECT_EQ(run_scb(two).err,
              "scb: 2 pictures of another run in " + out +
                  " were replaced; give each run a folder of its own with -o to keep both.\n");
    EXPECT_EQ(run_scb(two).err, "");
    // What nobody sees any more is not replaced.
    std::filesystem::remove(out + "/ball_scb_level-02_size-320x240_frame-0000.png");
    EXPECT_EQ(run_scb(one).err,
              "scb: 1 picture of another run in " + out +
                  " was replaced; give each run a folder of its own with -o to keep both.\n");
}

TEST_F(FolderIndex, LeavesOutPicturesThatAreGone) {
    run("render traversal cone --frames 70,80");
    run("render traversal cone --frames 90");
    std::filesystem::remove(out + "/cone_scb_traversal_size-320x240_frame-0070.png");
    const json third = run("render pairs cone --frames 80");
    ASSERT_EQ(third["earlier"].size(), 2u);
    EXPECT_EQ(files_of(third["earlier"][1]),
              std::vector<std::string>{"cone_scb_traversal_size-320x240_frame-0080.png"});
    std::filesystem::remove(out + "/cone_scb_traversal_size-320x240_frame-0090.png");
    EXPECT_EQ(run("render pairs cone --frames 80")["earlier"].size(), 1u);
}

TEST_F(FolderIndex, HasTheRunsOfProgramsAtTheSameTime) {
    run("render pairs cone --frames 80");
    std::vector<std::thread> programs;
    for (int i = 0; i < 6; ++i)
        programs.emplace_back([this, i] {
            EXPECT_EQ(run_scb_process("render pairs cone --samples 1 --size 320x240 --frames " +
                                      std::to_string(60 + i) + " -o " + out)
                          .status,
                      0);
        });
    for (std::thread& program : programs) program.join();
    const json found = run("render pairs cone --frames 80");
    std::set<std::string> listed;
    for (const std::string& name : files_of(found)) listed.insert(name);
    for (const json& earlier : found["earlier"])
        for (const std::string& name : files_of(earlier)) listed.insert(name);
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(listed.count("cone_scb_pairs_samples-1_size-320x240_frame-00" +
                               std::to_string(60 + i) + ".png"),
                  1u);
}

// A run that does not finish must not leave words on pictures that it has replaced.
TEST_F(FolderIndex, SaysNothingOfAPictureThatARunReplacesBeforeItIsDone) {
    const std::string scene = folder / "endless.json";
    write_text(scene, endless_scene);
    const json other = run("render traversal cone --frames 80");
    run("render pairs " + scene + " --frames 0:1 --samples 1");
    const ProgramRun killed = run_scb_interrupted(
        "render pairs " + scene + " --frames 0:9999 --samples 1 --size 320x240 -o " + out,
        [&](pid_t) { return files_in(out) > 8; }, SIGKILL);
    EXPECT_EQ(killed.status, 128 + SIGKILL);
    EXPECT_EQ(json::parse(file_text(file)), other);
}

TEST_F(FolderIndex, OfOthersOrDamagedIsLeftAlone) {
    std::filesystem::create_directory(out);
    for (const char* text :
         {"earlier", "", "[]", "{}", R"({"command": "build", "files": []})",
          R"({"command": "x", "versions": {"scb": "1"}, "files": [{"name": "a"}]})",
          R"({"command": "x", "versions": {"scb": "1"}, "files": [], "earlier": [1]})",
          R"({"command": "x", "versions": {"scb": "1"}, "files": [], "earlier": 1})"})
        for (const char* command :
             {"render levels cone --levels 2", "explain cone --frames 80 --pair 0,0",
              "inspect cone --frames 80 --top 1"}) {
            write_text(file, text);
            const ProgramRun refused = run_scb(std::string(command) + " -o " + out);
            EXPECT_EQ(refused.status, 2) << text;
            EXPECT_EQ(refused.err, "scb: error: " + file +
                                       ": this is no index of pictures that scb wrote, or a "
                                       "damaged one; move it away, or name another folder with "
                                       "-o.\n");
            EXPECT_EQ(file_text(file), text);
            EXPECT_EQ(files_in(out), 1u) << text;
        }
}

}  // namespace
}  // namespace scb::app
