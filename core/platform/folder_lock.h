#pragma once

#include <filesystem>

namespace scb {

/// A lock on a folder that only one program may change at a time. It ends with the program, in any
/// case, and leaves no file.
class FolderLock {
  public:
    /// What to do if another program has the lock.
    enum class Busy { wait, leave };
    enum class State {
        held,
        busy,    ///< another program has it
        unknown  ///< the file system has no locks: there may be others
    };

    /// Throws OutputError if the folder cannot be opened.
    FolderLock(const std::filesystem::path& folder, Busy busy);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    State state() const { return state_; }

  private:
    int descriptor_ = -1;
    State state_ = State::unknown;
};

}  // namespace scb
