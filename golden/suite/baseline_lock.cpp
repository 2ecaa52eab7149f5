#include "golden/suite/baseline_lock.h"

#include <system_error>

#include "render/files/output_file.h"

namespace scb::golden {
namespace {

const std::filesystem::path& made(const std::filesystem::path& baselines) {
    std::error_code error;
    std::filesystem::create_directories(baselines, error);
    if (error)
        throw render::OutputError(baselines.string() + ": this folder cannot be made (" +
                                  error.message() + "); name another with --baselines.");
    return baselines;
}

}  // namespace

BaselineLock::BaselineLock(const std::filesystem::path& baselines)
    : lock_(made(baselines), render::FolderLock::Busy::leave) {
    if (lock_.state() == render::FolderLock::State::busy)
        throw render::OutputError(
            baselines.string() +
            ": another update is changing these baselines; wait until it has ended.");
}

}  // namespace scb::golden
