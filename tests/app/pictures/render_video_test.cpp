#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "core/platform/child_process.h"
#include "render/files/image_file.h"
#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

/// What a command of the shell prints.
std::string said_by(const std::string& command) {
    const TemporaryFolder folder;
    EXPECT_EQ(std::system((command + " >" + (folder / "out") + " </dev/null").c_str()), 0)
        << command;
    return file_text(folder / "out");
}

struct RenderVideo : testing::Test {
    TemporaryFolder folder;
    std::string out = folder / "out", file = out + "/v.mp4";

    void SetUp() override {
        if (!is_on_path("ffmpeg") || !is_on_path("ffprobe"))
            GTEST_SKIP() << "the package ffmpeg is not installed";
    }
    json index_of(const std::string& arguments) {
        const ProgramRun run = run_scb("render " + arguments + " --video " + file + " -o " + out);
        EXPECT_EQ(run.status, 0) << arguments << run.err;
        EXPECT_NE(run.out.find("\n" + file + "\n"), std::string::npos) << run.out;
        return json::parse(file_text(out + "/index.json"));
    }
    json probed() const {
        return json::parse(
            said_by("ffprobe -v error -count_frames -show_streams -of json " + file))["streams"][0];
    }
};

TEST_F(RenderVideo, HasEveryPictureOfTheSequence) {
    const std::string small = " --size 320x240 --samples 1";
    for (const auto& [arguments, frames] :
         {std::pair{"pairs spheres-l1 --frames 90:100", 11},
          {"pairs spheres-l1 --frames 90:92 --heat volumes --fps 3", 3},
          {"rejections spheres-l1 --frames 90,100 --fps 3", 2},
          {"rejections spheres-l1 --frames 100 --steps 4000 --fps 3", 5}}) {
        const json index = index_of(arguments + small), stream = probed();
        const bool told = std::string(arguments).find("--fps") != std::string::npos;
        EXPECT_EQ(stream["nb_read_frames"], std::to_string(frames)) << arguments;
        EXPECT_EQ(stream["r_frame_rate"], told ? "3/1" : "25/1") << arguments;
        EXPECT_EQ(stream["width"], 320);
        EXPECT_EQ(stream["height"], 240);
        EXPECT_EQ(index["video"], (json{{"fps", told ? 3 : 25}, {"frames", frames}})) << arguments;
    }
    index_of("traversal spheres-l1 --frames 100 --size 641x481");
    const json stream = probed();
    EXPECT_EQ(stream["nb_read_frames"], "1");
    EXPECT_EQ(stream["width"], 642);
    EXPECT_EQ(stream["height"], 482);
    for (const char* key : {"color_space", "color_primaries", "color_transfer"})
        EXPECT_EQ(stream[key], "bt709") << key;
    EXPECT_EQ(stream["color_range"], "tv");
    EXPECT_EQ(stream["pix_fmt"], "yuv420p");
}

TEST_F(RenderVideo, ShowsThePicturesInTheirColors) {
    const json index = index_of("pairs spheres-l1 --frames 0,250 --background dark --samples 1");
    said_by(
        "ffmpeg -v error -i " + file +
        " -vf "
        "scale=in_color_matrix=bt709:in_range=tv:out_range=pc:flags=accurate_rnd+full_chroma_int "
        "-vsync 0 " +
        (folder / "%d.png"));
    for (std::size_t i = 0; i < 2; ++i) {
        const render::Image drawn =
            render::read_png(out + "/" + index["files"][i]["file"].get<std::string>());
        const render::Image shown = render::read_png(folder / (std::to_string(i + 1) + ".png"));
        ASSERT_EQ(shown.rgba.size(), drawn.rgba.size());
        // Where the picture is flat; edges are coded with fewer colors. The mean of each color.
        constexpr int reach = 4;
        std::map<std::array<int, 3>, std::array<double, 4>> sums;
        for (int y = reach; y < drawn.height - reach; ++y)
            for (int x = reach; x < drawn.width - reach; ++x) {
                const render::Rgba8 color = render::pixel(drawn, x, y),
                                    seen = render::pixel(shown, x, y);
                bool flat = true;
                for (int j = -reach; j <= reach && flat; ++j)
                    for (int k = -reach; k <= reach && flat; ++k)
                        flat = render::pixel(drawn, x + k, y + j) == color;
                if (!flat) continue;
                std::array<double, 4>& sum = sums[{color.r, color.g, color.b}];
                for (const auto& [channel, value] :
                     {std::pair{0, seen.r}, {1, seen.g}, {2, seen.b}, {3, std::uint8_t{1}}})
                    sum[static_cast<std::size_t>(channel)] += value;
            }
        std::erase_if(sums, [](const auto& sum) { return sum.second[3] < 20; });
        EXPECT_GE(sums.size(), 3u);
        for (const auto& [color, sum] : sums)
            for (std::size_t channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(sum[channel] / sum[3], color[channel], 3);
    }
}

TEST_F(RenderVideo, IsTheSameBytesTwice) {
    const std::string arguments = "rejections spheres-l1 --frames 90:110 --size 320x240";
    index_of(arguments);
    const std::string bytes = file_text(file);
    index_of(arguments);
    EXPECT_EQ(file_text(file), bytes);
}

// The parent of the program may ignore SIGCHLD, and children inherit that.
TEST_F(RenderVideo, NeedsNoSignalOfItsChildren) {
    const ProgramRun run = run_scb_process(
        "render pairs spheres-l1 --frames 0:3 --size 320x240 --video " + file + " -o " + out,
        "timeout 60 env --ignore-signal=CHLD");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(probed()["nb_read_frames"], "4");
}

TEST_F(RenderVideo, OfAnInterruptedRunHasTheFramesThatWereDrawn) {
    const std::string scene = folder / "endless.json";
    write_text(scene, endless_scene);
    const ProgramRun run = run_scb_interrupted(
        "render pairs " + scene + " --frames 0:999 --size 320x240 --samples 1 --video " + file +
            " -o " + out,
        [&](pid_t) { return std::filesystem::exists(out) && files_in(out) > 2; });
    ASSERT_EQ(run.status, 130) << run.err;
    const json index = json::parse(file_text(out + "/index.json"));
    EXPECT_GT(index["files"].size(), 0u);
    EXPECT_LT(index["files"].size(), 1000u);
    EXPECT_EQ(probed()["nb_read_frames"], std::to_string(index["files"].size()));
}

struct RenderVideoWithout : testing::Test {
    TemporaryFolder folder;
    std::string out = folder / "out";

    void refused(const std::string& arguments, int status, const std::string& part,
                 const std::string& path = std::getenv("PATH")) {
        const ProgramRun run =
            run_scb("render " + arguments + " -o " + out, {"", {"PATH=" + path}});
        EXPECT_EQ(run.status, status) << arguments << run.err;
        EXPECT_EQ(run.out, "") << arguments;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_NE(run.err.find(part), std::string::npos) << arguments << run.err;
    }
};

TEST_F(RenderVideoWithout, ReasonIsRefusedBeforeAnyWork) {
    const std::string file = folder / "v.mp4", fake = folder / "ffmpeg";
    // A fake, so that the test does not depend on the machine's ffmpeg.
    write_text(fake, "#!/bin/sh\nexit 1\n");
    ::chmod(fake.c_str(), 0755);
    const std::string with = folder.path.string();
    for (const std::string command : {"pairs", "rejections", "traversal"}) {
        const std::string start = command + " spheres-l1 --video ";
        refused(start + file, 3, "install the package ffmpeg, or give a file that ends in .webp",
                "");
        refused(start + (folder / "v.avi"), 2, "give a file that ends in .mp4 or .webp", with);
        refused(start + file + " --fps 0", 2, "--fps 0: give 1 to 120", with);
        refused(start + file + " --fps 121", 2, "--fps 121: give 1 to 120", with);
        refused(start + (folder / "none/v.mp4"), 3, "create it first", with);
        refused(command + " spheres-l1 --fps 25", 2, "give --video FILE.mp4 too", with);
    }
    write_text(file, "OFF\n");
    refused("pairs " + file + " --video " + file, 2, file, with);
    refused("pairs spheres-l1 --frames 999 --video " + out + "/v.mp4", 2, "frames 0 to 499", with);
    EXPECT_EQ(run_scb("render levels spheres-l1 --video " + file).status, 2);
    EXPECT_FALSE(std::filesystem::exists(out));
    EXPECT_EQ(file_text(file), "OFF\n");
}

TEST_F(RenderVideoWithout, AWorkingProgramIsStatus3AndLeavesNoVideo) {
    const std::string fake = folder / "ffmpeg";
    const std::string drawn =
        "pairs spheres-l1 --frames 0:9 --size 320x240 --samples 1 --video " + out + "/v.mp4";
    for (const auto& [script, part] : {std::pair{"echo \"Unknown encoder 'libx264'\" >&2; exit 1",
                                                 "\"Unknown encoder 'libx264'\""},
                                       {"exit 0", "ended without a whole video"},
                                       {"cat >/dev/null", "ended without a whole video"}}) {
        write_text(fake, std::string("#!/bin/sh\n") + script + "\n");
        ::chmod(fake.c_str(), 0755);
        refused(drawn, 3, part, folder.path.string() + ":" + std::getenv("PATH"));
        EXPECT_FALSE(std::filesystem::exists(out + "/v.mp4")) << script;
        EXPECT_FALSE(std::filesystem::exists(out + "/index.json")) << script;
    }
}

// It takes nothing, so the program waits; the second interrupt does not.
TEST_F(RenderVideoWithout, AWorkingProgramCanBeInterrupted) {
    const std::string fake = folder / "ffmpeg";
    write_text(fake, "#!/bin/sh\nexec sleep 20\n");
    ::chmod(fake.c_str(), 0755);
    const ProgramRun run = run_scb_process(
        "render pairs spheres-l1 --size 320x240 --samples 1 --frames 0:499 --video " + out +
            "/v.mp4 -o " + out,
        "PATH=" + folder.path.string() +
            ":$PATH timeout --foreground --preserve-status -s INT 4 "
            "timeout --foreground --preserve-status -s INT 2");
    EXPECT_EQ(run.status, 130) << run.err;
    EXPECT_FALSE(std::filesystem::exists(out + "/v.mp4"));
    EXPECT_FALSE(std::filesystem::exists(out + "/index.json"));
}

}  // namespace
}  // namespace scb::app
