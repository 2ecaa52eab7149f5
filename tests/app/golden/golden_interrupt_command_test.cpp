#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/app/golden/golden_command.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::seconds;

/// A suite that never ends by itself: all but one of its cases hang.
class GoldenCommandInterrupt : public GoldenCommand {
  protected:
    GoldenCommandInterrupt() {
        fs::create_directory(temporary);
        write_runner("case \"$*\" in *collide*) exec \"$@\";; esac\necho $$ >>" + sleepers +
                     "\nsleep 3600 &\necho $! >>" + sleepers + "\nwait\n");
    }
    void write_runner(const std::string& script) const {
        write_text(runner, "#!/bin/sh\n" + script);
        fs::permissions(runner, fs::perms::owner_all);
    }
    /// Interrupts the command once a case does not end.
    ProgramRun stopped_by(int signal, const std::string& command) {
        return run_scb_interrupted(
            "golden " + command + " --suite " + suite + " --runner " + runner,
            [&](pid_t) { return lines_of(file_text(sleepers)) > 0; }, signal,
            "env TMPDIR=" + temporary);
    }
    template <typename What>
    void expect_nothing_is_left(const What& signal) const {
        EXPECT_EQ(files_in(temporary), 0u) << signal;
        const std::string list = file_text(sleepers);
        EXPECT_NE(list, "") << signal;
        for (std::size_t at = 0; at < list.size(); at = list.find('\n', at) + 1) {
            const std::string file =
                "/proc/" + std::to_string(std::stoi(list.substr(at))) + "/stat";
            // Where nobody waits for one, it stays as a zombie.
            const auto runs = [&] {
                const std::string stat = file_text(file);
                return !stat.empty() && stat.find(") Z ") == std::string::npos;
            };
            // What ends it after a `kill -9` takes a moment.
            for (int i = 0; i < 1000 && runs(); ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            EXPECT_FALSE(runs()) << signal << file_text(file);
        }
        fs::remove(sleepers);
    }

    const std::string runner = folder / "runner", sleepers = folder / "sleepers",
                      temporary = folder / "temporary";
};

TEST_F(GoldenCommandInterrupt, EndsCasesThatHang) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const ProgramRun run = stopped_by(signal, "check --jobs 3 --report " + report.string());
        EXPECT_EQ(run.status, 128 + signal) << run.out << run.err;
        EXPECT_NE(run.out.find("incomplete. The run was interrupted: "), std::string::npos)
            << run.out;
        EXPECT_EQ(run.out.find("could not run"), std::string::npos) << run.out;
        results = nlohmann::json::parse(file_text(report / "results.json"));
        EXPECT_NE(results["incomplete"], "");
        fs::remove_all(report);
        expect_nothing_is_left(signal);
    }
}

TEST_F(GoldenCommandInterrupt, LeavesBaselinesAsTheyWere) {
    write_text(baseline("levels.counts.json"), "{}");
    const auto before = baselines();
    const ProgramRun run = stopped_by(SIGTERM, "update --all");
    EXPECT_EQ(run.status, 143) << run.err;
    EXPECT_EQ(baselines(), before);
    expect_nothing_is_left("update");
    // The same if only the trace does not end.
    write_runner("case \"$*\" in *\" trace \"*) echo $$ >>" + sleepers +
                 "; exec sleep 3600;; esac\nexec \"$@\"\n");
    write_text(baseline("rejections.counts.json"), "{}");
    EXPECT_EQ(stopped_by(SIGTERM, "update rejections").status, 143);
    EXPECT_EQ(file_text(baseline("rejections.counts.json")), "{}");
    expect_nothing_is_left("trace");
}

TEST_F(GoldenCommandInterrupt, LeavesNoTemporaryFolderHoweverItEnds) {
    const std::string environment = "env TMPDIR=" + temporary + " ";
    const auto soon_empty = [&] {
        for (const Clock::time_point end = Clock::now() + seconds(20); Clock::now() < end;)
            if (files_in(temporary) == 0) return true;
        return false;
    };
    // Its output is closed before it prints.
    run_scb_process("golden check --suite " + suite + " | true", environment);
    EXPECT_TRUE(soon_empty());
    // Once the command is killed, only removing its folder ends the cases.
    const ProgramRun run = stopped_by(SIGKILL, "check --jobs 2");
    EXPECT_EQ(run.status, 128 + SIGKILL) << run.err;
    EXPECT_TRUE(soon_empty());
    expect_nothing_is_left("killed");
    run_scb_process("golden selftest collide --suite " + suite, environment);
    EXPECT_TRUE(soon_empty());
}

}  // namespace
}  // namespace scb::app
