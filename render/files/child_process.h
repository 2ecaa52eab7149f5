#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/files/unnamed_file.h"

namespace scb::render {

/// Whether PATH has a program of that name.
bool is_on_path(const std::string& program);

/// How a program ended: with an exit status, or by a signal; `code` is which.
struct ProcessEnd {
    bool by_signal = false;
    int code = 0;

    bool operator==(const ProcessEnd&) const = default;
};

/// Another program, which is fed through its standard input. It is in a process group of its own,
/// so that Ctrl-C does not reach it, and inherits no files but what is said here.
class ChildProcess {
  public:
    /// Where the program finds `output`.
    static constexpr const char* output_path = "/proc/self/fd/3";

    /// Starts the program that PATH has under the first name of `command`, with the others as its
    /// arguments, without a shell. Throws OutputError.
    ///
    /// `patience`: how long write() waits for a program that takes nothing. `folder`: where the
    /// program runs, and where a path of it that is relative begins; empty: here.
    ChildProcess(const std::vector<std::string>& command, const UnnamedFile& output,
                 std::chrono::milliseconds patience, const std::string& folder = "");
    /// Ends it where it still runs.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Blocks until it has taken all bytes; false where it takes no more. The only function that
    /// another thread may be in while one calls kill().
    bool write(std::span<const std::uint8_t> bytes);

    /// Waits for bytes that the program sends through the socket that is its standard input. False
    /// where the program has closed the socket before, and where `is_over` says true, which is
    /// asked all the while.
    bool read(std::span<std::uint8_t> bytes, const std::function<bool()>& is_over);

    /// Ends it at once, with its own children; a write() that blocks returns. Where SIGCHLD is
    /// ignored and it has ended already, its own children are left alone: the system may have given
    /// their process group's id to others.
    void kill();

    /// Ends its input and waits until it has ended. Nothing where it had not ended after that time,
    /// or when `stopped`, which is asked all the while, says true, and was killed; where it was
    /// waited for before; and where SIGCHLD is ignored, as then nobody learns how it ended.
    std::optional<ProcessEnd> wait(std::chrono::milliseconds most,
                                   const std::function<bool()>& stopped = {});

    /// Ends its input and waits until it has ended. Nothing where it had not ended after that time,
    /// and is then left to itself: it may outlive this program. Nothing either where SIGCHLD is
    /// ignored.
    std::optional<ProcessEnd> wait_or_leave(std::chrono::milliseconds most);

    /// Its process, which is its process group too; -1 once it was waited for.
    pid_t id() const { return id_; }

    /// All of its standard output so far.
    std::string printed() const;

    /// Empties what was printed. Throws OutputError.
    void forget_printed() const;

    /// The last line that is not empty of its standard error; where there is none, of its standard
    /// output.
    std::string last_line() const;

  private:
    /// Ends its input and waits until it has ended, or `is_over` says true, after which it is no
    /// longer this object's.
    std::optional<ProcessEnd> end_of(const std::function<bool()>& is_over, bool kill_it);

    UnnamedFile output_, errors_;
    int input_ = -1;  ///< one of two sockets: unlike a pipe, these need raise no SIGPIPE
    pid_t id_ = -1;   ///< -1 once it was waited for
};

}  // namespace scb::render
