#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

const std::string of_bracket =
    "collide " + std::string(SCB_SOURCE_DIR) + "/scenes/samples/bracket.json ";

/// A triangle in z = 0, and copies of it in other places: triangle 0 of `a` crosses triangle 0 of
/// `b` 0.25 deep and is 1 below its triangle 1; in frame 1, all are apart. Triangle 2 touches.
struct Triangles {
    TemporaryFolder folder;
    std::string command;

    Triangles() {
        folder.write("a.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
        folder.write("b.obj",
                     "v 1 1 -0.25\nv 1 1 4\nv 2 1 4\nf 1 2 3\n"
                     "v 1 1 1\nv 2 1 1\nv 1 2 1\nf 4 5 6\n"
                     "v 1 1 0\nv 1 1 5\nv 1 2 5\nf 7 8 9\n");
        folder.write("log.csv", "0 0 0 0 0 0 1\n0 0 9 0 0 0 1\n");
        command = "collide " + (folder / "a.obj") + " " + (folder / "b.obj") + " --poses " +
                  (folder / "log.csv") + " ";
    }
    ProgramRun expecting(const std::string& rows, const std::string& more = "") const {
        const std::string file = folder.write("p.csv", "frame,triangle_a,triangle_b\n" + rows);
        return run_scb(command + "--expect " + file + " " + more);
    }
};

void expect_in(const std::string& part, const std::string& whole) {
    EXPECT_NE(whole.find(part), std::string::npos) << whole;
}

TEST(ExpectedPairs, AgreeWithWhatPairsOutHasWritten) {
    const TemporaryFolder folder;
    const std::string file = folder / "pairs.csv", frames = "--frames 75:95:10 ";
    ASSERT_EQ(run_scb(of_bracket + frames + "--pairs-out " + file).status, 0);
    const std::size_t pairs = lines_of(file_text(file)) - 1;
    ASSERT_GT(pairs, 200u);
    for (const char* more : {"", "--layout quantized8", "--volume obb"}) {
        const ProgramRun run = run_scb(of_bracket + frames + more + " --expect " + file);
        EXPECT_EQ(run.status, 0) << run.err;
        expect_in(
            "\nAll " + std::to_string(pairs) + " pairs of 3 frames agree with " + file + ".\n",
            run.out);
    }
    // Frames that are not queried are not compared, and a frame without rows has no pairs.
    const ProgramRun one = run_scb(of_bracket + "--frames 85 --expect " + file);
    EXPECT_EQ(one.status, 0);
    EXPECT_EQ(one.err, "scb: " + file + ": " + std::to_string(pairs - 133) +
                           " rows are not compared: " + std::to_string(pairs - 133) +
                           " of frames that are not queried.\n");
    EXPECT_EQ(run_scb(of_bracket + "--frames 75 --expect " + file).status, 0);
    const ProgramRun more = run_scb(of_bracket + "--frames 85,86 --expect " + file);
    EXPECT_EQ(more.status, 1);
    expect_in(": 2 frames have ", more.out);
}

TEST(ExpectedPairs, NameMissingAndFalsePairsWithDepthAndDistance) {
    const Triangles scene;
    EXPECT_EQ(scene.expecting("0,0,0\n0,0,2\n").status, 0);
    // In any order, twice, with blanks and line ends of other systems.
    EXPECT_EQ(scene.expecting("0, 0, 2\r\n0,0,0\r\n\r\n0,0,2").status, 0);
    const ProgramRun run = scene.expecting("0,0,2\n0,0,1\n1,0,0\n");
    EXPECT_EQ(run.status, 1);
    expect_in(
        "p.csv: 2 frames have 2 pairs. 1 pair is missing in the file, at most 0.25 deep; "
        "2 pairs are false in the file, at most 8.75 apart.\n"
        "Pairs are missing in frame 0.\n"
        "Pairs are false in frames 0 to 1.\n"
        "  frame 0, triangles (0, 0): missing, depth 0.25\n"
        "  frame 0, triangles (0, 1): false, distance 1\n"
        "  frame 1, triangles (0, 0): false, distance 8.75\n",
        run.out);
    // A frame without any of its pairs is named apart.
    expect_in("\nAll pairs are missing in frame 0.\nPairs are missing in frame 0.\n",
              scene.expecting("1,0,0\n").out);
    const ProgramRun as_json = scene.expecting("0,0,2\n0,0,1\n1,0,0\n", "--json");
    EXPECT_EQ(as_json.status, 1);
    const json frames = json::parse(as_json.out)["frames"];
    EXPECT_EQ(frames[0]["expected"],
              json::parse(R"({"pairs": 2, "missing": [{"triangles": [0, 0], "depth": 0.25}],
                              "false": [{"triangles": [0, 1], "distance": 1.0}]})"));
    EXPECT_EQ(frames[1]["expected"], json::parse(R"({"pairs": 1, "missing": [],
                              "false": [{"triangles": [0, 0], "distance": 8.75}]})"));
    const std::vector<std::string> csv =
        lines(scene.expecting("0,0,2\n0,0,1\n1,0,0\n", "--csv").out);
    EXPECT_TRUE(csv[0].ends_with(",expected,missing,false")) << csv[0];
    EXPECT_TRUE(csv[1].ends_with(",2,1,1")) << csv[1];
    EXPECT_TRUE(csv[2].ends_with(",1,0,1")) << csv[2];
}

TEST(ExpectedPairs, AreOfTheChosenContacts) {
    const Triangles scene;
    EXPECT_EQ(scene.expecting("0,0,0\n", "--contacts crossing").status, 0);
    EXPECT_EQ(scene.expecting("0,0,2\n", "--contacts touching").status, 0);
    EXPECT_EQ(scene.expecting("0,0,0\n0,0,2\n", "--contacts all").status, 0);
    const ProgramRun run = scene.expecting("0,0,0\n0,0,2\n", "--contacts crossing");
    EXPECT_EQ(run.status, 1);
    expect_in("triangles (0, 2): left out here, but the triangles touch\n", run.out);
    EXPECT_EQ(
        json::parse(
            scene.expecting("0,0,0\n", "--contacts touching --json").out)["frames"][0]["expected"],
        json::parse(R"({"pairs": 1, "missing": [{"triangles": [0, 2], "depth": 0.0}],
                              "false": [{"triangles": [0, 0], "contact": "crossing"}]})"));
}

TEST(ExpectedPairs, HintAtExchangedColumns) {
    const Triangles scene;
    // The triangle that is refused is one of the other body.
    expect_in("a has the triangles 0 to 0; number them in the order of the mesh file, and see",
              scene.expecting("0,2,0\n").err);
    const TemporaryFolder folder;
    const std::string file = folder / "pairs.csv", spheres = "collide spheres-l1 --frame 240 ";
    ASSERT_EQ(run_scb(spheres + "--pairs-out " + file).status, 0);
    std::string text = file_text(file);
    const std::size_t pairs = lines_of(text) - 1;
    ASSERT_GT(pairs, 10u);
    text.replace(0, text.find('\n'), "frame,triangle_b,triangle_a");
    const ProgramRun run = run_scb(spheres + "--expect " + folder.write("exchanged.csv", text));
    EXPECT_EQ(run.status, 1);
    expect_in(" missing pairs are in the file with the two triangles exchanged; see", run.out);
    EXPECT_EQ(
        run_scb(spheres + "--expect " + folder.write("none.csv", "frame,triangle_a,triangle_b\n"))
            .out.find("exchanged"),
        std::string::npos);
}

TEST(ExpectedPairs, ListTheFirstAndCountTheRest) {
    const TemporaryFolder folder;
    const std::string none = folder.write("none.csv", "frame,triangle_a,triangle_b\n");
    const ProgramRun run = run_scb(of_bracket + "--frames 85 --expect " + none);
    EXPECT_EQ(run.status, 1);
    expect_in("1 frame has 133 pairs. 133 pairs are missing in the file, at most ", run.out);
    expect_in("\n  and 113 more\n", run.out);
    std::size_t listed = 0;
    double last = 1e9;
    for (const std::string& line : lines(run.out)) {
        const std::size_t at = line.find(": missing, depth ");
        if (at == std::string::npos) continue;
        const double depth = std::stod(line.substr(at + 17));
        EXPECT_LE(depth, last) << line;
        last = depth;
        ++listed;
    }
    EXPECT_EQ(listed, 20u);
}

TEST(ExpectedPairs, NameTheBodiesOfSeveral) {
    const TemporaryFolder folder;
    const std::string
        scene = folder.write(
            "s.json",
            R"({"scb_scene": 1, "name": "s", "models": [{"name": "m", "box": {}}], "bodies": [
            {"name": "base", "model": "m"}, {"name": "nut, M3", "model": "m", "position": [0.5, 0, 0]},
            {"name": "tool", "model": "m", "position": [0, 0.5, 0]},
            {"name": "far", "model": "m", "position": [9, 0, 0]}]})"),
        command = "collide " + scene + " ", file = folder / "pairs.csv";
    ASSERT_EQ(run_scb(command + "--pairs-out " + file).status, 0);
    const std::string text = file_text(file);
    expect_in("0,base,\"nut, M3\",", text);
    EXPECT_EQ(run_scb(command + "--expect " + file).status, 0);
    const ProgramRun of_two = run_scb(command + "--bodies 'tool,nut, M3' --expect " + file);
    EXPECT_EQ(of_two.status, 0);
    expect_in(" of bodies that are not queried.\n", of_two.err);
    // A file may have the bodies in the other order, and one pair of them needs no names.
    std::string swapped = "frame,body_a,body_b,triangle_b,triangle_a\n",
                one = "frame,triangle_a,triangle_b\n";
    for (const std::string& line : lines(text)) {
        const std::string start = "0,base,\"nut, M3\",";
        if (line.starts_with("0,base,tool,"))
            swapped += "0,tool,base," + line.substr(12) + "\n";
        else if (!line.starts_with("frame"))
            swapped += line + "\n";
        if (line.starts_with(start)) one += "0," + line.substr(start.size()) + "\n";
    }
    const std::string one_file = folder.write("one.csv", one);
    EXPECT_EQ(run_scb(command + "--bodies 'base,nut, M3' --expect " + one_file).status, 0);
    const ProgramRun unnamed = run_scb(command + "--expect " + one_file);
    EXPECT_EQ(unnamed.status, 2);
    expect_in("line 1: the queries are of 6 pairs of bodies; add the columns", unnamed.err);
    const std::string less = folder.write("less.csv", text.substr(0, text.rfind("\n0,") + 1));
    const ProgramRun run = run_scb(command + "--expect " + less);
    EXPECT_EQ(run.status, 1);
    expect_in("  frame 0, nut, M3 and tool, triangles (", run.out);
    const json queries =
        json::parse(run_scb(command + "--json --expect " + less).out)["frames"][0]["queries"];
    EXPECT_EQ(queries[3]["expected"]["missing"].size(), 1u);
    EXPECT_EQ(queries[0]["expected"]["missing"].size(), 0u);
}

TEST(ExpectedPairs, MayBeOfABodyWithItself) {
    const TemporaryFolder folder;
    const std::string file = folder / "pairs.csv", soup = "collide soup --frame 0 --bodies A,A ";
    ASSERT_EQ(run_scb(soup + "--pairs-out " + file).status, 0);
    std::string swapped;
    for (const std::string& line : lines(file_text(file))) {
        const std::size_t first = line.find(','), last = line.rfind(',');
        swapped += line.starts_with("frame") ? line + "\n"
                                             : "0" + line.substr(last) + "," +
                                                   line.substr(first + 1, last - first - 1) + "\n";
    }
    const ProgramRun run = run_scb(soup + "--expect " + folder.write("swapped.csv", swapped));
    EXPECT_EQ(run.status, 0) << run.out << run.err;
}

TEST(ExpectedPairs, AreRefusedWithASentence) {
    const TemporaryFolder folder;
    const std::string header = "frame,triangle_a,triangle_b\n";
    for (const auto& [text, part] : std::vector<std::pair<std::string, std::string>>{
             {"", "the first line must name the columns"},
             {"85,0,0\n", "line 1: the first line must name the columns"},
             {"frame,node_a,node_b\n", "line 1: the first line must name the columns"},
             {"frame,body_a,triangle_a,triangle_b\n", "line 1: the first line must name"},
             {"frame,triangle_a,triangle_b,triangle_a\n",
              "line 1: the column triangle_a is there tw"},
             {header + "85,0\n", "line 2: it has 2 cells, and the first line 3"},
             {header + "85,0,0,0\n", "line 2: it has 4 cells, and the first line 3"},
             {header + "100,0,0\n", "line 2: there is no frame 100; the scene 'bracket' has the "},
             {header + "-1,0,0\n", "line 2: frame is '-1'; give a whole number"},
             {header + "85,1.0,0\n", "line 2: triangle_a is '1.0'; give a whole number"},
             {header + "85,0,99999999999\n", "line 2: triangle_b is '99999999999'; give"},
             {header + "85,1368,0\n",
              "line 2: triangle_a is 1368, and bracket has the triangles 0 "},
             {header + "85,0,400\n",
              "line 2: triangle_b is 400, and pin has the triangles 0 to 399"},
             {"frame,body_a,body_b,triangle_a,triangle_b\n85,bracket,nut,0,0\n",
              "line 2: there is no body 'nut'; the scene has bracket, pin."},
             {std::string("\0\x89PNG\n\xff\xfe", 8), "line 1: the first line must name"},
             {std::string(100'000, 'x'), "line 1: it has more than 64 KiB"}}) {
        const ProgramRun run =
            run_scb(of_bracket + "--frames 85 --expect " + folder.write("p.csv", text));
        EXPECT_EQ(run.status, 2) << text.substr(0, 100);
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        expect_in("p.csv: ", run.err);
        expect_in(part, run.err);
    }
    const std::string file = folder.write("p.csv", header);
    for (const auto& [arguments, part] : std::vector<std::pair<std::string, std::string>>{
             {"--first", "--expect needs all pairs"},
             {"--levels 3", "--expect needs all pairs"},
             {"--pairs-out " + file, "--pairs-out"}}) {
        const ProgramRun run =
            run_scb(of_bracket + "--frames 85 --expect " + file + " " + arguments);
        EXPECT_EQ(run.status, 2) << arguments;
        expect_in(part, run.err);
    }
    EXPECT_EQ(file_text(file), header);
    expect_in("there is no such file", run_scb(of_bracket + "--expect gone.csv").err);
    const std::string recording = folder / "r.scbrec";
    ASSERT_EQ(run_scb("trace soup --frame 0 --records -o " + recording).status, 0);
    const ProgramRun recorded = run_scb("collide " + recording + " --expect " + file);
    EXPECT_EQ(recorded.status, 2);
    expect_in("r.scbrec has pairs of its own", recorded.err);
}

}  // namespace
}  // namespace scb::app
