#include <gtest/gtest.h>

#include "tests/app/program.h"
#include "tests/recordings/distance_engine.h"
#include "tests/temporary_folder.h"

namespace scb::app {
namespace {

/// Runs a command on the recording of a healthy engine of distances.
ProgramRun run_on_distances(const std::string& command) {
    const TemporaryFolder folder;
    record_distance_engine(DistanceBug::none, folder / "q.scbrec");
    return run_scb("--quiet " + command, {.folder = folder.path.string(), .environment = {}});
}

TEST(RecordedDistances, AreRefusedByCommandsForOverlap) {
    for (const char* command :
         {"collide q.scbrec --query nearest --frames 0", "diff q.scbrec q.scbrec --query nearest",
          "explain q.scbrec --query nearest --pair 0,0",
          "view q.scbrec --query nearest -o page.html", "render pairs q.scbrec --query near -o out",
          "render rejections q.scbrec --query near -o out"}) {
        const ProgramRun run = run_on_distances(command);
        EXPECT_EQ(run.status, 2) << command;
        EXPECT_NE(run.err.find("q.scbrec: these queries are of distances"), std::string::npos)
            << command << run.err;
    }
}

TEST(RecordedDistances, AreShownTestByTest) {
    const ProgramRun trace = run_on_distances("trace q.scbrec --query nearest --frames 0 --events");
    EXPECT_EQ(trace.status, 0) << trace.err;
    EXPECT_NE(trace.out.find("left out by its bound"), std::string::npos);
    const ProgramRun picture =
        run_on_distances("render traversal q.scbrec --query nearest --frames 0 -o out");
    EXPECT_EQ(picture.status, 0) << picture.err;
}

TEST(RecordedDistances, AreOfOneKind) {
    const ProgramRun run = run_on_distances("trace q.scbrec --query near --events --frames 3");
    EXPECT_EQ(run.status, 0) << run.err;
    const ProgramRun measured = run_on_distances("distance q.scbrec --frames 2 --json");
    EXPECT_EQ(measured.status, 0) << measured.err;
    EXPECT_NE(measured.out.find("1.2903282"), std::string::npos) << measured.out;
}

}  // namespace
}  // namespace scb::app
