#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

const std::string sample_folder = std::string(SCB_SOURCE_DIR) + "/scenes/samples/",
                  bracket_and_pin = sample_folder + "bracket.ply " + sample_folder + "pin.obj ";

/// Rows of a pin that slides into the bracket: it is away, through the first lug, in both lugs.
const std::string slide_rows =
    "# tx ty tz qx qy qz qw\n"
    "0 -500 45 0 0 0 1\n"
    "0 0 45 0 0 0 1\n"
    "0 0 20 0 0 0 1\n";

std::vector<std::size_t> pairs_of(const ProgramRun& run) {
    EXPECT_EQ(run.status, 0) << run.err;
    std::vector<std::size_t> pairs;
    const json document = json::parse(run.out);
    for (const json& frame : document["frames"]) pairs.push_back(frame["pairs"]);
    return pairs;
}

TEST(PoseLogs, MoveTheSecondMesh) {
    const TemporaryFolder folder;
    const std::string log = folder.write("slide.csv", slide_rows),
                      command = "collide " + bracket_and_pin + "--json --poses " + log;
    const std::vector<std::size_t> pairs = pairs_of(run_scb(command));
    ASSERT_EQ(pairs.size(), 3u);
    EXPECT_EQ(pairs[0], 0u);
    EXPECT_GT(pairs[2], 0u);
    // Each row as --pose does it, and as a body of a scene file.
    for (std::size_t frame = 0; frame < 3; ++frame) {
        const char* const poses[] = {"0,-500,45", "0,0,45", "0,0,20"};
        const std::string at(poses[frame]);
        const auto first = at.find(','), last = at.rfind(',');
        const std::string matrix = "1,0,0," + at.substr(0, first) + ",0,1,0," +
                                   at.substr(first + 1, last - first - 1) + ",0,0,1," +
                                   at.substr(last + 1);
        EXPECT_EQ(pairs_of(run_scb("collide " + bracket_and_pin + "--json --pose " + matrix)),
                  (std::vector<std::size_t>{pairs[frame]}));
    }
    const std::string scene = folder.write(
        "s.json", R"({"scb_scene": 1, "name": "s", "models": [{"name": "m", "file": ")" +
                      sample_folder + R"(bracket.ply"}, {"name": "n", "file": ")" + sample_folder +
                      R"(pin.obj"}], "bodies": [{"name": "bracket", "model": "m"},
            {"name": "pin", "model": "n", "poses": "slide.csv"}]})");
    EXPECT_EQ(pairs_of(run_scb("collide --json " + scene)), pairs);
}

TEST(PoseLogs, MoveBothMeshes) {
    const TemporaryFolder folder;
    const std::string away = folder.write("away, A=.csv", "0 500 0 0 0 0 1\n0 500 0 0 0 0 1\n"),
                      in = folder.write("in.csv", "0 500 20 0 0 0 1\n0 0 20 0 0 0 1\n"),
                      both = "collide " + bracket_and_pin + "--json --poses ";
    const std::vector<std::size_t> pairs =
        pairs_of(run_scb(both + "'A=" + away + ",B=" + in + "'"));
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_GT(pairs[0], 0u);
    EXPECT_EQ(pairs[1], 0u);
    EXPECT_EQ(pairs_of(run_scb(both + "'B=" + in + ",A=" + away + "'")), pairs);
    EXPECT_EQ(pairs_of(run_scb(both + "'pin=" + in + ",bracket=" + away + "'")), pairs);
    EXPECT_EQ(pairs_of(run_scb(both + "'A=" + away + ",pin=" + in + "'")), pairs);
    EXPECT_EQ(pairs_of(run_scb(both + in)), (std::vector<std::size_t>{0, pairs[0]}));
    EXPECT_EQ(pairs_of(run_scb(both + "B=" + in)), (std::vector<std::size_t>{0, pairs[0]}));
}

TEST(PoseLogs, AreCorrectedWithANoteThatNamesTheLine) {
    const TemporaryFolder folder;
    const std::string log = folder.write("log.csv",
                                         "1 0 0 0 0 1 0 0 0 0 1 45\n"
                                         "0.866 -0.5 0 1 0.5 0.866 0 2 0 0 1 45\n"
                                         "0.866025 -0.5 0 1 0.5 0.866025 0 2 0 0 1 45\n"),
                      command = "collide " + bracket_and_pin + "--poses " + log;
    const ProgramRun run = run_scb(command);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err,
              "scb: some poses of pin are not quite rotations; the nearest ones are used, which "
              "changes their numbers by 1.9e-05 at most, in " +
                  log + ": line 2.\n");
    const ProgramRun exact = run_scb(command + " --exact-pose");
    EXPECT_EQ(exact.status, 2);
    EXPECT_NE(exact.err.find(log + ": line 2: the pose is not rigid"), std::string::npos)
        << exact.err;
}

TEST(PoseLogs, AreNotedWherePositionsLosePrecision) {
    const TemporaryFolder folder;
    for (const auto& [x, note] : std::vector<std::pair<std::string, std::string>>{
             {"1e12",
              "scb: pin is up to 1e+12 units from the origin; positions there are exact "
              "only to 0.0001 units.\n"},
             {"1e6", ""}}) {
        const std::string log = folder.write("log.csv", "0 0 0 0 0 0 1\n" + x + " 0 0 0 0 0 1\n");
        EXPECT_EQ(run_scb("collide " + bracket_and_pin + "--poses " + log).err, note);
    }
}

TEST(PoseLogs, AreRefusedWithASentence) {
    const TemporaryFolder folder;
    const std::string log = folder.write("log.csv", slide_rows),
                      one = folder.write("1.csv", slide_rows + slide_rows);
    for (const auto& [arguments, part] : std::vector<std::pair<std::string, std::string>>{
             {bracket_and_pin + "--poses " + log + " --pose 1,0,0,0,0,1,0,0,0,0,1,0",
              "--pose and --poses exclude each other"},
             {bracket_and_pin + "--poses A=" + log + ",B=" + one, ": it has 6 poses, and "},
             {bracket_and_pin + "--poses A=" + log + ",A=" + log, "A is named twice"},
             {bracket_and_pin + "--poses B=" + log + ",pin=" + log, "pin is named twice"},
             {bracket_and_pin + "--poses A=,B=" + log, "the file of A has no name"},
             {bracket_and_pin + "--poses B=" + log + ",pin=" + log, "pin is named twice"},
             {bracket_and_pin + "--poses " + log + " --frames 3", "there is no frame 3"},
             {bracket_and_pin + "--poses gone.csv", "gone.csv: there is no such file"},
             {sample_folder + "bracket.json --poses " + log, "--poses: it moves two mesh files"}}) {
        const ProgramRun run = run_scb("collide " + arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
    }
    // No command overwrites the log.
    const ProgramRun run =
        run_scb("collide " + bracket_and_pin + "--poses " + log + " --pairs-out " + log);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(file_text(log), slide_rows);
}

TEST(PoseLogs, AreInTraces) {
    const TemporaryFolder folder;
    const std::string log = folder.write("slide.csv", slide_rows), trace = folder / "t.scbrec";
    ASSERT_EQ(run_scb("trace " + bracket_and_pin + "--poses " + log + " -o " + trace).status, 0);
    // The trace has the poses, and needs no log.
    const ProgramRun from_log = run_scb("inspect --json --no-advice " + bracket_and_pin +
                                        "--poses " + log),
                     from_trace = run_scb("inspect --json --no-advice " + trace);
    ASSERT_EQ(from_log.status, 0) << from_log.err;
    ASSERT_EQ(from_trace.status, 0) << from_trace.err;
    EXPECT_EQ(json::parse(from_trace.out)["frames"], json::parse(from_log.out)["frames"]);
    const ProgramRun both = run_scb("inspect " + trace + " --poses " + log);
    EXPECT_EQ(both.status, 2);
    EXPECT_NE(both.err.find("--poses: "), std::string::npos) << both.err;
}

TEST(PoseLogs, AreInSuites) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path / "logs");
    const std::string log = folder.write("logs/slide.csv", slide_rows);
    const ProgramRun init = run_scb("golden init --ci none " + bracket_and_pin + "--poses " + log +
                                    " -o " + (folder / "suite"));
    ASSERT_EQ(init.status, 0) << init.err;
    const std::string cases = file_text(folder.path / "suite/cases.json");
    EXPECT_NE(cases.find(R"("--poses", "../logs/slide.csv")"), std::string::npos) << cases;
    const ProgramRun both =
        run_scb("golden init --ci none " + bracket_and_pin + "--poses A=" + log + ",B=" + log +
                " -o " + (folder / "suite2"));
    ASSERT_EQ(both.status, 0) << both.err;
    const std::string of_both = file_text(folder.path / "suite2/cases.json");
    EXPECT_NE(of_both.find(R"("--poses", "bracket=../logs/slide.csv,pin=../logs/slide.csv")"),
              std::string::npos)
        << of_both;
    for (const char* suite : {"suite", "suite2"}) {
        const ProgramRun checked =
            run_scb("golden update counts --suite " + (folder / suite) + "/cases.json" +
                    " --baselines " + (folder / "baselines"));
        EXPECT_EQ(checked.status, 0) << checked.err << checked.out;
    }
}

}  // namespace
}  // namespace scb::app
