#pragma once

#include <sys/types.h>

#include <filesystem>

namespace scb::golden {

/// A folder for what a run makes, which is gone at the end, also where a signal ends the program,
/// as are the processes that make it: `candidates` and `report`.
class GoldenWork {
  public:
    /// Not while there are other threads. Throws OutputError.
    GoldenWork();
    ~GoldenWork();
    GoldenWork(const GoldenWork&) = delete;
    GoldenWork& operator=(const GoldenWork&) = delete;

    /// Says that a process group makes something here, until that has ended. Any thread may.
    void has_started(pid_t group) const { tell(group); }
    void has_ended(pid_t group) const { tell(-group); }

    std::filesystem::path candidates() const { return path_ / "candidates"; }
    std::filesystem::path report() const { return path_ / "report"; }

  private:
    void start_remover();
    void tell(pid_t group) const;

    std::filesystem::path path_;
    int lifeline_ = -1;   ///< a socket, which is closed when this program ends, however it does
    pid_t remover_ = -1;  ///< who waits for that
};

}  // namespace scb::golden
