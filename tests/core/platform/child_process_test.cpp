#include "core/platform/child_process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>
#include "tests/core/platform/children.h"

namespace scb {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// While this exists, the system forgets children as they end.
struct IgnoredSigchld {
    IgnoredSigchld() { std::signal(SIGCHLD, SIG_IGN); }
    ~IgnoredSigchld() { std::signal(SIGCHLD, SIG_DFL); }
};

struct ChildProcessTest : testing::Test {
    UnnamedFile output;

    std::optional<ProcessEnd> end_of(const std::string& script, milliseconds most = seconds(60)) {
        return ChildProcess({"sh", "-c", script}, output, seconds(60)).wait(most);
    }
};

/// Whether it becomes true in half a minute.
bool soon(const std::function<bool()>& condition) {
    for (const Clock::time_point end = Clock::now() + seconds(30); Clock::now() < end;) {
        if (condition()) return true;
        std::this_thread::sleep_for(milliseconds(5));
    }
    return false;
}

TEST_F(ChildProcessTest, EndsWithAStatusOrByASignal) {
    for (const int status : {0, 1, 128, 137, 228, 255})
        EXPECT_EQ(end_of("exit " + std::to_string(status)), (ProcessEnd{false, status})) << status;
    for (const int signal : {SIGKILL, SIGTERM})
        EXPECT_EQ(end_of("kill -" + std::to_string(signal) + " $$"), (ProcessEnd{true, signal}));
    EXPECT_EQ(end_of("sleep 600", milliseconds(50)), std::nullopt);
    EXPECT_TRUE(no_child_is_left());
}

TEST_F(ChildProcessTest, AnswersThroughItsInput) {
    ChildProcess child({"sh", "-c", "while read -r word; do echo $word; echo $word >&0; done"},
                       output, seconds(60));
    const auto never = [] { return false; };
    std::vector<std::uint8_t> answer(4);
    for (const std::string word : {"one\n", "two\n"}) {
        child.forget_printed();
        EXPECT_TRUE(child.write({reinterpret_cast<const std::uint8_t*>(word.data()), 4}));
        EXPECT_TRUE(child.read(answer, never));
        EXPECT_EQ(std::string(answer.begin(), answer.end()), word);
        EXPECT_EQ(child.printed(), word);
    }
    EXPECT_FALSE(child.read(answer, [] { return true; }));
    child.kill();
    EXPECT_FALSE(child.read(answer, never));
}

TEST_F(ChildProcessTest, IsKilledWithItsChildrenWhereItsWaitIsStopped) {
    ChildProcess child({"sh", "-c", "sleep 600 & echo $!; wait"}, output, seconds(60));
    EXPECT_EQ(child.wait(seconds(600), [&] { return !child.printed().empty(); }), std::nullopt);
    EXPECT_TRUE(no_child_is_left());
    const pid_t its_child = std::stoi(child.printed());
    EXPECT_TRUE(soon([&] {
        // Where nobody waits for it, it stays as a zombie.
        std::ifstream status("/proc/" + std::to_string(its_child) + "/stat");
        std::string text;
        std::getline(status, text);
        return !status || text.find(") Z ") != std::string::npos;
    }));
}

TEST_F(ChildProcessTest, RunsInTheFolderThatItIsGiven) {
    ChildProcess child({"pwd"}, output, seconds(60), "/");
    EXPECT_EQ(child.wait(seconds(60)), (ProcessEnd{false, 0}));
    EXPECT_EQ(child.printed(), "/\n");
}

TEST_F(ChildProcessTest, IsWaitedForWhereHowItEndedIsForgotten) {
    const IgnoredSigchld ignored;
    const Clock::time_point start = Clock::now();
    EXPECT_EQ(end_of("exit 0"), std::nullopt);
    EXPECT_EQ(end_of("sleep 600", milliseconds(50)), std::nullopt);
    EXPECT_LT(Clock::now() - start, seconds(30));
    EXPECT_TRUE(no_child_is_left());
}

TEST_F(ChildProcessTest, ItsWordsAreKeptApart) {
    ChildProcess process({"sh", "-c", "echo one; echo odd >&2; echo two; echo"}, output,
                         seconds(60));
    EXPECT_EQ(process.wait(seconds(60)), (ProcessEnd{false, 0}));
    EXPECT_EQ(process.printed(), "one\ntwo\n\n");
    EXPECT_EQ(process.last_line(), "odd");
}

// By then the id of its group may belong to other processes. Here it belongs to a child of the
// process, which writes a line if it is not killed.
TEST_F(ChildProcessTest, IsLeftToItselfWhereItTakesLonger) {
    EXPECT_EQ(ChildProcess({"sh", "-c", "exit 3"}, output, seconds(60)).wait_or_leave(seconds(60)),
              (ProcessEnd{false, 3}));
    {
        ChildProcess child({"sh", "-c", "sleep 0.3; echo done >&3"}, output, seconds(60));
        EXPECT_EQ(child.wait_or_leave(std::chrono::milliseconds(1)), std::nullopt);
        EXPECT_EQ(child.id(), -1);
    }
    for (int i = 0; i < 1000 && output.bytes().empty(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_FALSE(output.bytes().empty()) << "it was not killed";
    // Nobody else waits for it.
    EXPECT_TRUE(soon([] { return no_child_is_left(); }));
}

TEST_F(ChildProcessTest, IsNotKilledOnceItIsForgotten) {
    const IgnoredSigchld ignored;
    ChildProcess process({"sh", "-c", "sh -c \"$0\" &",
                          "trap 'echo alive; exit' USR1; echo $$;"
                          "for i in $(seq 600); do sleep 0.1; done"},
                         output, seconds(60));
    ASSERT_TRUE(soon([&] { return no_child_is_left() && !process.last_line().empty(); }));
    const pid_t its_child = std::stoi(process.last_line());
    process.kill();
    ::kill(its_child, SIGUSR1);
    EXPECT_TRUE(soon([&] { return process.last_line() == "alive"; }));
}

}  // namespace
}  // namespace scb
