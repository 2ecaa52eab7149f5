#include "scenes/meshes/confinement.h"

#include <fcntl.h>
#include <poll.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <memory>
#include <system_error>
#include <utility>

namespace scb::scenes {
namespace {

constexpr unsigned patience = 300;  // seconds

#ifdef SCB_SANITIZED
// Its shadow takes the whole address space.
constexpr bool limits_memory = false;
constexpr rlim_t slowness = 20;
#else
constexpr bool limits_memory = true;
constexpr rlim_t slowness = 1;
#endif

/// The files that were opened.
std::uint64_t opened_bytes = 0;
bool memory_is_inherited = false;

/// The soft limits. A process is killed at the hard limit of its time; the soft one, below it,
/// tells it why (SIGXCPU). False where they cannot be set.
bool set_limits(std::uint64_t file_bytes) {
    constexpr rlim_t mega = 1'000'000, gibi = rlim_t{1} << 30;
    const rlim_t bytes = std::min<rlim_t>(file_bytes, gibi);
    static rlimit time = [] {
        rlimit now{};
        ::getrlimit(RLIMIT_CPU, &now);
        now.rlim_max = std::clamp<rlim_t>(now.rlim_max, 1, patience + 1);
        now.rlim_cur = std::min(now.rlim_cur, now.rlim_max - 1);
        return now;
    }();
    rlimit limits = time;
    limits.rlim_cur = std::min(limits.rlim_cur, slowness * (8 + 2 * bytes / mega));
    if (::setrlimit(RLIMIT_CPU, &limits) != 0) return false;
    if (!limits_memory) return true;
    static const rlimit memory = [] {
        rlimit now{};
        ::getrlimit(RLIMIT_AS, &now);
        return now;
    }();
    limits = memory;
    const rlim_t enough = std::min(12 * gibi, gibi + gibi / 2 + 64 * bytes);
    memory_is_inherited = limits.rlim_cur < enough;
    limits.rlim_cur = std::min(limits.rlim_cur, enough);
    return ::setrlimit(RLIMIT_AS, &limits) == 0;
}

/// Returns an error, or 0.
int filter_system_calls() {
    const std::unique_ptr<void, void (*)(scmp_filter_ctx)> filter(seccomp_init(SCMP_ACT_ALLOW),
                                                                  seccomp_release);
    if (!filter) return ENOMEM;
    int error = 0;
    const auto refuse = [&](int call, std::initializer_list<scmp_arg_cmp> arguments = {}) {
        const int added =
            seccomp_rule_add_array(filter.get(), SCMP_ACT_ERRNO(EACCES), call,
                                   static_cast<unsigned>(arguments.size()), arguments.begin());
        if (error == 0) error = -added;
    };
    for (const int call : {SCMP_SYS(socket),
                           SCMP_SYS(connect),
                           SCMP_SYS(bind),
                           SCMP_SYS(io_uring_setup),
                           SCMP_SYS(execve),
                           SCMP_SYS(execveat),
                           SCMP_SYS(openat2),
                           SCMP_SYS(creat),
                           SCMP_SYS(truncate),
                           SCMP_SYS(unlink),
                           SCMP_SYS(unlinkat),
                           SCMP_SYS(rename),
                           SCMP_SYS(renameat),
                           SCMP_SYS(renameat2),
                           SCMP_SYS(rmdir),
                           SCMP_SYS(mkdir),
                           SCMP_SYS(mkdirat),
                           SCMP_SYS(link),
                           SCMP_SYS(linkat),
                           SCMP_SYS(symlink),
                           SCMP_SYS(symlinkat),
                           SCMP_SYS(mknod),
                           SCMP_SYS(mknodat),
                           SCMP_SYS(mount),
                           SCMP_SYS(chmod),
                           SCMP_SYS(fchmod),
                           SCMP_SYS(fchmodat),
                           SCMP_SYS(chown),
                           SCMP_SYS(fchown),
                           SCMP_SYS(lchown),
                           SCMP_SYS(fchownat),
                           SCMP_SYS(utime),
                           SCMP_SYS(utimes),
                           SCMP_SYS(futimesat),
                           SCMP_SYS(utimensat),
                           SCMP_SYS(setxattr),
                           SCMP_SYS(lsetxattr),
                           SCMP_SYS(fsetxattr),
                           SCMP_SYS(removexattr),
                           SCMP_SYS(lremovexattr),
                           SCMP_SYS(fremovexattr),
                           SCMP_SYS(kill),
                           SCMP_SYS(rt_sigqueueinfo),
                           SCMP_SYS(pidfd_open),
                           SCMP_SYS(pidfd_send_signal),
                           SCMP_SYS(process_vm_readv),
                           SCMP_SYS(process_vm_writev)})
        refuse(call);
    // The limits of other processes.
    refuse(SCMP_SYS(prlimit64), {{0, SCMP_CMP_NE, 0, 0}});
    // The leak sanitizer looks at its own process.
    if (limits_memory) refuse(SCMP_SYS(ptrace));
    for (const auto& [mask, value] : {std::pair{O_ACCMODE, O_WRONLY},
                                      {O_ACCMODE, O_RDWR},
                                      {O_CREAT, O_CREAT},
                                      {O_TRUNC, O_TRUNC}}) {
        const auto m = static_cast<std::uint64_t>(mask), v = static_cast<std::uint64_t>(value);
        refuse(SCMP_SYS(open), {{1, SCMP_CMP_MASKED_EQ, m, v}});
        refuse(SCMP_SYS(openat), {{2, SCMP_CMP_MASKED_EQ, m, v}});
    }
    return error != 0 ? error : -seccomp_load(filter.get());
}

}  // namespace

std::string confine_this_process(int answers) {
    const auto reason = [](const char* what, int error) {
        return std::string(what) + ": " + std::generic_category().message(error);
    };
    if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return reason("prctl", errno);
    // Who started it may be gone by now.
    pollfd pipe{answers, 0, 0};
    if (::poll(&pipe, 1, 0) < 0) return reason("poll", errno);
    if ((pipe.revents & POLLERR) != 0) return "nobody waits for it";
    ::alarm(patience);
    const rlimit none{0, 0};
    for (const auto resource : {RLIMIT_CORE, RLIMIT_FSIZE})
        if (::setrlimit(resource, &none) != 0) return reason("setrlimit", errno);
    constexpr rlim_t most_files = 32;
    rlimit files{};
    if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return reason("getrlimit", errno);
    files.rlim_cur = std::min(files.rlim_cur, most_files);
    if (::setrlimit(RLIMIT_NOFILE, &files) != 0 || !set_limits(0))
        return reason("setrlimit", errno);
    const int error = filter_system_calls();
    return error == 0 ? "" : reason("seccomp", error);
}

void allow_for(std::uint64_t file_bytes) {
    opened_bytes += std::min(file_bytes, UINT64_MAX - opened_bytes);
    set_limits(opened_bytes);
}

AddressSpace address_space() {
    rlimit limits{};
    ::getrlimit(RLIMIT_AS, &limits);
    return {limits.rlim_cur, memory_is_inherited};
}

}  // namespace scb::scenes
