#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace scb {

/// A descriptor that is closed at the end unless it is released.
class Descriptor {
  public:
    explicit Descriptor(int opened = -1) : number_(opened) {}
    Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
    ~Descriptor() { close(); }
    Descriptor& operator=(Descriptor&& other) noexcept {
        close();
        number_ = other.release();
        return *this;
    }

    int number() const { return number_; }
    int release() { return std::exchange(number_, -1); }
    void close();

  private:
    int number_;
};

/// Starts the program `command[0]`, from PATH if the name has no slash, with the other words as its
/// arguments, without a shell. Returns its id, which is also the id of its process group. Throws
/// std::system_error.
///
/// `descriptors`: descriptors of this process; the i-th becomes the program's descriptor i. The
/// program inherits no others. `folder`: its working folder, also for a relative path of the
/// program; empty: the current folder. The program has a session of its own, so that Ctrl-C and the
/// terminal do not reach it. No signal is blocked or ignored.
pid_t start_process(const std::vector<std::string>& command, const std::vector<int>& descriptors,
                    const std::string& folder = "");

/// Kills a started process and its group. No effect if SIGCHLD is ignored and the process has
/// ended: the system may have given the group's id to others.
void kill_process(pid_t id);

/// How a program ended: with an exit status, or by a signal; `code` is its number.
struct ProcessEnd {
    bool by_signal = false;
    int code = 0;

    bool operator==(const ProcessEnd&) const = default;
};

/// The end that waitpid reports as `status`.
ProcessEnd process_end(int status);

/// Waits until a started process has ended. Nothing if SIGCHLD is ignored, since the system then
/// does not report how the process ended.
std::optional<ProcessEnd> wait_for_process(pid_t id);

/// Waits for bytes from a pipe or a socket. False if the other end has closed it before, or once
/// `is_over`, which is polled while no bytes arrive, returns true.
bool read_fully(int descriptor, std::span<std::uint8_t> bytes,
                const std::function<bool()>& is_over);

}  // namespace scb
