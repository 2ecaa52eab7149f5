#include "scenes/meshes/isolated_run.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace scb::scenes {

bool survives(const std::function<void()>& action) {
    const pid_t child = fork();
    if (child < 0) return true;
    if (child == 0) {
        // Handlers of the caller (a crash reporter, a sanitizer) are not for this child, nor is a
        // core file.
        for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL})
            std::signal(signal, SIG_DFL);
        const rlimit no_core{0, 0}, processor_seconds{300, 300};
        // Nor may it outlive the caller, wait for ever, or speak: the caller reports in its own
        // words.
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        alarm(300);
        if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0)
            dup2(nowhere, STDERR_FILENO);
        setrlimit(RLIMIT_CORE, &no_core);
        setrlimit(RLIMIT_CPU, &processor_seconds);
        try {
            action();
        } catch (...) {
            // The caller runs the action again and sees the exception itself.
        }
        _exit(0);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return true;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace scb::scenes
