#include "app/cli/console.h"

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

const char* const mesh_text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n";

// GitHub Actions obeys a line that begins with two colons behind blanks.
TEST(Console, PrintsNoNameAsACommandOfGitHubActions) {
    const TemporaryFolder folder;
    for (const std::string name : {"::error::x", " \t::error::x", "\u00a0::error::x",
                                   "a\n::error::x", "a\r::error::x", "a\n \n::error::x"}) {
        folder.write(name + ".obj", mesh_text);
        const std::string words = "'" + name + ".obj'";
        for (const std::string& command :
             {"stats " + words, "stats --csv " + words, "stats --json " + words,
              "collide " + words + " " + words, "inspect " + words + " " + words,
              "trace " + words + " " + words + " --events", "collide " + words,
              "render levels " + words + " --levels 0 --size 320x240 -o '" + name + "'",
              "export " + words + " --levels 0 -o '" + name + ".ply'", "stats none" + words}) {
            const ProgramRun run = run_scb(command, {folder.path, {}});
            for (const std::string& text : {run.out, run.err})
                for (std::size_t at = text.find("::"); at != text.npos;
                     at = text.find("::", at + 2)) {
                    const std::size_t end = text.find_last_of("\r\n", at),
                                      line = end == text.npos ? 0 : end + 1;
                    const std::string before = text.substr(line, at - line);
                    EXPECT_NE(before.find_first_not_of(" \t\u00a0"), before.npos) << command << "\n"
                                                                                  << text;
                }
        }
    }
    // A path stays what it is.
    const ProgramRun run =
        run_scb("render levels cone --levels 2 --size 320x240 -o ::out", {folder.path, {}});
    const std::vector<std::string> files = lines(run.out);
    ASSERT_EQ(files.size(), 2u) << run.out << run.err;
    for (const std::string& file : files) {
        EXPECT_TRUE(file.starts_with("./::out/")) << file;
        EXPECT_TRUE(fs::exists(folder.path / file)) << file;
    }
}

#ifndef SCB_SANITIZED
TEST(Console, NamesTheFileWhereResourcesRunOut) {
    const TemporaryFolder folder;
    std::string numbers = "0.5";
    for (int i = 0; i < 24; ++i) numbers += "," + numbers;
    const std::string file = folder.write(
        "large.jsonl", "{\"mesh\":0,\"coordinates\":[" + numbers + "],\"indices\":[]}");
    const ProgramRun run =
        run_scb_process("convert " + file + " -o " + (folder / "x.scbrec"), "ulimit -v 400000;");
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_EQ(run.err, "scb: error: out of memory, and the file that was read last is " + file +
                           "; use a smaller mesh or picture, fewer levels, or --max-pairs.\n");
    const ProgramRun full = run_scb_process("trace cone --frames 80 -o /dev/full");
    EXPECT_EQ(full.status, 3);
    EXPECT_NE(full.err.find("/dev/full"), std::string::npos) << full.err;
}
#endif

}  // namespace
}  // namespace scb::app
