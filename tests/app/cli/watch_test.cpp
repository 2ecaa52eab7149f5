#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/app/program.h"

namespace scb::app {
namespace {

constexpr const char* one = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* two = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n";

TEST(Watch, RunsAgainWhenAFileHasChangedUntilItIsInterrupted) {
    TemporaryFolder folder;
    const std::string mesh = folder / "m.obj", pairs = folder / "pairs.csv";
    write_text(mesh, one);
    // Each triangle meets itself, and what it has a corner in common with.
    const auto found = [&] {
        return std::filesystem::exists(pairs) ? lines_of(file_text(pairs)) : 0;
    };
    int step = 0;
    const ProgramRun run = run_scb_interrupted(
        "--watch collide " + mesh + " " + mesh + " --pairs-out " + pairs, [&](pid_t) {
            if (step == 0 && found() == 2) {
                // As an editor does: another file in its place.
                write_text(folder / "new.obj", two);
                std::filesystem::rename(folder / "new.obj", mesh);
                step = 1;
            } else if (step == 1 && found() == 5) {
                // The program reports a fault and goes on.
                write_text(mesh, "nonsense");
                std::this_thread::sleep_for(std::chrono::seconds(2));
                write_text(mesh, one);
                step = 2;
            }
            return step == 2 && found() == 2;
        });
    EXPECT_EQ(step, 2);
    EXPECT_EQ(found(), 2U);
    EXPECT_NE(run.err.find("waiting for a change of 1 file"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("m.obj"), std::string::npos) << "the fault: " << run.err;
}

TEST(Watch, WaitsForASceneWithAnErrorToBeMended) {
    TemporaryFolder folder;
    const std::string scene = folder / "s.json", pairs = folder / "pairs.csv";
    write_text(folder / "m.obj", one);
    write_text(scene, "{ nonsense");
    bool is_mended = false;
    const auto mend_later = [&](pid_t) {
        if (is_mended) return std::filesystem::exists(pairs);
        std::this_thread::sleep_for(std::chrono::seconds(2));
        write_text(
            scene,
            R"({"scb_scene": 1, "name": "s", "frames": 1, "models": [{"name": "m", "file": "m.obj"}],
            "bodies": [{"name": "A", "model": "m"}, {"name": "B", "model": "m"}]})");
        is_mended = true;
        return false;
    };
    const ProgramRun run =
        run_scb_interrupted("--watch collide " + scene + " --pairs-out " + pairs, mend_later);
    EXPECT_TRUE(std::filesystem::exists(pairs)) << run.err;
    EXPECT_NE(run.err.find("waiting for a change of 1 file"), std::string::npos) << run.err;
}

TEST(Watch, EndsWhereNoFileIsRead) {
    const ProgramRun run = run_scb_process("--watch scenes");
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.err.find("nothing is waited for"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace scb::app
