#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "core/platform/child_process.h"
#include "golden/run/work_folder.h"

namespace scb::golden {

struct GoldenRunSettings;

/// How a command ended, and what it printed.
struct CommandEnd {
    std::optional<ProcessEnd> end;  ///< nothing if it took too long or was stopped
    bool stopped = false;
    std::string printed, last_line;
};

/// A group of processes that must end with this program.
class RunningGroup {
  public:
    RunningGroup(const GoldenWork* work, pid_t group);
    ~RunningGroup();
    RunningGroup(const RunningGroup&) = delete;
    RunningGroup& operator=(const RunningGroup&) = delete;

  private:
    const GoldenWork* work_;
    pid_t group_;
};

/// Notes the files that a command has read: the text of noted_inputs.
void note_inputs_of(const UnnamedFile& inputs);

/// Runs a program in the suite's folder, in a process of its own. Throws OutputError.
CommandEnd run_process(const GoldenRunSettings& settings, const std::vector<std::string>& program);

}  // namespace scb::golden
