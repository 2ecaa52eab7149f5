#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/app/program.h"
#include "tests/png_chunks.h"

namespace scb::app {
namespace {

using nlohmann::json;

struct PictureNames : testing::Test {
    TemporaryFolder folder;
    std::string out = folder / "out";

    /// The names of the pictures that a command makes, without their ending.
    std::vector<std::string> names_of(const std::string& command) {
        const ProgramRun run = run_scb(command + " -o " + out);
        EXPECT_LT(run.status, 2) << command << run.err;
        std::vector<std::string> names;
        for (const std::string& line : lines(run.out))
            if (line.starts_with(out + "/") && line.ends_with(".png"))
                names.push_back(line.substr(out.size() + 1, line.size() - out.size() - 5));
        return names;
    }
    std::string name_of(const std::string& command) {
        const std::vector<std::string> names = names_of(command);
        return names.empty() ? "" : names[0];
    }
};

TEST_F(PictureNames, AreShortWhereNothingIsAsked) {
    EXPECT_EQ(name_of("render levels cone --frames 0 --levels 2"), "cone_scb_level-02_frame-0000");
    EXPECT_EQ(name_of("render pairs cone --frames 80"), "cone_scb_pairs_frame-0080");
    EXPECT_EQ(name_of("render rejections cone --frames 80"), "cone_scb_rejections_frame-0080");
    EXPECT_EQ(name_of("render traversal cone --frames 80"), "cone_scb_traversal_frame-0080");
    EXPECT_EQ(name_of("explain cone --frames 80 --pair 0,0"),
              "cone_scb_explain_frame-0080_A-0_B-0");
}

// No picture takes the name of one that was drawn with other options.
TEST_F(PictureNames, SayWhatIsNotAsByDefault) {
    const auto expect = [&](const std::string& command, const std::string& options,
                            const std::string& name) {
        EXPECT_EQ(name_of(command + " " + options), name) << command << " " << options;
    };
    for (const auto& [options, part] :
         {std::pair{"--by share", "by-share"},
          {"--test extents", "test-extents"},
          {"--test corrected --threshold 0.25", "test-corrected_threshold-0.25"},
          {"--descent area", "descent-area"},
          {"--split cost", "split-cost"},
          {"--growth radius", "growth-radius"},
          {"--margin 0.01", "margin-0.01"},
          {"--levels 4", "level-4"},
          {"--max-pairs 7", "max-pairs-7"},
          {"--stages ball-ball,ball-slab", "stages-ball-ball-ball-slab"},
          {"--depth 0:3", "depth-0-3"},
          {"--body B", "body-B"},
          {"--opacity 0.5", "opacity-0.5"},
          {"--nested", "nested"},
          {"--camera contact", "camera-contact"},
          {"--camera orbit:-20,30", "camera-orbit--20-30"},
          {"--up x", "up-x"},
          {"--ortho", "ortho"},
          {"--clip 0,0,1,0.3", "clip-0-0-1-0.3"},
          {"--clip -.5,0,-2e-1,-0", "clip--0.5-0--0.2-0"},
          {"--samples 1", "samples-1"},
          {"--size 400x300", "size-400x300"},
          {"--background dark", "background-dark"}})
        expect("render rejections cone --frames 80", options,
               std::string("cone_scb_rejections_") + part + "_frame-0080");
    expect("render rejections cone --frames 80", "--test extents --by share --size 400x300",
           "cone_scb_rejections_by-share_test-extents_size-400x300_frame-0080");
    for (const auto& [options, part] :
         {std::pair{"--leaves", "pairs_leaves"},
          {"--heat volumes", "heat-volumes"},
          {"--heat volumes --heat-end 50", "heat-volumes_heat-end-50"}})
        expect("render pairs cone --frames 80", options,
               std::string("cone_scb_") + part + "_frame-0080");
    for (const auto& [options, part] :
         {std::pair{"--by share", "by-share"}, {"--show matrix", "show-matrix"}})
        expect("render traversal cone --frames 80", options,
               std::string("cone_scb_traversal_") + part + "_frame-0080");
    for (const auto& [options, part] : {std::pair{"--color-by depth", "color-by-depth"},
                                        {"--opacity 0.5", "opacity-0.5"},
                                        {"--mesh", "mesh"},
                                        {"--edges", "edges"},
                                        {"--split cost", "split-cost"}})
        expect("render levels cone --frames 0 --levels 2", options,
               std::string("cone_scb_level-02_") + part + "_frame-0000");
    expect("explain cone --frames 80 --pair 0,0", "--test printed --ortho",
           "cone_scb_explain_test-printed_ortho_frame-0080_A-0_B-0");
    expect("inspect cone --frames 80 --top 1", "--descent area",
           "cone_scb_inspect_descent-area_frames-80");
    // What the volumes do not have changes nothing.
    expect("render rejections cone --frames 80 --volume obb", "--growth radius",
           "cone_obb_rejections_frame-0080");
}

TEST_F(PictureNames, OfSheetsSayWhatIsOnThem) {
    const std::string small = " --size 320x240 --samples 1";
    EXPECT_EQ(
        names_of("render levels cone --frames 0 --volume scb,ball --levels 2,3" + small).back(),
        "cone_levels_sheet_volume-scb-ball_levels-2-3_samples-1_size-320x240_frame-0000");
    EXPECT_EQ(names_of("render pairs cone --frames 70:80:5 --sheet" + small).back(),
              "cone_scb_pairs_sheet_samples-1_size-320x240_frames-70-to-80-by-5");
    const std::vector<std::string> names =
        names_of("render rejections cone --frames 70,80 --sheet" + small);
    ASSERT_EQ(names.size(), 4u);
    EXPECT_EQ(names[2], "cone_scb_rejections_stages_samples-1_size-320x240_frames-70-80");
}

TEST_F(PictureNames, OfTwoMeshesSayThePose) {
    const std::string mesh = folder / "m.off";
    write_text(mesh,
               "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
               "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    const std::string meshes = " " + mesh + " " + mesh, small = " --size 320x240 --samples 1";
    std::set<std::string> names;
    for (const char* pose :
         {"", " --pose 1,0,0,0,0,1,0,0,0,0,1,0", " --pose 1,0,0,0.25,0,1,0,0,0,0,1,0",
          " --pose 1,0,0,0.5,0,1,0,0,0,0,1,0"})
        names.insert(name_of("render pairs" + meshes + pose + small));
    EXPECT_EQ(names.size(), 3u);
    EXPECT_EQ(names.count("m-m_scb_pairs_samples-1_size-320x240_frame-0000"), 1u);
}

TEST_F(PictureNames, FitIntoAFileSystem) {
    const std::string list = "ball-ball,ball-slab,slab-ball,triangles apart,triangles meet";
    std::set<std::string> names;
    for (const std::string& stages : {list, list + ",cylinder-slab", list + ",slab-cylinder"})
        names.insert(
            name_of("render rejections cone --frames 80 --ids --camera contact --up y "
                    "--margin 0.0123456789 --threshold 0.123456789 --descent area "
                    "--split cost --size 320x240 --samples 1 --stages '" +
                    stages + "'"));
    EXPECT_EQ(names.size(), 3u) << "each has its own";
    for (const std::string& name : names) EXPECT_LT(name.size(), 240u) << name;
}

TEST_F(PictureNames, AreInTheFilesWithTheCommand) {
    std::string there = folder / "a b", elsewhere = folder / "c";
    for (const std::string& place : {there, elsewhere}) {
        std::filesystem::create_directory(place);
        write_text(place + "/pyra mid.off",
                   "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                   "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    }
    const auto draw = [&](const std::string& place, const std::string& more) {
        const std::string mesh = " '" + place + "/pyra mid.off'", result = place + "/out";
        const ProgramRun run = run_scb("render pairs" + mesh + mesh + more +
                                       " --models /tmp --size 320x240 --ids -o '" + result + "'");
        EXPECT_EQ(run.status, 0) << run.err;
        std::vector<std::string> files;
        const json index = json::parse(file_text(result + "/index.json"));
        for (const char* key : {"file", "ids"})
            files.push_back(file_text(result + "/" + index["files"][0][key].get<std::string>()));
        return files;
    };
    const std::vector<std::string> files = draw(there, " --leaves --jobs 2");
    for (const std::string& file : files) {
        std::map<std::string, std::string> texts = png_texts(file);
        EXPECT_EQ(texts["Software"],
                  "scb " + json::parse(file_text(there + "/out/index.json"))["versions"]["scb"]
                               .get<std::string>());
        EXPECT_EQ(texts["Scene"], "pyra-mid-pyra-mid");
        EXPECT_EQ(texts["Command"],
                  "scb render pairs 'pyra mid.off' 'pyra mid.off' --size 320x240 --leaves");
        EXPECT_EQ(texts.size(), 3u);
    }
    // Names depend neither on the folder of the files nor on the order of the options.
    EXPECT_EQ(draw(elsewhere, " --jobs 1 --leaves"), files);
    // Every command says what it is.
    EXPECT_EQ(run_scb("tune cone --frames 80 --no-time -o " + elsewhere).status, 0);
    EXPECT_EQ(png_texts(file_text(elsewhere + "/cone_tune_frames-80_no-time.png"))["Command"],
              "scb tune cone --frames 80 --no-time");
}

}  // namespace
}  // namespace scb::app
