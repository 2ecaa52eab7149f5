#include "core/platform/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

namespace scb {
namespace {

[[noreturn]] void fail(int error) { throw std::system_error(error, std::generic_category()); }

/// The settings of a new process besides its arguments.
struct SpawnSettings {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;

    SpawnSettings() {
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
    }
    ~SpawnSettings() {
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&files);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;
};

void check(int error) {
    if (error != 0) fail(error);
}

}  // namespace

void Descriptor::close() {
    if (number_ >= 0) ::close(release());
}

pid_t start_process(const std::vector<std::string>& command, const std::vector<int>& descriptors,
                    const std::string& folder) {
    SpawnSettings settings;
    // The child gets copies with numbers of at least `count`. A given descriptor may have a number
    // below `count`, and the first dup2 would overwrite it.
    const int count = static_cast<int>(descriptors.size());
    std::vector<Descriptor> copies;
    copies.reserve(descriptors.size());
    for (int i = 0; i < count; ++i) {
        copies.emplace_back(
            ::fcntl(descriptors[static_cast<std::size_t>(i)], F_DUPFD_CLOEXEC, count));
        if (copies.back().number() < 0) fail(errno);
        check(posix_spawn_file_actions_adddup2(&settings.files, copies.back().number(), i));
    }
    check(posix_spawn_file_actions_addclosefrom_np(&settings.files, count));
    if (!folder.empty())
        check(posix_spawn_file_actions_addchdir_np(&settings.files, folder.c_str()));
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    check(posix_spawnattr_setsigmask(&settings.attributes, &none));
    check(posix_spawnattr_setsigdefault(&settings.attributes, &all));
    check(posix_spawnattr_setflags(
        &settings.attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF));
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t id = -1;
    check(::posix_spawnp(&id, arguments[0], &settings.files, &settings.attributes, arguments.data(),
                         environ));
    return id;
}

void kill_process(pid_t id) {
    // The system keeps the id of an ended child until it is waited for, except if SIGCHLD is
    // ignored.
    siginfo_t ignored;
    if (::waitid(P_PID, static_cast<id_t>(id), &ignored, WEXITED | WNOHANG | WNOWAIT) == 0)
        ::kill(-id, SIGKILL);
}

ProcessEnd process_end(int status) {
    if (WIFSIGNALED(status)) return {true, WTERMSIG(status)};
    return {false, WEXITSTATUS(status)};
}

std::optional<ProcessEnd> wait_for_process(pid_t id) {
    int status = 0;
    pid_t waited = -1;
    do waited = ::waitpid(id, &status, 0);
    while (waited < 0 && errno == EINTR);
    if (waited < 0) return std::nullopt;
    return process_end(status);
}

bool read_fully(int descriptor, std::span<std::uint8_t> bytes,
                const std::function<bool()>& is_over) {
    constexpr int milliseconds_at_a_time = 20;
    while (!bytes.empty()) {
        pollfd source{descriptor, POLLIN, 0};
        const int ready = ::poll(&source, 1, milliseconds_at_a_time);
        if (ready < 0 && errno != EINTR) return false;
        if (ready <= 0) {
            if (is_over()) return false;
            continue;
        }
        const ssize_t got = ::read(descriptor, bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

}  // namespace scb
