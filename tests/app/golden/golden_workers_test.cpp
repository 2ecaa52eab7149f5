#include <signal.h>

#include <algorithm>
#include <mutex>
#include <random>
#include <thread>

#include "golden/run/check_cases.h"
#include "tests/app/golden/golden_command.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using golden::Verdict;

/// The processes that this one has started and that have not ended.
std::vector<pid_t> children() {
    std::vector<pid_t> found;
    for (const fs::directory_entry& task : fs::directory_iterator("/proc/self/task")) {
        std::istringstream list(file_text(task.path() / "children"));
        for (pid_t child = 0; list >> child;) found.push_back(child);
    }
    return found;
}

/// A suite whose cases one worker runs.
class GoldenWorkers : public GoldenCommand {
  protected:
    GoldenWorkers() {
        fs::create_directory(made);
        write_text(endless, endless_scene);
        check.settings.program = SCB_PROGRAM;
        check.settings.folder = folder.path;
        check.settings.gl = "osmesa";
        check.folders = {folder.path / "baselines", made, ""};
        for (const golden::GoldenCase& golden : golden::load_suite(suite).cases)
            check.cases.push_back(golden::seen_from_here(golden, folder.path, ""));
    }

    /// Puts the case `hang`, which no test waits for, before the others.
    void add_case_that_hangs() {
        golden::GoldenCase hang;
        hang.name = "hang";
        hang.run = golden::GoldenRun::collide;
        hang.scene = hang.own_scene = {endless};
        hang.frames = "all";
        hang.ids = hang.colors = false;
        check.cases.insert(check.cases.begin(), hang);
    }

    /// All cases, by one worker after the other. Says what the case `hang` came to.
    std::string expect_that_others_are_the_same(const std::function<void()>& step = [] {}) {
        std::string message;
        const golden::CheckedCases checked = check_cases(check, [&] {
            step();
            return true;
        });
        EXPECT_EQ(checked.results.size(), check.cases.size());
        for (const golden::CaseResult& result : checked.results)
            if (result.name == "hang") {
                EXPECT_EQ(result.verdict, Verdict::could_not_run);
                message = result.message;
            } else {
                EXPECT_EQ(result.verdict, Verdict::same) << result.name << result.message;
            }
        return message;
    }

    const fs::path made = folder.path / "made";
    const std::string endless = folder / "endless.json";
    golden::GoldenCheck check;
};

TEST_F(GoldenWorkers, GiveWhatProcessesOfTheirOwnGive) {
    const auto by_workers = baselines();
    ASSERT_EQ(golden("update --all --runner env").status, 0);
    EXPECT_EQ(baselines(), by_workers);
}

TEST_F(GoldenWorkers, GiveTheSameInAnyOrder) {
    std::mt19937 random;
    for (int i = 0; i < 3; ++i) {
        expect_that_others_are_the_same();
        std::shuffle(check.cases.begin(), check.cases.end(), random);
    }
}

TEST_F(GoldenWorkers, AreOneForAllCasesOfAJob) {
    pid_t worker = 0;
    check_cases(check, [&] {
        const std::vector<pid_t> running = children();
        EXPECT_EQ(running.size(), 1u);
        if (running.size() != 1) return false;
        EXPECT_TRUE(worker == 0 || running[0] == worker);
        worker = running[0];
        return true;
    });
    check.settings.workers.reset();
    EXPECT_EQ(children(), std::vector<pid_t>());
}

TEST_F(GoldenWorkers, EndWithACommandThatHangs) {
    golden::CommandWorkers workers;
    const std::vector<std::string> hang = {"collide", endless, "--frames", "all"};
    EXPECT_EQ(workers.run(check.settings, {"--version"}).end, (ProcessEnd{false, 0}));
    golden::GoldenRunSettings impatient = check.settings;
    impatient.patience = std::chrono::seconds(1);
    const golden::CommandEnd late = workers.run(impatient, hang);
    EXPECT_EQ(late.end, std::nullopt);
    EXPECT_FALSE(late.stopped);
    EXPECT_EQ(children(), std::vector<pid_t>());
    golden::GoldenRunSettings stopped = check.settings;
    stopped.stopped = [] { return true; };
    EXPECT_TRUE(workers.run(stopped, hang).stopped);
    EXPECT_EQ(children(), std::vector<pid_t>());
    const golden::CommandEnd next = workers.run(check.settings, {"--version"});
    EXPECT_EQ(next.end, (ProcessEnd{false, 0}));
    EXPECT_NE(next.printed, "");
}

TEST_F(GoldenWorkers, GiveACommandNothingOfTheOneBefore) {
    golden::CommandWorkers workers;
    EXPECT_EQ(workers.run(check.settings, {"collide", "nowhere.json"}).last_line,
              "scb: error: nowhere.json: there is no such file; check the path.");
    const golden::CommandEnd next = workers.run(check.settings, {"scenes"});
    EXPECT_EQ(next.end, (ProcessEnd{false, 0}));
    EXPECT_EQ(next.printed, run_scb("scenes").out);
    EXPECT_EQ(next.last_line, lines(next.printed).back());  // no error
}

TEST_F(GoldenWorkers, DoNotRepeatACaseThatCrashes) {
    expect_that_others_are_the_same();
    add_case_that_hangs();
    check.settings.patience = std::chrono::seconds(5);  // a repeated case would hang
    for (const pid_t child : children()) ::kill(child, SIGABRT);
    EXPECT_EQ(expect_that_others_are_the_same(), "It was ended by signal 6.");
}

TEST_F(GoldenWorkers, EndWithACaseThatIsKilled) {
    expect_that_others_are_the_same();
    add_case_that_hangs();
    std::mutex stepping;
    int steps = 0;
    std::jthread crasher([&](const std::stop_token& end) {
        for (; !end.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(20))) {
            const std::lock_guard lock(stepping);
            for (const pid_t child : children())
                if (steps == 0) ::kill(child, SIGKILL);
        }
    });
    const std::string message = expect_that_others_are_the_same([&] {
        const std::lock_guard lock(stepping);
        ++steps;
    });
    EXPECT_EQ(message, "It was ended by signal 9.");
}

}  // namespace
}  // namespace scb::app
