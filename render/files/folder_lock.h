#pragma once

#include <filesystem>

namespace scb::render {

/// A folder that programs change one at a time. The lock is gone at the end, however the program
/// ends, and leaves no file.
class FolderLock {
  public:
    /// What to do where another has the folder.
    enum class Busy { wait, leave };
    enum class State {
        held,
        busy,    ///< another has it
        unknown  ///< the file system knows no locks: there may be others
    };

    /// Throws OutputError where the folder cannot be opened.
    FolderLock(const std::filesystem::path& folder, Busy busy);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    State state() const { return state_; }

  private:
    int descriptor_ = -1;
    State state_ = State::unknown;
};

}  // namespace scb::render
