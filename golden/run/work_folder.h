#pragma once

#include <sys/types.h>

#include <filesystem>

namespace scb::golden {

/// A folder for the files of a run, with `candidates` and `report`. It is removed at the end, also
/// if a signal ends the program, and so are the processes that write to it.
class GoldenWork {
  public:
    /// Must not be called while there are other threads. Throws OutputError.
    GoldenWork();
    ~GoldenWork();
    GoldenWork(const GoldenWork&) = delete;
    GoldenWork& operator=(const GoldenWork&) = delete;

    /// Reports that a process group writes here, until has_ended. Any thread may call this.
    void has_started(pid_t group) const { tell(group); }
    void has_ended(pid_t group) const { tell(-group); }

    std::filesystem::path candidates() const { return path_ / "candidates"; }
    std::filesystem::path report() const { return path_ / "report"; }

  private:
    void start_remover();
    void tell(pid_t group) const;

    std::filesystem::path path_;
    int lifeline_ = -1;   ///< a socket, which is closed when this program ends, in any way
    pid_t remover_ = -1;  ///< the process that waits for that
};

}  // namespace scb::golden
