#pragma once

#include <filesystem>

#include "core/platform/folder_lock.h"

namespace scb::golden {

/// A lock on the folder of baselines: one update at a time.
class BaselineLock {
  public:
    /// Makes the folder if there is none. Throws OutputError if that fails, and if another update
    /// has the folder.
    explicit BaselineLock(const std::filesystem::path& baselines);

    /// False if the file system has no locks: then there may be other updates.
    bool held() const { return lock_.state() == FolderLock::State::held; }

  private:
    FolderLock lock_;
};

}  // namespace scb::golden
