#include "golden/run/work_folder.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>

#include "render/files/output_file.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

/// Waits until the other end of the pipe is closed, then removes the folder.
[[noreturn]] void remove_at_end(int pipe, const fs::path& folder) {
    // What ends the program, its terminal or its group of processes must be outlived.
    ::setsid();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
    // Whoever reads what the program prints waits until nobody can print any more.
    ::dup2(pipe, STDIN_FILENO);
    ::closefrom(STDIN_FILENO + 1);
    char none = 0;
    while (::read(STDIN_FILENO, &none, 1) < 0 && errno == EINTR) continue;
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    ::_exit(0);
}

}  // namespace

GoldenWork::GoldenWork() {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    if (error)
        throw render::OutputError("There is no folder for temporary files (" + error.message() +
                                  "); name one with TMPDIR.");
    std::string name = (folder / "scb-golden-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw render::OutputError(folder.string() + ": no temporary files can be made there (" +
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

// A handler of signals must not remove a folder, and of SIGKILL there is none.
void GoldenWork::start_remover() {
    int pipe[2];
    if (::pipe2(pipe, O_CLOEXEC) != 0) return;
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
