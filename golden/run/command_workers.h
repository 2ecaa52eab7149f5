#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "golden/run/command_process.h"

namespace scb::golden {

class CommandWorker;

/// Processes of this program that run its commands one after the other, so that the program, its
/// OpenGL context and its shaders are loaded once and not for each command. They end with this
/// object.
class CommandWorkers {
  public:
    CommandWorkers();
    ~CommandWorkers();
    CommandWorkers(const CommandWorkers&) = delete;
    CommandWorkers& operator=(const CommandWorkers&) = delete;

    /// Runs the command with the same results as in a process of its own. Any thread may call this;
    /// commands that run at the same time have different workers. A worker ends with a command that
    /// crashes, takes too long or is stopped. Throws OutputError.
    CommandEnd run(const GoldenRunSettings& settings, const std::vector<std::string>& words);

  private:
    std::unique_ptr<CommandWorker> take();

    std::mutex mutex_;
    std::vector<std::unique_ptr<CommandWorker>> idle_;
};

}  // namespace scb::golden
