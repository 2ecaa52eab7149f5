#include "core/platform/child_process.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <system_error>
#include <thread>

#include "core/platform/output_file.h"

namespace scb {
namespace {

[[noreturn]] void fail_to_start(const std::string& program, int error) {
    throw OutputError("Cannot start " + program + ": " + std::strerror(error) +
                      "; see that it is installed and can be run.");
}

std::string text_of(const UnnamedFile& file) {
    const std::vector<std::uint8_t> bytes = file.bytes();
    return {bytes.begin(), bytes.end()};
}

std::string last_line_of(const std::string& text) {
    std::istringstream lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);)
        if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
    // The line becomes part of a message, which would end at a zero.
    std::replace(last.begin(), last.end(), '\0', '?');
    return last;
}

}  // namespace

bool is_on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "/bin:/usr/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::string file = (folder.empty() ? "." : folder) + "/" + program;
        struct stat status;
        if (::access(file.c_str(), X_OK) == 0 && ::stat(file.c_str(), &status) == 0 &&
            S_ISREG(status.st_mode))
            return true;
    }
    return false;
}

ChildProcess::ChildProcess(const std::vector<std::string>& command, const UnnamedFile& output,
                           std::chrono::milliseconds patience, const std::string& folder) {
    int sockets[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
        fail_to_start(command[0], errno);
    input_ = Descriptor(sockets[0]);
    const Descriptor given(sockets[1]);
    const timeval most = {patience.count() / 1000, patience.count() % 1000 * 1000};
    ::setsockopt(input_.number(), SOL_SOCKET, SO_SNDTIMEO, &most, sizeof most);
    try {
        id_ = start_process(
            command,
            {given.number(), output_.descriptor(), errors_.descriptor(), output.descriptor()},
            folder);
    } catch (const std::system_error& error) {
        fail_to_start(command[0], error.code().value());
    }
}

ChildProcess::~ChildProcess() {
    if (id_ < 0) return;
    kill();
    wait_for_process(id_);
}

bool ChildProcess::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(input_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool ChildProcess::read(std::span<std::uint8_t> bytes, const std::function<bool()>& is_over) {
    return read_fully(input_.number(), bytes, is_over);
}

void ChildProcess::kill() {
    if (id_ < 0) return;
    kill_process(id_);
    ::shutdown(input_.number(), SHUT_RDWR);
}

std::optional<ProcessEnd> ChildProcess::end_of(const std::function<bool()>& is_over, bool kill_it) {
    if (id_ < 0) return std::nullopt;
    ::shutdown(input_.number(), SHUT_WR);
    bool over = false, forgotten = false;
    int status = 0;
    for (pid_t ended = 0; ended != id_ && !forgotten && !(over && !kill_it);) {
        ended = ::waitpid(id_, &status, over ? 0 : WNOHANG);
        forgotten = ended < 0 && errno == ECHILD;  // SIGCHLD is ignored
        if (ended != 0) continue;
        over = is_over();
        if (!over)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        else if (kill_it)
            kill();
    }
    input_.close();
    id_ = -1;
    if (over || forgotten) return std::nullopt;
    return process_end(status);
}

std::optional<ProcessEnd> ChildProcess::wait(std::chrono::milliseconds most,
                                             const std::function<bool()>& stopped) {
    const auto end = std::chrono::steady_clock::now() + most;
    return end_of([&] { return std::chrono::steady_clock::now() >= end || (stopped && stopped()); },
                  true);
}

std::optional<ProcessEnd> ChildProcess::wait_or_leave(std::chrono::milliseconds most) {
    const auto end = std::chrono::steady_clock::now() + most;
    return end_of([&] { return std::chrono::steady_clock::now() >= end; }, false);
}

std::string ChildProcess::printed() const { return text_of(output_); }

void ChildProcess::forget_printed() const {
    output_.clear();
    errors_.clear();
}

std::string ChildProcess::last_line() const {
    const std::string last = last_line_of(text_of(errors_));
    return last.empty() ? last_line_of(text_of(output_)) : last;
}

}  // namespace scb
