#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/png_chunks.h"

namespace scb::app {
namespace {

using nlohmann::json;

/// A scene, and the recording of its queries.
struct RecordingCommands : testing::Test {
    TemporaryFolder folder;
    std::string file = folder / "own.scbrec";

    void record(const std::string& what) {
        const ProgramRun run = run_scb("trace " + what + " -o " + file);
        ASSERT_EQ(run.status, 0) << run.err;
    }
    json printed(const std::string& arguments) {
        const ProgramRun run = run_scb(arguments);
        EXPECT_EQ(run.status, 0) << arguments << "\n" << run.err;
        return run.status == 0 ? json::parse(run.out) : json();
    }
    /// The picture that the command draws, and what its index says of it.
    std::pair<std::string, json> drawn(const std::string& arguments) {
        const std::string out = folder / "out";
        const ProgramRun run =
            run_scb("render " + arguments +
                    " --size 200x150 --samples 1 --no-panel --ids --camera orbit:40,20 -o " + out);
        EXPECT_EQ(run.status, 0) << arguments << "\n" << run.err;
        const json index = json::parse(file_text(out + "/index.json"));
        const json& picture = index["files"].back();
        return {png_without_texts(file_text(out + "/" + picture["ids"].get<std::string>())),
                picture};
    }
};

TEST_F(RecordingCommands, PicturesAreThoseOfOwnQueries) {
    for (const char* volume : {"scb", "scb2", "rss", "aabb"}) {
        const std::string of_volume = std::string(" --volume ") + volume;
        record("cone --frames 100" + of_volume);
        for (const char* picture : {"pairs", "rejections", "rejections --by share",
                                    "pairs --leaves", "pairs --heat wasted"}) {
            const auto [own, own_entry] =
                drawn(std::string(picture) + " cone --frames 100" + of_volume);
            const auto [recorded, entry] = drawn(std::string(picture) + " " + file);
            EXPECT_TRUE(recorded == own) << picture << of_volume;
            EXPECT_EQ(entry["pairs_hash"], own_entry["pairs_hash"]);
            EXPECT_EQ(entry["stages"], own_entry["stages"]) << picture << of_volume;
        }
        const std::string levels = " --levels 5 --no-sheet";
        EXPECT_TRUE(drawn("levels " + file + levels).first ==
                    drawn("levels cone --frames 100" + of_volume + levels).first)
            << volume;
    }
}

TEST_F(RecordingCommands, WithAVolumeItIsAScene) {
    record("cone --frames 60,100 --volume ball");
    const auto own = printed("collide cone --frames 60,100 --volume obb --json"),
               recorded = printed("collide " + file + " --volume obb --json");
    ASSERT_EQ(recorded["frames"].size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        json frame = recorded["frames"][i];
        EXPECT_EQ(frame["recorded"],
                  (json{{"pairs", frame["pairs"]}, {"missed", 0}, {"false", 0}}));
        frame.erase("recorded");
        EXPECT_EQ(frame, own["frames"][i]);
    }
    EXPECT_TRUE(drawn("rejections " + file + " --frames 100 --volume obb").first ==
                drawn("rejections cone --frames 100 --volume obb").first);
    EXPECT_EQ(run_scb("export " + file + " --volume obb --levels 3 -o " + folder / "a.ply").status,
              0);
    EXPECT_EQ(
        run_scb("export cone --frames 60 --volume obb --levels 3 -o " + folder / "b.ply").status,
        0);
    EXPECT_TRUE(file_text(folder / "a.ply") == file_text(folder / "b.ply"));
}

TEST_F(RecordingCommands, CollideCountsWhatTheEngineMissed) {
    record("line-8 --frames 40 --test printed");
    const json frame = printed("collide " + file + " --json")["frames"][0];
    EXPECT_EQ(frame["recorded"], (json{{"pairs", 0}, {"missed", 30}, {"false", 0}}));
    const ProgramRun table = run_scb("collide " + file);
    EXPECT_NE(table.out.find("        0       30        0\n"), std::string::npos) << table.out;
    EXPECT_NE(run_scb("collide --csv " + file).out.find(",0,30,0\n"), std::string::npos);
    // Of pairs that are cut nothing is counted.
    EXPECT_FALSE(printed("collide --first " + file + " --json")["frames"][0].contains("recorded"));
}

TEST_F(RecordingCommands, TraceAndDiffReadIt) {
    record("cone --frames 60,100 --volume obb");
    const std::string trace = folder / "own.scbtrace";
    ASSERT_EQ(run_scb("trace cone --frames 60,100 --volume obb -o " + trace).status, 0);
    const json of_trace = printed("trace --json --events " + trace),
               of_recording = printed("trace --json --events " + file);
    ASSERT_EQ(of_recording["frames"].size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(of_recording["frames"][i]["tests"], of_trace["frames"][i]["tests"]);
        EXPECT_EQ(of_recording["frames"][i]["stages"], of_trace["frames"][i]["stages"]);
    }
    // Neither a file's name nor how many frames it has makes its trees others.
    const std::string copy = folder / "copy.scbrec";
    std::filesystem::copy_file(file, copy);
    EXPECT_EQ(run_scb("diff " + file + " " + copy).status, 0);
    record("cone --frames 100 --volume obb");
    const ProgramRun fewer = run_scb("diff --json " + file + " " + copy);
    EXPECT_EQ(fewer.status, 1);
    EXPECT_TRUE(json::parse(fewer.out)["nodes_comparable"]);
    EXPECT_TRUE(json::parse(fewer.out)["frames"].empty());
    EXPECT_NE(run_scb("diff " + file + " " + copy).out.find("\naxis-a0 "), std::string::npos);
    std::filesystem::copy_file(copy, file, std::filesystem::copy_options::overwrite_existing);
    const ProgramRun apart = run_scb("diff --json " + file + " " + trace);
    EXPECT_EQ(apart.status, 1);
    const json differences = json::parse(apart.out);
    EXPECT_EQ(differences["pairs_only_in_a"], 0);
    EXPECT_EQ(differences["pairs_only_in_b"], 0);
    EXPECT_EQ(differences["nodes_comparable"], false);
}

TEST_F(RecordingCommands, WhatIsAboutOwnHierarchiesAsksForTheirVolume) {
    record("cone --frames 100 --volume obb");
    const std::string out = " -o " + folder / "own.scbtrace";
    EXPECT_EQ(run_scb("trace " + file + out).status, 2);
    EXPECT_EQ(run_scb("trace " + file + " --volume obb" + out).status, 0);
    EXPECT_EQ(run_scb("explain " + file + " --pair 0,0").status, 2);
    EXPECT_EQ(run_scb("explain " + file + " --volume obb --pair 0,0").status, 0);
}

TEST_F(RecordingCommands, OfOneThatBreaksOffWhatStandsBeforeIsJudged) {
    record("cone --frames 60,100 --volume obb");
    const ProgramRun whole = run_scb("inspect " + file);
    EXPECT_EQ(whole.status, 0);
    EXPECT_NE(whole.out.find("\nSound.\n"), std::string::npos);
    const std::string bytes = file_text(file);
    for (const double part : {0.3, 0.6, 0.9}) {
        folder.write(
            "cut.scbrec",
            bytes.substr(0, static_cast<std::size_t>(part * static_cast<double>(bytes.size()))));
        const ProgramRun cut = run_scb("inspect " + folder / "cut.scbrec");
        EXPECT_EQ(cut.out.find("Wrong"), std::string::npos) << cut.out;
        EXPECT_NE(cut.status, 0);
    }
    folder.write("empty.scbrec", bytes.substr(0, 12));
    EXPECT_EQ(run_scb("inspect " + folder / "empty.scbrec").status, 2);
}

TEST_F(RecordingCommands, ItStandsBesideOwnQueries) {
    record("cone --frames 100 --volume obb");
    const std::string out = folder / "out";
    const ProgramRun run =
        run_scb("render rejections " + file + " --compare recorded,scb2 --size 640x360 -o " + out);
    EXPECT_EQ(run.status, 0) << run.err;
    const json index = json::parse(file_text(out + "/index.json"));
    const json& queries = index["files"][0]["queries"];
    EXPECT_EQ(queries[0]["pairs_hash"], queries[1]["pairs_hash"]);
    EXPECT_NE(queries[0]["n_v"], queries[1]["n_v"]);
    EXPECT_EQ(run_scb("render pairs " + file + " --compare ball,recorded --size 640x360 -o " + out)
                  .status,
              0);
    for (const char* wrong : {"recorded", "recorded,recorded", "recorded,cube"})
        EXPECT_EQ(
            run_scb("render rejections " + file + " --compare " + wrong + " -o " + out).status, 2)
            << wrong;
}

TEST_F(RecordingCommands, GoldenCasesOfItAndOfACommandThatMakesIt) {
    record("cone --frames 100 --volume obb");
    folder.write("golden.json", R"({"scb_golden": 2, "cases": [
        {"name": "kept", "run": "external", "scene": "own.scbrec"},
        {"name": "made", "run": "external", "command": ["cp", "own.scbrec", "{}"]},
        {"name": "drawn", "run": "rejections", "frames": "100",
         "command": ["cp", "own.scbrec", "{}"]}]})");
    const std::string suite = " --suite " + folder / "golden.json";
    const ProgramRun update = run_scb("golden update --all" + suite);
    EXPECT_EQ(update.status, 0) << update.out << update.err;
    const ProgramRun same = run_scb("golden check" + suite);
    EXPECT_EQ(same.status, 0) << same.out << same.err;
    record("cone --frames 100 --volume scb2");
    const ProgramRun other = run_scb("golden check" + suite);
    EXPECT_EQ(other.status, 1);
    EXPECT_NE(other.out.find("3 different"), std::string::npos) << other.out;
    EXPECT_NE(other.out.find("cp own.scbrec made.scbrec"), std::string::npos) << other.out;
    for (const char* wrong :
         {R"("command": ["true", "{}"])", R"("command": ["false", "{}"])", R"("command": ["true"])",
          R"("command": ["true", "{}"], "scene": "a")"}) {
        folder.write("golden.json",
                     R"({"scb_golden": 2, "cases": [{"name": "x", "run": "external", )" +
                         std::string(wrong) + "}]}");
        EXPECT_NE(run_scb("golden check" + suite).status, 0) << wrong;
    }
}

}  // namespace
}  // namespace scb::app
