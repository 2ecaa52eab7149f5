#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/platform/output_file.h"
#include "render/files/image_file.h"
#include "tests/app/program.h"
#include "tests/png_chunks.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(RenderLevels, RenderedLevelsAreCountedInTheIndex) {
    const TemporaryFolder folder;
    const ProgramRun run = run_scb(
        "render levels knots-l1 --volume scb,ball --levels 3,5,leaves --size 320x240 --ids -o " +
        (folder / "out"));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const json index = json::parse(file_text(folder / "out/index.json"));
    const json stats = json::parse(run_scb("stats knots-l1 --json").out)["hierarchies"];
    ASSERT_EQ(index["files"].size(), 7u);  // six pictures and a sheet
    EXPECT_EQ(lines_of(run.out), 14u);     // also six id pictures and the index
    for (const json& file : index["files"]) {
        const render::Image image =
            render::read_png(folder / "out/" + file["file"].get<std::string>());
        if (file.contains("sheet")) continue;
        EXPECT_EQ(image.width, 320);
        EXPECT_EQ(image.height, 240);
        if (file["level"] == 5) {
            for (std::size_t b = 0; b < 2; ++b)
                EXPECT_EQ(file["bodies"][b]["volumes"], stats[b]["levels"][5]["nodes"]);
        } else if (file["level"] == "leaves") {
            EXPECT_EQ(file["bodies"][0]["volumes"], stats[0]["triangles"]);
        }
        // Every id in the picture belongs to a node of a body.
        const render::IdImage ids =
            render::unpack_ids(render::read_png(folder / "out/" + file["ids"].get<std::string>()));
        const std::set<std::uint32_t> met(ids.ids.begin(), ids.ids.end());
        EXPECT_EQ(*met.begin(), 0u);
        EXPECT_GT(met.size(), 8u);
        EXPECT_LT(*met.rbegin(), 1 + stats[0]["nodes"].get<std::uint32_t>() +
                                     stats[1]["nodes"].get<std::uint32_t>());
    }
    EXPECT_TRUE(fs::exists(folder / "out/knots-l1_scb_level-05_size-320x240_frame-0000.png"));
    EXPECT_TRUE(
        fs::exists(folder / "out/knots-l1_ball_level-leaves_size-320x240_frame-0000_ids.png"));
}

/// In the panel, without ids; not where the volumes have a detail, or show the mesh already.
TEST(RenderLevels, APictureHasASmallViewOfTheMeshes) {
    const TemporaryFolder folder;
    const auto gray_in_panel = [&](const std::string& options) {
        const std::string file = folder / "level.png";
        const ProgramRun run = run_scb("render levels " SCB_SOURCE_DIR
                                       "/scenes/samples/bracket.ply --levels 4 --samples 1 " +
                                       options + " -o " + file);
        EXPECT_EQ(run.status, 0) << run.err;
        const render::Image image = render::read_png(file);
        int gray = 0;
        for (int y = image.height * 2 / 3; y < image.height; ++y)
            for (int x = image.width * 3 / 4; x < image.width; ++x) {
                const render::Rgba8 color = render::pixel(image, x, y);
                const auto [least, most] = std::minmax({color.r, color.g, color.b});
                gray += most - least < 16 && most > 120 && most < 215;
            }
        return gray;
    };
    EXPECT_GT(gray_in_panel(""), 2000);
    EXPECT_LT(gray_in_panel("--mesh"), 1200);
}

TEST(RenderLevels, AClippingPlaneLeavesOneSide) {
    const TemporaryFolder folder;
    const auto ids_of = [&](const std::string& options) {
        const std::string out = folder / "out";
        fs::remove_all(out);
        const ProgramRun run = run_scb("render levels cone --levels 6 --size 320x240 --samples 1 " +
                                       options + " --ids --json -o " + out);
        EXPECT_EQ(run.status, 0) << run.err;
        const json index = json::parse(run.out);
        write_text(folder / "camera.json", index["camera"].dump());
        return render::unpack_ids(
            render::read_png(out + "/" + index["files"][0]["ids"].get<std::string>()));
    };
    const auto covered = [](const render::IdImage& ids) {
        return static_cast<int>(
            std::count_if(ids.ids.begin(), ids.ids.end(), [](auto id) { return id != 0; }));
    };
    const render::IdImage whole = ids_of(""), cut = ids_of("--clip 0,0,1,0");
    EXPECT_LT(covered(cut), 0.8 * covered(whole));
    EXPECT_GT(covered(cut), 0.2 * covered(whole));
    // The view is the same, and what is left covers what it covered.
    for (std::size_t i = 0; i < cut.ids.size(); ++i)
        ASSERT_TRUE(cut.ids[i] == 0 || whole.ids[i] != 0);
    EXPECT_EQ(ids_of("--camera " + (folder / "camera.json")), cut);
    EXPECT_EQ(ids_of("--clip 0,0,1e-300,0"), cut);
    EXPECT_EQ(ids_of("--clip 0,0,2,70"), whole);
    EXPECT_EQ(ids_of("--clip 0,0,1e-300,1e70"), whole);
    EXPECT_EQ(covered(ids_of("--clip 0,0,1e-300,-1e70")), 0);
}

TEST(RenderLevels, TheCameraOfAnIndexGivesTheSamePictureAgain) {
    const TemporaryFolder folder;
    const std::string common = " --levels 6 --size 320x240 --samples 1 --ids -o ";
    ASSERT_EQ(run_scb("render levels cone" + common + (folder / "a")).status, 0);
    const json index = json::parse(file_text(folder / "a/index.json"));
    write_text(folder / "camera.json", index["camera"].dump());
    ASSERT_EQ(
        run_scb("render levels cone --camera " + (folder / "camera.json") + common + (folder / "b"))
            .status,
        0);
    const json again = json::parse(file_text(folder / "b/index.json"));
    const auto ids_in = [&](const std::string& run, const json& of) {
        return png_without_texts(
            file_text(folder / run + "/" + of["files"][0]["ids"].get<std::string>()));
    };
    EXPECT_EQ(ids_in("a", index), ids_in("b", again));
    // Another camera makes another name, even from a file of the same name.
    const std::string name = again["files"][0]["file"];
    EXPECT_TRUE(name.starts_with("cone_scb_level-06_camera-camera-")) << name;
    write_text(folder / "camera.json", R"({"azimuth": 40})");
    ASSERT_EQ(
        run_scb("render levels cone --camera " + (folder / "camera.json") + common + (folder / "b"))
            .status,
        0);
    EXPECT_NE(json::parse(file_text(folder / "b/index.json"))["files"][0]["file"], name);
}

TEST(RenderLevels, PicturesDoNotDependOnJobsOrOnOtherPicturesOfTheRun) {
    const TemporaryFolder folder;
    ASSERT_EQ(
        run_scb(
            "render levels cone --levels 2,6 --camera orbit:20,20,6 --size 320x240 --jobs 1 -o " +
            (folder / "a"))
            .status,
        0);
    ASSERT_EQ(
        run_scb(
            "render levels cone --levels 6,2 --camera orbit:20,20,6 --size 320x240 --jobs 7 -o " +
            (folder / "b"))
            .status,
        0);
    for (const char* name : {"cone_scb_level-02_camera-orbit-20-20-6_size-320x240_frame-0000.png",
                             "cone_scb_level-06_camera-orbit-20-20-6_size-320x240_frame-0000.png"})
        EXPECT_EQ(png_without_texts(file_text(folder / (std::string("a/") + name))),
                  png_without_texts(file_text(folder / (std::string("b/") + name))))
            << name;
}

TEST(RenderLevels, ARunThatFailsLeavesNoIndexOfWhatItReplaced) {
    const TemporaryFolder folder;
    const std::string arguments =
        "render levels cone --levels 3 --size 320x240 -o " + (folder / "out");
    ASSERT_EQ(run_scb(arguments).status, 0);
    const std::string index = file_text(folder / "out/index.json");
    // Another picture replaces none.
    EXPECT_EQ(run_scb_process(arguments + " --background dark", "ulimit -f 8;").status, 3);
    EXPECT_EQ(file_text(folder / "out/index.json"), index);
    EXPECT_EQ(run_scb_process(arguments, "ulimit -f 8;").status, 3);
    EXPECT_FALSE(fs::exists(folder / "out/index.json"));
}

TEST(RenderLevels, ThousandsOfEqualTrianglesAreDrawnOnce) {
    const TemporaryFolder folder;
    std::string mesh = "OFF\n3 20000 0\n0 0 0\n1 0 0\n0 1 0\n";
    for (int i = 0; i < 20000; ++i) mesh += "3 0 1 2\n";
    write_text(folder / "same.off", mesh);
    const ProgramRun run = run_scb("render levels " + (folder / "same.off") +
                                   " --levels leaves --size 320x240 -o " + (folder / "out"));
    EXPECT_EQ(run.status, 0) << run.err;
    const json index = json::parse(file_text(folder / "out/index.json"));
    EXPECT_EQ(index["files"][0]["bodies"][0]["volumes"], 20000);
}

}  // namespace
}  // namespace scb::app
