#include "core/platform/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/platform/output_file.h"

namespace scb {

FolderLock::FolderLock(const std::filesystem::path& folder, Busy busy) {
    // Locks the folder itself, since a lock file could be mistaken for one of its files.
    descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0)
        throw OutputError(folder.string() + ": this folder cannot be opened (" +
                          std::strerror(errno) + "); name another.");
    const int how = LOCK_EX | (busy == Busy::leave ? LOCK_NB : 0);
    int result = ::flock(descriptor_, how);
    while (result != 0 && errno == EINTR) result = ::flock(descriptor_, how);
    state_ = result == 0 ? State::held : errno == EWOULDBLOCK ? State::busy : State::unknown;
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace scb
