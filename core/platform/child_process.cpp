#include "core/platform/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>
#include <utility>

#include "core/platform/output_file.h"

namespace scb {
namespace {

[[noreturn]] void fail_to_start(const std::string& program, int error) {
    throw OutputError("Cannot start " + program + ": " + std::strerror(error) +
                      "; see that it is installed and can be run.");
}

/// A descriptor that is closed unless it is released.
struct Descriptor {
    int number;

    explicit Descriptor(int opened) : number(opened) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    void close() {
        if (number >= 0) ::close(std::exchange(number, -1));
    }
    int release() { return std::exchange(number, -1); }
};

// The child's descriptor that ChildProcess::output_path names, and the one behind it.
constexpr int output_descriptor = 3, first_not_given = 4;

/// The settings of a new process besides its arguments.
struct SpawnSettings {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    std::vector<int> copies;
    int error = 0;

    SpawnSettings() {
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
        posix_spawnattr_setpgroup(&attributes, 0);
    }
    ~SpawnSettings() {
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&files);
        for (const int copy : copies) ::close(copy);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;

    /// Keeps the first error of the calls.
    void keep(int result) {
        if (error == 0) error = result;
    }

    void give(int descriptor, int as) {
        // From a copy above all given descriptors, so that none overwrites another before its turn:
        // this program itself may run with its standard input closed.
        const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, first_not_given);
        if (copy < 0) {
            error = errno;
            return;
        }
        try {
            copies.push_back(copy);
        } catch (...) {
            ::close(copy);
            throw;
        }
        keep(posix_spawn_file_actions_adddup2(&files, copy, as));
    }
};

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
    Descriptor own(sockets[0]), given(sockets[1]);
    const timeval most = {patience.count() / 1000, patience.count() % 1000 * 1000};
    ::setsockopt(own.number, SOL_SOCKET, SO_SNDTIMEO, &most, sizeof most);
    SpawnSettings settings;
    settings.give(given.number, STDIN_FILENO);
    settings.give(output_.descriptor(), STDOUT_FILENO);
    settings.give(errors_.descriptor(), STDERR_FILENO);
    settings.give(output.descriptor(), output_descriptor);
    settings.keep(posix_spawn_file_actions_addclosefrom_np(&settings.files, first_not_given));
    if (!folder.empty())
        settings.keep(posix_spawn_file_actions_addchdir_np(&settings.files, folder.c_str()));
    given.close();
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    int error = settings.error;
    if (error == 0)
        error = ::posix_spawnp(&id_, arguments[0], &settings.files, &settings.attributes,
                               arguments.data(), environ);
    if (error != 0) fail_to_start(command[0], error);
    input_ = own.release();
}

ChildProcess::~ChildProcess() {
    if (id_ < 0) return;
    kill();
    int ignored = 0;
    while (::waitpid(id_, &ignored, 0) < 0 && errno == EINTR) continue;
    ::close(input_);
}

bool ChildProcess::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool ChildProcess::read(std::span<std::uint8_t> bytes, const std::function<bool()>& is_over) {
    constexpr int milliseconds_at_a_time = 20;
    while (!bytes.empty()) {
        pollfd socket{input_, POLLIN, 0};
        const int ready = ::poll(&socket, 1, milliseconds_at_a_time);
        if (ready < 0 && errno != EINTR) return false;
        if (ready <= 0) {
            if (is_over()) return false;
            continue;
        }
        const ssize_t got = ::recv(input_, bytes.data(), bytes.size(), 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

void ChildProcess::kill() {
    if (id_ < 0) return;
    // The system keeps the id of an ended child until it is waited for, except if SIGCHLD is
    // ignored.
    siginfo_t ignored;
    const bool kept =
        ::waitid(P_PID, static_cast<id_t>(id_), &ignored, WEXITED | WNOHANG | WNOWAIT) == 0;
    if (kept) ::kill(-id_, SIGKILL);
    ::shutdown(input_, SHUT_RDWR);
}

std::optional<ProcessEnd> ChildProcess::end_of(const std::function<bool()>& is_over, bool kill_it) {
    if (id_ < 0) return std::nullopt;
    ::shutdown(input_, SHUT_WR);
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
    ::close(input_);
    id_ = -1;
    if (over || forgotten) return std::nullopt;
    if (WIFSIGNALED(status)) return ProcessEnd{true, WTERMSIG(status)};
    return ProcessEnd{false, WEXITSTATUS(status)};
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
