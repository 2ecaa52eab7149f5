#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/temporary_folder.h"

namespace scb::app {
namespace {

using nlohmann::json;

/// A closed box; without its top, an open one.
void write_box(const std::string& path, double half, double height, bool with_top = true) {
    std::ofstream file(path);
    for (const double z : {0.0, height})
        for (const double y : {-half, half})
            for (const double x : {-half, half}) file << "v " << x << " " << y << " " << z << "\n";
    file << "f 1 3 2\nf 2 3 4\nf 1 2 5\nf 2 6 5\nf 3 7 4\nf 4 7 8\nf 1 5 3\nf 3 5 7\nf 2 4 6\n"
            "f 4 8 6\n";
    if (with_top) file << "f 5 6 7\nf 6 8 7\n";
}

struct Boxes {
    TemporaryFolder folder;
    std::string wide, open, thin;

    Boxes() : wide(folder / "wide.obj"), open(folder / "open.obj"), thin(folder / "thin.obj") {
        write_box(wide, 10, 2);
        write_box(open, 10, 2, false);
        write_box(thin, 1, 5);
    }
    /// The thin box sinks by 0.5 into the wide one.
    std::string query(const std::string& lower) const {
        return "collide " + lower + " " + thin + " --pose 1,0,0,3,0,1,0,4,0,0,1,1.5";
    }
};

json frame_of(const std::string& arguments) {
    const ProgramRun run = run_scb(arguments + " --json");
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(run.out)["frames"][0];
}

TEST(Patches, HaveTheirBoxAndTheirDeepestVertices) {
    const Boxes boxes;
    const json frame = frame_of(boxes.query(boxes.wide) + " --patches");
    ASSERT_EQ(frame["patches"].size(), 1u);
    const json& patch = frame["patches"][0];
    EXPECT_EQ(patch["patch"], 1);
    EXPECT_EQ(patch["pairs"], frame["pairs"]);
    EXPECT_EQ(patch["box"], json::parse(R"({"lower": [2, 3, 2], "upper": [4, 5, 2]})"));
    EXPECT_EQ(patch["deepest_a"], json::parse(R"({"judged": true, "vertex": null})"));
    const json& deepest = patch["deepest_b"];
    EXPECT_EQ(deepest["judged"], true);
    EXPECT_EQ(deepest["vertex"], 0);
    EXPECT_EQ(deepest["at"], json({2, 3, 1.5}));
    EXPECT_EQ(deepest["signed_distance"], -0.5);
    EXPECT_EQ(frame["deepest_vertex"]["body"], "thin");
    EXPECT_EQ(frame["deepest_vertex"]["in"], "wide");
    EXPECT_EQ(frame["deepest_vertex"]["patch"], 1);
    EXPECT_EQ(frame["deepest_vertex"]["signed_distance"], -0.5);

    const std::string text = run_scb(boxes.query(boxes.wide) + " --patches").out;
    EXPECT_NE(text.find("Deepest vertex: 0 of thin, 0.5 inside wide, in patch 1 of frame 0."),
              std::string::npos)
        << text;
}

TEST(Patches, OfAnOpenBodyJudgeNoDepthInIt) {
    const Boxes boxes;
    // The sides of the open box end at the place of its top, where the thin box is not.
    const std::string query =
        "collide " + boxes.open + " " + boxes.thin + " --pose 1,0,0,10,0,1,0,4,0,0,1,1.5 --patches";
    const json frame = frame_of(query);
    ASSERT_EQ(frame["patches"].size(), 1u);
    EXPECT_EQ(frame["patches"][0]["deepest_b"],
              json::parse(R"({"judged": false, "vertex": null})"));
    EXPECT_EQ(frame["patches"][0]["deepest_a"]["judged"], true);
    EXPECT_EQ(frame["deepest_vertex"], nullptr);
    EXPECT_NE(run_scb(query).out.find(
                  "How deep thin is inside open is not judged: open is not closed.\n"),
              std::string::npos);
}

TEST(Patches, AgreeInAllOutputs) {
    const TemporaryFolder folder;
    const std::string pairs = folder / "pairs.csv",
                      arguments = "collide soup --frames 90:110:10 --patches";
    const json frames = json::parse(run_scb(arguments + " --json").out)["frames"];
    const std::vector<std::string> csv = lines(run_scb(arguments + " --csv").out);
    ASSERT_EQ(run_scb(arguments + " --pairs-out " + pairs).status, 0);
    std::map<std::pair<int, int>, std::size_t> sizes;
    for (const std::string& line : lines(file_text(pairs))) {
        int frame = 0, a = 0, b = 0, patch = 0;
        if (std::sscanf(line.c_str(), "%d,%d,%d,%d", &frame, &a, &b, &patch) == 4)
            ++sizes[{frame, patch}];
    }
    std::size_t row = 1;
    for (const json& frame : frames) {
        ASSERT_GT(frame["patches"].size(), 20u);
        std::size_t sum = 0;
        for (const json& patch : frame["patches"]) {
            const std::string start = to_string(frame["frame"]) + "," + to_string(patch["patch"]) +
                                      "," + to_string(patch["pairs"]) + ",";
            ASSERT_LT(row, csv.size());
            EXPECT_EQ(csv[row++].substr(0, start.size()), start);
            EXPECT_EQ(patch["pairs"], (sizes[{frame["frame"], patch["patch"]}]));
            sum += patch["pairs"].get<std::size_t>();
        }
        EXPECT_EQ(frame["pairs"], sum);
    }
    EXPECT_EQ(row, csv.size());
    // The column of the patches does not disturb --expect.
    EXPECT_EQ(run_scb("collide soup --frames 90:110:10 --expect " + pairs).status, 0);
    // The text has the largest patches alone.
    EXPECT_NE(run_scb(arguments).out.find(" smaller ones\n"), std::string::npos);
}

TEST(Patches, OfPacksAndRestsAreTheSame) {
    const std::string query = "collide spheres-l1 --frames 100 --patches";
    const json expected = frame_of(query);
    for (const char* options : {" --volume aabb", " --layout quantized8", " --split cost"}) {
        const json frame = frame_of(query + options);
        EXPECT_EQ(frame["patches"], expected["patches"]) << options;
        EXPECT_EQ(frame["deepest_vertex"], expected["deepest_vertex"]) << options;
    }
}

TEST(Patches, OfOneBodyAndOfPartsOfTheResultHaveNoDepths) {
    const json self = frame_of("collide soup --bodies A,A --frames 0 --patches");
    ASSERT_GT(self["patches"].size(), 0u);
    EXPECT_FALSE(self["patches"][0].contains("deepest_a"));
    const std::string few = "collide spheres-l1 --frames 100 --max-pairs 100 --patches";
    const json frame = frame_of(few);
    EXPECT_EQ(frame["complete"], false);
    EXPECT_EQ(frame["patches"][0]["deepest_a"]["judged"], false);
    EXPECT_NE(run_scb(few).out.find("Depths are not judged where --max-pairs ended a query"),
              std::string::npos);
    const json printed = frame_of("collide spheres-l1 --frames 100 --test printed --patches");
    EXPECT_EQ(printed["patches"][0]["deepest_b"]["judged"], false);
}

TEST(Patches, AreOfAllPairsOfTriangles) {
    for (const auto& [options, sentence] :
         {std::pair("--first", "--patches needs pairs of triangles"),
          std::pair("--levels 3", "--patches needs pairs of triangles"),
          std::pair("--contacts crossing", "--contacts crossing: patches are of all pairs")}) {
        const ProgramRun run =
            run_scb("collide spheres-l1 --frames 100 --patches " + std::string(options));
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
    }
    for (const char* options : {"--levels 3", "--heat wasted", "--leaves", "--compare scb,obb"}) {
        const ProgramRun run = run_scb("render pairs spheres-l1 --frames 100 --patches -o out " +
                                       std::string(options));
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find("--patches: "), std::string::npos) << run.err;
    }
}

TEST(Patches, AreNumberedInPictures) {
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    const ProgramRun run =
        run_scb("render pairs soup --frames 100 --patches --size 320x240 -o " + out);
    ASSERT_EQ(run.status, 0) << run.err;
    const json index = json::parse(file_text(out + "/index.json"));
    EXPECT_EQ(index["options"]["patches"], true);
    const std::string picture = index["files"][0]["file"];
    EXPECT_NE(picture.find("_patches_"), std::string::npos) << picture;
    ASSERT_EQ(run_scb("render pairs soup --frames 100 --size 320x240 -o " + out).status, 0);
    std::string plain = picture;
    plain.replace(plain.find("_patches"), 8, "");
    EXPECT_NE(file_text(out + "/" + picture), file_text(out + "/" + plain));
}

}  // namespace
}  // namespace scb::app
