#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/golden/golden_command.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

/// What stands in the place of a file of a suite.
class GoldenCommandFiles : public GoldenCommand {
  protected:
    /// A pipe without reader or writer: a process that opens it waits.
    static void put_pipe(const fs::path& place) {
        fs::remove_all(place);
        ASSERT_EQ(::mkfifo(place.c_str(), 0600), 0) << place;
    }
    /// Ended where it waits, by two signals if one is not enough.
    ProgramRun limited(const std::string& arguments, const std::string& environment = "") {
        return golden_process(arguments, "env " + environment + " timeout -k 2 30");
    }
};

TEST_F(GoldenCommandFiles, APipeIsNoFileOfABaseline) {
    for (const char* file : {"levels.png", "levels.ids.png", "levels.counts.json"}) {
        put_pipe(baseline(file));
        const ProgramRun run = limited("check levels");
        EXPECT_EQ(run.status, 1) << file << run.err;
        EXPECT_NE(run.out.find("new output. These differ: " + std::string(file) +
                               " of the baseline is not a regular file"),
                  std::string::npos)
            << run.out;
        EXPECT_EQ(limited("update levels").status, 0) << file;
        EXPECT_TRUE(fs::is_regular_file(baseline(file))) << file;
    }
    put_pipe(baseline("rejections.trace.scbrec"));
    write_text(baseline("rejections.counts.json"), "{}");
    EXPECT_EQ(limited("check rejections").status, 1);
    put_pipe(suite);
    EXPECT_EQ(limited("check").status, 2);
}

TEST_F(GoldenCommandFiles, NeedNoLargeStack) {
#ifdef SCB_SANITIZED
    GTEST_SKIP() << "a sanitizer takes more";
#endif
    EXPECT_EQ(golden_process("check", "ulimit -s 128;").status, 0);
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
        // The result is printed all the same.
        EXPECT_EQ(run.out, "1 case: 1 same\n");
    }
}

TEST_F(GoldenCommandFiles, AClosedStandardOutputLosesTheResultButNoFile) {
    for (int repeat = 0; repeat < 3; ++repeat) {
        const ProgramRun run = golden_process("check --report " + report.string(),
                                              "sh -c 'exec \"$0\" \"$@\" <&- >&-'");
        EXPECT_EQ(run.status, 3) << run.err;
        EXPECT_NE(run.err.find("cannot write to standard output"), std::string::npos) << run.err;
        const nlohmann::json kept = nlohmann::json::parse(file_text(report / "results.json"));
        EXPECT_EQ(kept["incomplete"], "");
        EXPECT_EQ(kept["cases"].size(), 5u);
    }
}

TEST_F(GoldenCommandFiles, AFolderThatCannotBeReadIsNotTakenForAnEmptyOne) {
    if (::geteuid() != 0) GTEST_SKIP() << "needs to become another user";
    fs::permissions(folder.path, fs::perms::all);
    fs::permissions(folder / "baselines", fs::perms::none);
    const std::string nobody = "setpriv --reuid 65534 --clear-groups";
    for (const char* command : {"check", "list", "selftest"}) {
        const ProgramRun run = golden_process(command, nobody);
        EXPECT_EQ(run.status, 2) << command << run.out;
        EXPECT_NE(run.err.find("/baselines: the baselines in this folder cannot be read; "),
                  std::string::npos)
            << run.err;
    }
    EXPECT_EQ(golden_process("update --missing", nobody).status, 3);
    fs::permissions(folder / "baselines", fs::perms::owner_all);
    EXPECT_EQ(golden("check --baselines " + suite).status, 2);
    EXPECT_EQ(golden("list --baselines " + (folder / "none")).status, 0);
}

TEST_F(GoldenCommandFiles, ResultsDoNotComeAmongTheBaselines) {
    write_text(baseline("collide.counts.json"), "{}");
    const auto before = baselines();
    const std::string there = folder / "baselines", home = folder.path.string();
    fs::create_directory_symlink(there, folder / "link");
    for (const std::string& options : std::vector<std::string>{
             "--report " + there, "--report " + there + "/",
             "--report " + home + "/../" + folder.path.filename().string() + "/baselines",
             "--report " + (folder / "link"), "--report . --baselines .",
             "--report new --baselines new/", "--junit " + suite,
             "--json " + there + "/collide.counts.json"}) {
        const ProgramRun run = golden("check collide " + options, {home});
        EXPECT_EQ(run.status, 2) << options << run.err;
        EXPECT_EQ(run.out, "") << options;
    }
    EXPECT_EQ(baselines(), before);
    fs::copy_file(suite, folder / "results.json");
    EXPECT_EQ(
        run_scb("golden check --report " + home + " --suite " + (folder / "results.json")).status,
        2);
    // It is no result either, whichever suite is checked.
    const ProgramRun foreign = golden("check collide --report " + home);
    EXPECT_EQ(foreign.status, 2);
    EXPECT_NE(foreign.err.find("results.json, which holds no results"), std::string::npos)
        << foreign.err;
    fs::remove(folder / "results.json");
    EXPECT_EQ(golden("check collide --report " + home).status, 1);
}

TEST_F(GoldenCommandFiles, ResultsReplaceResultsAlone) {
    const std::string mine = folder / "mine.json", page = folder / "report/report.html";
    write_text(mine, "{\"my\": \"scene\"}");
    EXPECT_EQ(golden("check collide --json " + mine).status, 2);
    EXPECT_EQ(golden("check collide --junit " + mine).status, 2);
    EXPECT_EQ(file_text(mine), "{\"my\": \"scene\"}");
    // Recognized by their content, not by their names; run twice.
    for (int i = 0; i < 2; ++i) {
        const ProgramRun run =
            golden("check collide --junit " + (folder / "out.json") + " --json " +
                   (folder / "out.xml") + " --report " + (folder / "report"));
        EXPECT_EQ(run.status, 0) << run.err;
    }
    write_text(page, "<!DOCTYPE svg>");
    EXPECT_EQ(golden("check collide --report " + (folder / "report")).status, 2);
}

TEST_F(GoldenCommandFiles, AcceptedPicturesBehindAGapAreNamed) {
    for (const char* file : {"levels.2.png", "levels.4.png", "levels.1.png"})
        fs::copy_file(baseline("levels.png"), baseline(file));
    const ProgramRun list = golden("list"), run = golden("check levels");
    for (const std::string& said : {list.out, run.err}) {
        for (const char* file : {"/levels.1.png", "/levels.4.png"})
            EXPECT_NE(said.find(std::string(file) + " is never compared"), std::string::npos)
                << said;
        EXPECT_EQ(said.find("levels.2.png"), std::string::npos) << said;
    }
    EXPECT_EQ(run.out, "1 case: 1 same\n");
}

TEST_F(GoldenCommandFiles, OfSixteenBitsAreNotCompared) {
    // The header of a picture, whose ninth byte is the depth, and its checksum.
    std::string png = file_text(baseline("levels.png"));
    png[24] = 16;
    write_text(baseline("levels.png"), png);
    const ProgramRun run = golden("check levels");
    EXPECT_NE(run.out.find("levels: could not run. \"" + baseline("levels.png").string() +
                           "\" has 16 bits a channel"),
              std::string::npos)
        << run.out;
}

TEST_F(GoldenCommandFiles, NamesInThemForgeNoOutput) {
    nlohmann::json counts = nlohmann::json::parse(file_text(baseline("collide.counts.json")));
    for (const char* key : {"::add-mask::1", "a\n::stop-commands::x", "b\x1b[2J", "##[error]c"})
        counts[key] = 1;
    write_text(baseline("collide.counts.json"), counts.dump());
    write_text(baseline("gone\n\x1b[31m.png"), "");
    const ProgramRun run = golden("check collide", {"", {"GITHUB_ACTIONS=true"}});
    EXPECT_EQ(run.status, 1);
    for (const ProgramRun& said : {run, golden("list"), golden("update --all")}) {
        std::istringstream lines(said.out);
        for (std::string line; std::getline(lines, line);) {
            EXPECT_FALSE(line.find_first_not_of(' ') == line.find("::") &&
                         !line.starts_with("::error title=collide"))
                << line;
            EXPECT_EQ(line.find_first_of("\x1b\r"), std::string::npos) << line;
            EXPECT_TRUE(line.starts_with("::") || line.find("##[") == std::string::npos) << line;
        }
    }
    EXPECT_NE(run.out.find("    \\x3a:add-mask::1: 1 -> none\n"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace scb::app
