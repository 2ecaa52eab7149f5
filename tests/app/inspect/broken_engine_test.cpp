#include <gtest/gtest.h>

#include <sstream>

#include "tests/app/program.h"
#include "tests/recordings/small_engine.h"
#include "tests/temporary_folder.h"

namespace scb::app {
namespace {

const std::string source_folder = SCB_SOURCE_DIR;

class BrokenEngine : public testing::TestWithParam<int> {};

/// What `scb inspect` says of the small engine with this error.
ProgramRun inspected(int bug) {
    const TemporaryFolder folder;
    const std::string name = std::string(bug_names[bug]) + ".scbrec";
    record_small_engine(static_cast<Bug>(bug), folder / name);
    ProgramRun run = run_scb("--quiet inspect " + folder / name);
    EXPECT_EQ(run.err, "");
    if (run.out.starts_with(folder / name)) run.out.replace(0, (folder / name).size(), name);
    return run;
}

TEST_P(BrokenEngine, IsNamedToTheNodeFrameAndTest) {
    const std::string name = bug_names[GetParam()];
    const ProgramRun run = inspected(GetParam());
    EXPECT_EQ(run.status, name == "none" ? 0 : 1);
    EXPECT_EQ(run.out, file_text(source_folder + "/tests/recordings/broken/" + name + ".txt"));
}

/// The lines that the manual shows of it are there, in that order.
TEST_P(BrokenEngine, IsAsTheManualShows) {
    const std::string name = bug_names[GetParam()];
    if (name == "none") return;
    std::istringstream manual(file_text(source_folder + "/scenes/recordings/broken.md"));
    std::string line;
    while (std::getline(manual, line) && line.find("`" + name + "`") == std::string::npos) {
    }
    while (std::getline(manual, line) && line != "```text") ASSERT_FALSE(line.starts_with("## "));
    const std::string out = inspected(GetParam()).out;
    std::size_t at = 0, lines = 0;
    for (; std::getline(manual, line) && line != "```"; ++lines) {
        at = out.find(line + "\n", at);
        ASSERT_NE(at, std::string::npos) << line;
    }
    EXPECT_GT(lines, 0u);
}

INSTANTIATE_TEST_SUITE_P(All, BrokenEngine, testing::Range(0, bug_count), [](const auto& param) {
    std::string name = bug_names[param.param];
    std::erase(name, '-');
    return name;
});

}  // namespace
}  // namespace scb::app
