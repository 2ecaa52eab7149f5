#include "golden/run/work_folder.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <set>
#include <string>

#include "core/platform/output_file.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

/// Receives process groups until the other end of the pipe is closed; then ends the groups that are
/// left, and removes the folder.
[[noreturn]] void remove_at_end(int pipe, const fs::path& folder) {
    // It must survive when the program, its terminal or its group of processes is ended.
    ::setsid();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
    // A reader of the program's output waits until all its writers are closed.
    ::dup2(pipe, STDIN_FILENO);
    ::closefrom(STDIN_FILENO + 1);
    std::set<pid_t> groups;
    pid_t told = 0;
    ssize_t got = 0;
    while ((got = ::read(STDIN_FILENO, &told, sizeof told)) > 0 || (got < 0 && errno == EINTR)) {
        if (got != sizeof told) continue;
        if (told > 0)
            groups.insert(told);
        else
            groups.erase(-told);
    }
    for (const pid_t group : groups) ::kill(-group, SIGKILL);
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    ::_exit(0);
}

}  // namespace

GoldenWork::GoldenWork() {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    if (error)
        throw OutputError("There is no folder for temporary files (" + error.message() +
                          "); name one with TMPDIR.");
    std::string name = (folder / "scb-golden-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw OutputError(folder.string() + ": no temporary files can be made there (" +
                          std::strerror(errno) + "); name another folder with TMPDIR.");
    path_ = name;
    start_remover();
    fs::create_directory(candidates());
    fs::create_directory(report());
}

GoldenWork::~GoldenWork() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    if (remover_ < 0) return;
    ::close(lifeline_);
    while (::waitpid(remover_, nullptr, 0) < 0 && errno == EINTR) continue;
}

void GoldenWork::tell(pid_t group) const {
    // So few bytes are written whole. Without a remover, nothing is sent.
    if (remover_ >= 0)
        while (::send(lifeline_, &group, sizeof group, MSG_NOSIGNAL) < 0 && errno == EINTR)
            continue;
}

// A signal handler must not remove a folder, and SIGKILL has no handler.
void GoldenWork::start_remover() {
    // A socket, since writing to a pipe without a reader raises a signal.
    int pipe[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pipe) != 0) return;
    remover_ = ::fork();
    if (remover_ == 0) {
        ::close(pipe[1]);
        remove_at_end(pipe[0], path_);
    }
    ::close(pipe[0]);
    lifeline_ = pipe[1];
    if (remover_ < 0) ::close(lifeline_);
}

}  // namespace scb::golden
