#include "golden/run/command_process.h"

#include <chrono>
#include <cstdint>

#include "core/platform/input_files.h"
#include "golden/run/run_case.h"

namespace scb::golden {

RunningGroup::RunningGroup(const GoldenWork* work, pid_t group) : work_(work), group_(group) {
    if (work_ != nullptr) work_->has_started(group_);
}

RunningGroup::~RunningGroup() {
    if (work_ != nullptr) work_->has_ended(group_);
}

void note_inputs_of(const UnnamedFile& inputs) {
    const std::vector<std::uint8_t> noted = inputs.bytes();
    note_inputs({reinterpret_cast<const char*>(noted.data()), noted.size()});
}

CommandEnd run_process(const GoldenRunSettings& settings, const std::vector<std::string>& program) {
    // The process waits until `work` knows of it. Otherwise, if this program is killed meanwhile,
    // the process would never be ended.
    std::vector<std::string> words = {"/bin/sh", "-c", "read -r _ && exec \"$@\"", "scb"};
    words.insert(words.end(), program.begin(), program.end());
    const UnnamedFile inputs;
    ChildProcess child(words, inputs, std::chrono::seconds(1), settings.folder);
    const RunningGroup running(settings.work, child.id());
    constexpr std::uint8_t go = '\n';
    child.write({&go, 1});
    CommandEnd result;
    result.end = child.wait(settings.patience, settings.stopped);
    result.stopped = !result.end && settings.stopped();
    result.printed = child.printed();
    result.last_line = child.last_line();
    note_inputs_of(inputs);
    return result;
}

}  // namespace scb::golden
