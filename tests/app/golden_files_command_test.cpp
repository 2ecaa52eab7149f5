#include <sys/stat.h>

#include "tests/app/golden_command.h"

namespace scb {
namespace {

namespace fs = std::filesystem;

/// What stands in the place of a file of a suite.
class GoldenCommandFiles : public GoldenCommand {
  protected:
    /// A pipe that nobody reads or writes: whoever opens it waits.
    static void put_pipe(const fs::path& place) {
        fs::remove_all(place);
        ASSERT_EQ(::mkfifo(place.c_str(), 0600), 0) << place;
    }
    /// Ended where it waits, by two signals if one is not enough.
    ProgramRun limited(const std::string& arguments, const std::string& environment = "") {
        return golden(arguments, "env -u CI " + environment + " timeout -k 2 30");
    }
};

TEST_F(GoldenCommandFiles, APipeIsNoFileOfABaseline) {
    for (const char* file : {"levels.png", "levels.ids.png", "levels.counts.json"}) {
        put_pipe(baseline(file));
        const ProgramRun run = limited("check levels");
        EXPECT_EQ(run.status, 1) << file << run.err;
        EXPECT_NE(run.out.find("new output. These differ: " + std::string(file) +
                               " of the baseline is no regular file"),
                  std::string::npos)
            << run.out;
        EXPECT_EQ(limited("update levels").status, 0) << file;
        EXPECT_TRUE(fs::is_regular_file(baseline(file))) << file;
    }
    put_pipe(baseline("rejections.scbtrace"));
    write_text(baseline("rejections.counts.json"), "{}");
    EXPECT_EQ(limited("check rejections").status, 1);
    put_pipe(suite);
    EXPECT_EQ(limited("check").status, 2);
}

TEST_F(GoldenCommandFiles, APipeIsNoPlaceForResults) {
    const std::string pipe = folder / "summary.md";
    put_pipe(pipe);
    const ProgramRun told = limited("check collide", "GITHUB_STEP_SUMMARY=" + pipe);
    EXPECT_EQ(told.status, 3);
    EXPECT_NE(told.err.find("it is not a regular file; name one."), std::string::npos) << told.err;
    for (const char* file : {"results.json", "report.html"}) {
        fs::remove_all(report);
        fs::create_directory(report);
        put_pipe(report / file);
        const ProgramRun run = limited("check collide --report " + report.string());
        EXPECT_EQ(run.status, 3) << file;
        EXPECT_NE(run.err.find(std::string(file) + ": there is something of that name that is no"),
                  std::string::npos)
            << run.err;
        // The result is told all the same.
        EXPECT_EQ(run.out, "1 case: 1 same\n");
    }
}

}  // namespace
}  // namespace scb
