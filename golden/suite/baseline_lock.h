#pragma once

#include <filesystem>

#include "render/files/folder_lock.h"

namespace scb::golden {

/// The folder of baselines while it is updated: one update at a time.
class BaselineLock {
  public:
    /// Makes the folder where there is none. Throws OutputError where that cannot be, and where
    /// another update has the folder.
    explicit BaselineLock(const std::filesystem::path& baselines);

    /// False where the file system knows no locks: then there may be others.
    bool held() const { return lock_.state() == render::FolderLock::State::held; }

  private:
    render::FolderLock lock_;
};

}  // namespace scb::golden
