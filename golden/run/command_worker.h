#pragma once

#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "golden/run/command_process.h"

namespace scb::golden {

/// The word of the command line that starts this program as a worker.
inline constexpr const char* worker_command = "run-commands";

/// Runs the commands that a CommandWorker sends through the standard input, until that ends.
/// Returns an exit status. `run` gets the words of a command and returns its exit status; the
/// command reads nothing from the standard input.
int run_commands(const std::function<int(const std::vector<std::string>&)>& run);

/// A process of this program that runs commands, one at a time, in the suite's folder.
class CommandWorker {
  public:
    /// Starts the process. Throws OutputError.
    explicit CommandWorker(const GoldenRunSettings& settings);

    /// Runs a command. If the command did not return, the process has ended. Throws OutputError.
    CommandEnd run(const GoldenRunSettings& settings, const std::vector<std::string>& words);

    bool is_running() const { return child_.id() >= 0; }
    /// The thread that ran a command last.
    std::thread::id user() const { return user_; }

  private:
    UnnamedFile inputs_;
    ChildProcess child_;
    RunningGroup group_;
    std::thread::id user_;
};

}  // namespace scb::golden
