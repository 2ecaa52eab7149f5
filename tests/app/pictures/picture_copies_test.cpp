#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/platform/base64.h"
#include "tests/app/program.h"

namespace scb::app {
namespace {

TEST(PictureCopies, AreSvgFilesThatTheIndexNames) {
    TemporaryFolder folder;
    for (const std::string command :
         {"render traversal cone --frames 100", "render levels cone --levels 2",
          "explain cone --frames 100 --pair 3,4"}) {
        std::string before;
        for (const char* out : {"a", "b"}) {
            const ProgramRun run = run_scb(command + " --svg --size 640x480 -o " + (folder / out));
            ASSERT_EQ(run.status, 0) << run.err;
            const auto index = nlohmann::json::parse(
                file_text(std::filesystem::path(folder / out) / "index.json"));
            const std::string name = index["files"][0]["svg"];
            EXPECT_TRUE(name.ends_with(".svg"));
            const std::string svg = file_text(std::filesystem::path(folder / out) / name);
            EXPECT_EQ(svg.find("<image") != std::string::npos,
                      command.find("traversal") == std::string::npos);
            EXPECT_NE(svg.find("</text>"), std::string::npos);
            EXPECT_TRUE(svg.ends_with("</svg>\n"));
            EXPECT_TRUE(before.empty() || before == svg) << "not the same bytes";
            before = svg;
            std::filesystem::remove_all(folder / out);
        }
    }
}

TEST(PictureCopies, PlotsAreShownInTheTerminalToo) {
    TemporaryFolder folder;
    for (const std::string command : {"bench knots-l1 --frames 0 --repeat 1 --volume scb",
                                      "tune knots-l1 --frames 0 --no-time"}) {
        const ProgramRun run =
            run_scb(command + " --size 320x240 --terminal -o " + (folder / "out"),
                    {"", {"SCB_IMAGES=iterm2"}});
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.out.find("\033]1337;File=inline=1"), std::string::npos) << command;
    }
}

TEST(PictureCopies, AreShownInTheTerminal) {
    TemporaryFolder folder;
    const std::string command =
        "render levels cone --levels 2 --size 320x240 --terminal -o " + (folder / "out");
    const ProgramRun kitty = run_scb(command, {"", {"SCB_IMAGES=kitty"}}),
                     iterm = run_scb(command, {"", {"SCB_IMAGES=iterm2"}}),
                     sixel = run_scb(command, {"", {"SCB_IMAGES=sixel"}}), none = run_scb(command);
    for (const ProgramRun& run : {kitty, iterm, sixel, none}) ASSERT_EQ(run.status, 0) << run.err;
    const std::string name = nlohmann::json::parse(
        file_text(std::filesystem::path(folder / "out") / "index.json"))["files"][0]["file"];
    const std::string png = file_text(std::filesystem::path(folder / "out") / name),
                      coded =
                          base64({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});
    EXPECT_NE(iterm.out.find("\033]1337;File=inline=1;preserveAspectRatio=1:" + coded + "\a"),
              std::string::npos);
    // In parts of at most 4096 characters. The last part has the mark of the end.
    std::string joined;
    for (std::size_t at = kitty.out.find("\033_G"); at != std::string::npos;) {
        const std::size_t begin = kitty.out.find(';', at) + 1, end = kitty.out.find("\033\\", at);
        const std::string keys = kitty.out.substr(at, begin - at);
        joined += kitty.out.substr(begin, end - begin);
        EXPECT_LE(end - begin, 4096U);
        at = kitty.out.find("\033_G", end);
        EXPECT_NE(keys.find(at == std::string::npos ? "m=0" : "m=1"), std::string::npos);
    }
    EXPECT_EQ(joined, coded);
    EXPECT_NE(sixel.out.find("\033P"), std::string::npos);
    EXPECT_NE(sixel.out.find("\033\\"), std::string::npos);
    EXPECT_NE(none.err.find("SCB_IMAGES"), std::string::npos) << none.err;
    EXPECT_EQ(none.out.find('\033'), std::string::npos);
}

}  // namespace
}  // namespace scb::app
