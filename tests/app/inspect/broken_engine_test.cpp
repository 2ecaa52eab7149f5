#include <gtest/gtest.h>

#include <sstream>

#include "tests/app/program.h"
#include "tests/recordings/bugs.h"
#include "tests/temporary_folder.h"

namespace scb::app {
namespace {

const std::string source_folder = SCB_SOURCE_DIR;

class BrokenEngine : public testing::TestWithParam<int> {};

/// Runs `scb inspect` on a recording of the small engine with this error.
ProgramRun inspected(int bug) {
    const TemporaryFolder folder;
    const std::string name = all_bug_names()[static_cast<std::size_t>(bug)] + ".scbrec";
    record_bug(bug, folder / name);
    ProgramRun run =
        run_scb("--quiet inspect " + name, {.folder = folder.path.string(), .environment = {}});
    EXPECT_EQ(run.err, "");
    return run;
}

TEST_P(BrokenEngine, IsNamedToTheNodeFrameAndTest) {
    const std::string name = all_bug_names()[static_cast<std::size_t>(GetParam())];
    const ProgramRun run = inspected(GetParam());
    EXPECT_EQ(run.status, name.ends_with("none") ? 0 : 1);
    EXPECT_EQ(run.out, file_text(source_folder + "/tests/recordings/broken/" + name + ".txt"));
}

// Its meshes move, and this program's hierarchies are of one mesh.
TEST(SmallEngine, IsComparedWithOwnHierarchiesOfOneFrame) {
    const TemporaryFolder folder;
    record_small_engine(Bug{}, folder / "none.scbrec");
    const ProgramRun all = run_scb("collide " + folder / "none.scbrec");
    EXPECT_EQ(all.status, 2);
    EXPECT_NE(all.err.find("name one frame with --frames"), std::string::npos) << all.err;
    for (const int frame : {1, 2, 3}) {
        const ProgramRun one = run_scb("--quiet collide --csv --frames " + std::to_string(frame) +
                                       " " + folder / "none.scbrec");
        EXPECT_EQ(one.status, 0) << one.err;
        const std::string pairs = frame == 1 ? "50" : frame == 2 ? "56" : "62";
        EXPECT_NE(one.out.find("\n" + std::to_string(frame) + "," + pairs + ","), std::string::npos)
            << one.out;
        EXPECT_NE(one.out.find("," + pairs + ",0,0\n"), std::string::npos) << one.out;
    }
    const ProgramRun explained =
        run_scb("--quiet explain --volume obb --pair 0,0 --frames 2 " + folder / "none.scbrec");
    EXPECT_EQ(explained.status, 0) << explained.err;
}

/// The lines that the manual shows of it are there, in that order.
TEST_P(BrokenEngine, IsAsTheManualShows) {
    const std::string name = all_bug_names()[static_cast<std::size_t>(GetParam())];
    if (name.ends_with("none")) return;
    std::istringstream manual(
        file_text(source_folder + "/scenes/recordings/" +
                  (GetParam() < bug_count ? "broken.md" : "broken-distances.md")));
    std::string line;
    while (std::getline(manual, line) && line.find("`" + name + "`") == std::string::npos) {
    }
    while (std::getline(manual, line) && line != "```text") ASSERT_FALSE(line.starts_with("## "));
    const std::string out = "\n" + inspected(GetParam()).out;
    std::size_t at = 0, lines = 0;
    for (; std::getline(manual, line) && line != "```"; ++lines) {
        at = out.find("\n" + line + "\n", at);
        ASSERT_NE(at, std::string::npos) << line;
        at += 1 + line.size();
    }
    EXPECT_GT(lines, 0u);
}

INSTANTIATE_TEST_SUITE_P(All, BrokenEngine, testing::Range(0, bug_count + distance_bug_count),
                         [](const auto& param) {
                             std::string name =
                                 all_bug_names()[static_cast<std::size_t>(param.param)];
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace scb::app
