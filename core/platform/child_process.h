#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/platform/process.h"
#include "core/platform/unnamed_file.h"

namespace scb {

/// Whether PATH has a program of that name.
bool is_on_path(const std::string& program);

/// Another program, which receives bytes through its standard input. It is started by
/// start_process, in its own session and with default signals. It inherits no files except those
/// named here.
class ChildProcess {
  public:
    /// The path of `output` for the program.
    static constexpr const char* output_path = "/proc/self/fd/3";

    /// Starts the program `command[0]` from PATH, with the other words as its arguments, without a
    /// shell. Throws OutputError.
    ///
    /// `patience`: how long write() waits for a program that reads nothing. `folder`: the program's
    /// working folder, also for its relative path; empty: the current folder.
    ChildProcess(const std::vector<std::string>& command, const UnnamedFile& output,
                 std::chrono::milliseconds patience, const std::string& folder = "");
    /// Ends the program if it still runs.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Blocks until the program has read all bytes; false if it reads no more. Only this function
    /// may run in another thread during kill().
    bool write(std::span<const std::uint8_t> bytes);

    /// Waits for bytes that the program sends through the socket of its standard input. False if
    /// the program has closed the socket before, or once `is_over`, which is polled, returns true.
    bool read(std::span<std::uint8_t> bytes, const std::function<bool()>& is_over);

    /// Ends the program at once, with its own children; a blocked write() returns. If SIGCHLD is
    /// ignored and the program has ended already, its children are not ended: the system may have
    /// given their process group's id to others.
    void kill();

    /// Closes its input and waits until it has ended. If it has not ended after this time, or once
    /// `stopped`, which is polled, returns true, it is killed, and the result is nothing. Nothing
    /// also if it was waited for before, or if SIGCHLD is ignored, since the system then does not
    /// report how it ended.
    std::optional<ProcessEnd> wait(std::chrono::milliseconds most,
                                   const std::function<bool()>& stopped = {});

    /// Closes its input and waits until it has ended. If it has not ended after this time, the
    /// result is nothing, and the program goes on: it may outlive this one. Nothing also if SIGCHLD
    /// is ignored.
    std::optional<ProcessEnd> wait_or_leave(std::chrono::milliseconds most);

    /// The id of its process and process group; -1 after it was waited for.
    pid_t id() const { return id_; }

    /// All of its standard output so far.
    std::string printed() const;

    /// Empties what was printed. Throws OutputError.
    void forget_printed() const;

    /// The last nonempty line of its standard error, or, if there is none, of its standard output.
    std::string last_line() const;

  private:
    /// Closes its input and waits until it has ended, or until `is_over` returns true. Afterwards
    /// the process no longer belongs to this object.
    std::optional<ProcessEnd> end_of(const std::function<bool()>& is_over, bool kill_it);

    UnnamedFile output_, errors_;
    Descriptor input_;  ///< one of two sockets: unlike pipes, these can avoid SIGPIPE
    pid_t id_ = -1;     ///< -1 after it was waited for
};

}  // namespace scb
