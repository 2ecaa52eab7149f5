#pragma once

#include <filesystem>

namespace scb::golden {

/// The folder of baselines while it is updated: one update at a time. The lock is gone at the end,
/// however the program ends.
class BaselineLock {
  public:
    /// Makes the folder where there is none. Throws OutputError where that cannot be, and where
    /// another update has the folder.
    explicit BaselineLock(const std::filesystem::path& baselines);
    ~BaselineLock();
    BaselineLock(const BaselineLock&) = delete;
    BaselineLock& operator=(const BaselineLock&) = delete;

    /// False where the file system knows no locks: then there may be others.
    bool held() const { return held_; }

  private:
    int descriptor_ = -1;
    bool held_ = false;
};

}  // namespace scb::golden
