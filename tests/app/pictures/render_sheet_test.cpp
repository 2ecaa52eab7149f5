#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "render/draw/image_operations.h"
#include "render/figures/frame_sheet.h"
#include "render/files/image_file.h"
#include "render/overlay/figure_layout.h"
#include "tests/app/program.h"
#include "tests/png_chunks.h"

namespace scb::app {
namespace {

using nlohmann::json;

struct RenderSheet : testing::Test {
    TemporaryFolder folder;
    std::string out = folder / "out";

    json files_of(const std::string& arguments) {
        const ProgramRun run =
            run_scb("render " + arguments + " --sheet --size 640x480 --samples 1 -o " + out);
        EXPECT_EQ(run.status, 0) << arguments << run.err;
        EXPECT_NE(run.out.find("_sheet_"), std::string::npos) << run.out;
        return json::parse(file_text(out + "/index.json"))["files"];
    }
    render::Image picture(const json& file) const {
        return render::read_png(out + "/" + file["file"].get<std::string>());
    }

    /// Every one of the first `count` pictures has its cell, in their order, and no two look alike.
    void check(const json& files, std::size_t count) const {
        EXPECT_EQ(files.back()["sheet"], true);
        EXPECT_EQ(files.back().size(), 2u);
        const render::Image sheet = picture(files.back());
        const render::PixelRect view = render::figure_layout(640, 480).view;
        const render::FrameSheetLayout layout = *render::frame_sheet_layout(count, view);
        EXPECT_EQ(sheet.width, layout.width);
        EXPECT_LE(sheet.height, layout.height);
        const int first_y = sheet.height - layout.bands * layout.cell_height();
        ASSERT_GT(first_y, 3 * layout.unit);
        std::set<std::string> looks;
        for (std::size_t i = 0; i < count; ++i) {
            const int column = static_cast<int>(i) % layout.columns,
                      band = static_cast<int>(i) / layout.columns;
            const render::PixelRect cell = {layout.x(column),
                                            first_y + band * layout.cell_height() + layout.view_y(),
                                            layout.view_width, layout.view_height};
            const render::Image shown = render::shrunk(sheet, cell, cell.width, cell.height);
            // It is drawn anew in its size, so it is most like its own picture.
            const auto unlike = [&](std::size_t other) {
                const render::Image small =
                    render::shrunk(picture(files[other]), view, cell.width, cell.height);
                long sum = 0;
                for (std::size_t k = 0; k < small.rgba.size(); ++k)
                    sum += std::abs(small.rgba[k] - shown.rgba[k]);
                return sum;
            };
            const long own = unlike(i);
            EXPECT_LT(own, 12 * static_cast<long>(shown.rgba.size())) << i;
            for (std::size_t other = 0; other < count; ++other)
                EXPECT_LE(own, unlike(other)) << i << " " << other;
            EXPECT_TRUE(looks.emplace(shown.rgba.begin(), shown.rgba.end()).second) << i;
        }
    }
};

TEST_F(RenderSheet, HasACellForEveryPicture) {
    json files = files_of("pairs spheres-l1 --frames 20:80:10");
    ASSERT_EQ(files.size(), 8u);
    check(files, 7);
    files = files_of("pairs spheres-l1 --frames 100 --heat volumes --background dark");
    ASSERT_EQ(files.size(), 2u);
    check(files, 1);
    EXPECT_EQ(render::pixel(picture(files[1]), 0, 0), render::dark_theme.background);
    // The plot of all frames is no cell.
    files = files_of("rejections spheres-l1 --frames 50,100,150 --by share");
    ASSERT_EQ(files.size(), 5u);
    check(files, 3);
}

TEST_F(RenderSheet, HasACellForEveryStep) {
    const json files = files_of("rejections spheres-l1 --frames 0,20,40 --steps 3000");
    // 1, 7,655 and 10,779 tests.
    const std::size_t count = 1 + 3 + 4;
    ASSERT_EQ(files.size(), count + 2);
    check(files, count);
}

TEST_F(RenderSheet, IsTheSameFromATrace) {
    const std::string scene = "spheres-l1 --volume obb --frames 50,100",
                      trace = folder / "t.scbrec";
    ASSERT_EQ(run_scb("trace " + scene + " -o " + trace).status, 0);
    for (const std::string command :
         {"pairs ", "pairs --heat triangles ", "rejections --steps 5000 "}) {
        const json files = files_of(command + scene);
        ASSERT_FALSE(files.empty()) << command;
        const std::string name = files.back()["file"],
                          picture = png_without_texts(file_text(out + "/" + name));
        const json again = files_of(command + trace + " --frames all");
        ASSERT_FALSE(again.empty()) << command;
        EXPECT_EQ(again.back()["file"], name);
        EXPECT_EQ(png_without_texts(file_text(out + "/" + name)), picture) << command;
    }
}

TEST_F(RenderSheet, OfAnInterruptedRunHasTheFramesThatWereDrawn) {
    const std::string scene = folder / "endless.json";
    write_text(scene, endless_scene);
    const ProgramRun run = run_scb_interrupted(
        "render pairs " + scene + " --frames 0:2799 --sheet --size 320x240 --samples 1 -o " + out,
        [&](pid_t) { return std::filesystem::exists(out) && files_in(out) > 2; });
    ASSERT_EQ(run.status, 130) << run.err;
    const json files = json::parse(file_text(out + "/index.json"))["files"];
    ASSERT_FALSE(files.empty());
    EXPECT_EQ(files.back()["sheet"], true);
    const render::Image sheet = picture(files.back());
    const render::FrameSheetLayout layout =
        *render::frame_sheet_layout(2800, render::figure_layout(320, 240).view);
    EXPECT_EQ(sheet.width, layout.width);
    EXPECT_LT(sheet.height, layout.height);
}

TEST_F(RenderSheet, IsRefusedBeforeDrawingWhereThereIsNoRoom) {
    const std::string scene = folder / "endless.json";
    write_text(scene, endless_scene);
    std::filesystem::create_directory(out);
    write_text(out + "/index.json", "earlier");
    for (const std::string& arguments :
         {"pairs " + scene + " --frames 0:9999",
          std::string("rejections spheres-l1 --frames 100 --steps 1")}) {
        const ProgramRun run = run_scb("render " + arguments + " --sheet -o " + out);
        EXPECT_EQ(run.status, 2) << run.err;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_NE(run.err.find("--sheet: a sheet has room for"), std::string::npos) << run.err;
        EXPECT_EQ(file_text(out + "/index.json"), "earlier") << "what was there stays";
        EXPECT_EQ(files_in(out), 1u);
    }
    EXPECT_EQ(run_scb("render traversal spheres-l1 --sheet -o " + out).status, 2);
}

}  // namespace
}  // namespace scb::app
