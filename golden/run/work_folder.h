#pragma once

#include <sys/types.h>

#include <filesystem>

namespace scb::golden {

/// A folder for what a run makes, which is gone at the end, also where a signal ends the program:
/// `candidates` and `report`.
class GoldenWork {
  public:
    /// Not while there are other threads. Throws OutputError.
    GoldenWork();
    ~GoldenWork();
    GoldenWork(const GoldenWork&) = delete;
    GoldenWork& operator=(const GoldenWork&) = delete;

    std::filesystem::path candidates() const { return path_ / "candidates"; }
    std::filesystem::path report() const { return path_ / "report"; }

  private:
    void start_remover();

    std::filesystem::path path_;
    int lifeline_ = -1;   ///< a pipe, which is closed when this program ends, however it does
    pid_t remover_ = -1;  ///< who waits for that
};

}  // namespace scb::golden
