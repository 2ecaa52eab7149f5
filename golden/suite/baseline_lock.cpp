#include "golden/suite/baseline_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "render/files/output_file.h"

namespace scb::golden {

BaselineLock::BaselineLock(const std::filesystem::path& baselines) {
    std::error_code error;
    std::filesystem::create_directories(baselines, error);
    if (error)
        throw render::OutputError(baselines.string() + ": this folder cannot be made (" +
                                  error.message() + "); name another with --baselines.");
    // The folder itself, lest a file for the lock is committed with the baselines.
    descriptor_ = ::open(baselines.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0)
        throw render::OutputError(baselines.string() + ": this folder cannot be opened (" +
                                  std::strerror(errno) + "); name another with --baselines.");
    held_ = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
    if (held_ || errno != EWOULDBLOCK) return;
    ::close(descriptor_);
    throw render::OutputError(
        baselines.string() +
        ": another update is changing these baselines; wait until it has ended.");
}

BaselineLock::~BaselineLock() { ::close(descriptor_); }

}  // namespace scb::golden
