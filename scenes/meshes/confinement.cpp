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

#ifdef SCB_SANITIZED
// The sanitizer's shadow takes the whole address space.
constexpr bool limits_memory = false;
constexpr rlim_t slowness = 20;
#else
constexpr bool limits_memory = true;
constexpr rlim_t slowness = 1;
#endif

/// The size of the opened files.
std::uint64_t opened_bytes = 0;
bool memory_is_inherited = false;

/// Sets the soft limits. At the hard limit of its time, a process is killed without a reason; the
/// soft limit, below it, sends SIGXCPU. False if they cannot be set.
bool set_limits(std::uint64_t file_bytes) {
    constexpr rlim_t mega = 1'000'000, gibi = rlim_t{1} << 30;
    const rlim_t bytes = std::min<rlim_t>(file_bytes, gibi);
    static rlimit time = [] {
        rlimit now{};
        ::getrlimit(RLIMIT_CPU, &now);
        now.rlim_max = std::clamp<rlim_t>(now.rlim_max, 1, reader_patience + 1);
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

/// The calls for reading files, for memory and for the end of a process. Everything else is
/// refused.
constexpr int harmless_calls[] = {
    SCMP_SYS(read),
    SCMP_SYS(readv),
    SCMP_SYS(pread64),
    SCMP_SYS(write),
    SCMP_SYS(writev),
    SCMP_SYS(close),
    SCMP_SYS(lseek),
    SCMP_SYS(_llseek),
    SCMP_SYS(poll),
    SCMP_SYS(ppoll),
    SCMP_SYS(stat),
    SCMP_SYS(lstat),
    SCMP_SYS(fstat),
    SCMP_SYS(newfstatat),
    SCMP_SYS(fstatat64),
    SCMP_SYS(statx),
    SCMP_SYS(access),
    SCMP_SYS(faccessat),
    SCMP_SYS(faccessat2),
    SCMP_SYS(readlink),
    SCMP_SYS(readlinkat),
    SCMP_SYS(getcwd),
    SCMP_SYS(brk),
    SCMP_SYS(mmap),
    SCMP_SYS(munmap),
    SCMP_SYS(mremap),
    SCMP_SYS(mprotect),
    SCMP_SYS(madvise),
    SCMP_SYS(futex),
    SCMP_SYS(rt_sigaction),
    SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(rt_sigreturn),
    SCMP_SYS(sigaltstack),
    SCMP_SYS(restart_syscall),
    SCMP_SYS(alarm),
    SCMP_SYS(setitimer),
    SCMP_SYS(getpid),
    SCMP_SYS(gettid),
    SCMP_SYS(getppid),
    SCMP_SYS(getrlimit),
    SCMP_SYS(setrlimit),
    SCMP_SYS(ugetrlimit),
    SCMP_SYS(sysinfo),
    SCMP_SYS(sched_yield),
    SCMP_SYS(sched_getaffinity),
    SCMP_SYS(clock_gettime),
    SCMP_SYS(clock_getres),
    SCMP_SYS(gettimeofday),
    SCMP_SYS(time),
    SCMP_SYS(getrandom),
    SCMP_SYS(exit),
    SCMP_SYS(exit_group),
#ifdef SCB_SANITIZED
    // The sanitizers check that memory is readable by writing it to a pipe.
    SCMP_SYS(pipe),
    SCMP_SYS(pipe2),
    SCMP_SYS(prctl),
    SCMP_SYS(mincore),
    SCMP_SYS(getdents64),
    SCMP_SYS(personality),
    SCMP_SYS(nanosleep),
    SCMP_SYS(clock_nanosleep),
#endif
};

/// Returns an error, or 0.
int filter_system_calls() {
    const std::unique_ptr<void, void (*)(scmp_filter_ctx)> filter(
        seccomp_init(SCMP_ACT_ERRNO(EACCES)), seccomp_release);
    if (!filter) return ENOMEM;
    int error = 0;
    const auto allow = [&](int call, std::initializer_list<scmp_arg_cmp> arguments = {}) {
        const int added =
            seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call,
                                   static_cast<unsigned>(arguments.size()), arguments.begin());
        if (error == 0) error = -added;
    };
    for (const int call : harmless_calls) allow(call);
    constexpr std::uint64_t writes = O_ACCMODE | O_CREAT | O_TRUNC;
    allow(SCMP_SYS(open), {{1, SCMP_CMP_MASKED_EQ, writes, O_RDONLY}});
    allow(SCMP_SYS(openat), {{2, SCMP_CMP_MASKED_EQ, writes, O_RDONLY}});
    // Its own limits, signals and settings.
    allow(SCMP_SYS(prlimit64), {{0, SCMP_CMP_EQ, 0, 0}});
    allow(SCMP_SYS(tgkill), {{0, SCMP_CMP_EQ, static_cast<std::uint64_t>(::getpid()), 0}});
#ifndef SCB_SANITIZED
    allow(SCMP_SYS(prctl), {{0, SCMP_CMP_EQ, PR_GET_PDEATHSIG, 0}});
#endif
    return error != 0 ? error : -seccomp_load(filter.get());
}

}  // namespace

std::string confine_this_process(int answers) {
    const auto reason = [](const char* what, int error) {
        return std::string(what) + ": " + std::generic_category().message(error);
    };
    if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return reason("prctl", errno);
    // The starting process may have ended by now.
    pollfd pipe{answers, 0, 0};
    if (::poll(&pipe, 1, 0) < 0) return reason("poll", errno);
    if ((pipe.revents & POLLERR) != 0) return "nobody waits for it";
    ::alarm(reader_patience);
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
