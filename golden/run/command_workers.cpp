#include "golden/run/command_workers.h"

#include <algorithm>
#include <csignal>
#include <thread>
#include <utility>

#include "core/base/exit_status.h"
#include "golden/run/command_worker.h"

namespace scb::golden {
namespace {

/// Whether a limit of memory or of processor time may have ended the command. A worker has less of
/// both left after each command, so a new worker repeats this one. A crash is reported.
bool may_lack_resources(const CommandEnd& command) {
    if (!command.end) return false;
    const int code = command.end->code;
    return command.end->by_signal ? code == SIGKILL || code == SIGXCPU : code == exit_environment;
}

}  // namespace

CommandWorkers::CommandWorkers() = default;
CommandWorkers::~CommandWorkers() = default;

std::unique_ptr<CommandWorker> CommandWorkers::take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return nullptr;
    // The thread's own last worker, which may have the hierarchies that the command needs.
    auto own = std::find_if(idle_.begin(), idle_.end(), [](const auto& idle) {
        return idle->user() == std::this_thread::get_id();
    });
    if (own == idle_.end()) --own;
    std::unique_ptr<CommandWorker> worker = std::move(*own);
    idle_.erase(own);
    return worker;
}

CommandEnd CommandWorkers::run(const GoldenRunSettings& settings,
                               const std::vector<std::string>& words) {
    std::unique_ptr<CommandWorker> worker = take();
    CommandEnd result;
    bool done = false;
    if (worker) {
        result = worker->run(settings, words);
        done = !may_lack_resources(result);
    }
    if (!done) {
        worker = std::make_unique<CommandWorker>(settings);
        result = worker->run(settings, words);
    }
    if (worker->is_running()) {
        const std::lock_guard lock(mutex_);
        idle_.push_back(std::move(worker));
    }
    return result;
}

}  // namespace scb::golden
