#include "golden/suite/baseline_lock.h"

#include <system_error>

#include "core/platform/output_file.h"

namespace scb::golden {
namespace {

const std::filesystem::path& made(const std::filesystem::path& baselines) {
    std::error_code error;
    std::filesystem::create_directories(baselines, error);
    if (error)
        throw OutputError(baselines.string() + ": this folder cannot be made (" + error.message() +
                          "); name another with --baselines.");
    return baselines;
}

}  // namespace

BaselineLock::BaselineLock(const std::filesystem::path& baselines)
    : lock_(made(baselines), FolderLock::Busy::leave) {
    if (lock_.state() == FolderLock::State::busy)
        throw OutputError(baselines.string() +
                          ": another update is changing these baselines; wait until it has ended.");
}

}  // namespace scb::golden
