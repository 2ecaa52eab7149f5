#include "scenes/meshes/confinement.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <functional>

#include "tests/temporary_folder.h"
#include "tests/unless_sanitized.h"

namespace scb::scenes {
namespace {

/// Confines the process that calls it, and ends it: with 0 where `holds` does then.
[[noreturn]] void confined(const std::function<bool()>& holds) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) ::_exit(3);
    const std::string reason = confine_this_process(ends[1]);
    std::fputs(reason.c_str(), stderr);
    ::_exit(!reason.empty() ? 2 : holds() ? 0 : 1);
}

bool refused(long result) { return result < 0 && errno == EACCES; }

TEST(Confinement, OpensFilesToReadOnly) {
    const TemporaryFolder folder;
    const std::string file = folder.write("file", "text"), other = folder / "other";
    const auto holds = [&] {
        const char *name = file.c_str(), *to = other.c_str();
#ifdef SYS_open  // which the C library does not call
        if (::syscall(SYS_open, name, O_RDONLY) < 0 ||
            !refused(::syscall(SYS_open, name, O_WRONLY, 0)))
            return false;
#endif
        return ::open(name, O_RDONLY) >= 0 && refused(::open(name, O_WRONLY)) &&
               refused(::open(name, O_RDWR)) && refused(::open(name, O_RDONLY | O_TRUNC)) &&
               refused(::open(to, O_WRONLY | O_CREAT, 0600)) &&
               refused(::open(to, O_RDONLY | O_CREAT, 0600)) && refused(::unlink(name)) &&
               refused(::rename(name, to)) && refused(::truncate(name, 0)) &&
               refused(::link(name, to)) && refused(::symlink(name, to)) &&
               refused(::mkdir(to, 0700)) && refused(::mkfifo(to, 0600)) &&
               refused(::chmod(name, 0777)) && refused(::lchown(name, 1, 1)) &&
               refused(::utimensat(AT_FDCWD, name, nullptr, 0)) &&
               refused(::open(folder.path.c_str(), O_TMPFILE | O_RDWR, 0600));
    };
    EXPECT_EXIT(confined(holds), testing::ExitedWithCode(0), "");
}

TEST(Confinement, ReachesNoNetworkAndNoOtherProgramOrProcess) {
    const auto holds = [] {
        char* const arguments[] = {nullptr};
        const pid_t other = ::getppid();
        rlimit limits{};
        if (!refused(::kill(other, 0)) || !refused(::setsid()) || !refused(::setpgid(0, 0)) ||
            !refused(::syscall(SYS_tgkill, other, other, 0)) ||
            !refused(::syscall(SYS_pidfd_open, other, 0)) ||
            !refused(::ioctl(STDIN_FILENO, TIOCSTI, "x")) ||
            !refused(::syscall(SYS_process_vm_writev, other, nullptr, 0, nullptr, 0, 0)) ||
            !refused(::syscall(SYS_memfd_create, "x", 0)) || !refused(::unshare(CLONE_NEWUSER)) ||
            !refused(::prlimit(other, RLIMIT_NOFILE, nullptr, &limits)) ||
            ::prlimit(0, RLIMIT_NOFILE, nullptr, &limits) != 0)
            return false;
        return refused(::socket(AF_INET, SOCK_STREAM, 0)) &&
               refused(::socket(AF_UNIX, SOCK_STREAM, 0)) &&
               refused(::execve("/bin/true", arguments, arguments));
    };
    EXPECT_EXIT(confined(holds), testing::ExitedWithCode(0), "");
}

rlim_t soft_limit(__rlimit_resource_t resource) {
    rlimit limits{};
    ::getrlimit(resource, &limits);
    return limits.rlim_cur;
}

TEST(Confinement, HasTimeAndMemoryByTheBytesThatItReads) {
    constexpr rlim_t slowness = unless_sanitized<rlim_t>(1, 20);
    const auto holds = [&] {
        constexpr std::uint64_t mebi = std::uint64_t{1} << 20;
        const auto has = [&](rlim_t seconds, rlim_t bytes) {
            return soft_limit(RLIMIT_CPU) == std::min<rlim_t>(slowness * seconds, 300) &&
                   (slowness > 1 || (address_space().bytes == bytes && !address_space().inherited));
        };
        bool all = has(8, 1536 * mebi);
        allow_for(4'000'000);
        allow_for(6'000'000);
        all = all && has(28, 1536 * mebi + 640'000'000);
        allow_for(UINT64_MAX);
        return all && has(300, 12 * 1024 * mebi) && soft_limit(RLIMIT_CORE) == 0 &&
               soft_limit(RLIMIT_FSIZE) == 0 && soft_limit(RLIMIT_NOFILE) <= 32;
    };
    EXPECT_EXIT(confined(holds), testing::ExitedWithCode(0), "");
}

TEST(Confinement, KnowsALimitOfMemoryFromOutside) {
#ifdef SCB_SANITIZED
    GTEST_SKIP() << "sanitized, there is no limit of memory";
#endif
    constexpr rlim_t gibi = rlim_t{1} << 30;
    const auto limited = [] {
        rlimit limits{};
        ::getrlimit(RLIMIT_AS, &limits);
        limits.rlim_cur = gibi;
        ::setrlimit(RLIMIT_AS, &limits);
        confined([] {
            const AddressSpace space = address_space();
            return space.inherited && space.bytes == gibi;
        });
    };
    EXPECT_EXIT(limited(), testing::ExitedWithCode(0), "");
}

TEST(Confinement, EndsAfterFiveMinutes) {
    const auto holds = [] {
        const unsigned left = ::alarm(0);
        return left > 0 && left <= reader_patience;
    };
    EXPECT_EXIT(confined(holds), testing::ExitedWithCode(0), "");
}

TEST(Confinement, EndsWithWhoeverStartedIt) {
    const auto holds = [] {
        int signal = 0;
        return ::prctl(PR_GET_PDEATHSIG, &signal) == 0 && signal == SIGKILL;
    };
    EXPECT_EXIT(confined(holds), testing::ExitedWithCode(0), "");
    const auto alone = [] {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0) ::_exit(3);
        ::close(ends[0]);
        ::_exit(confine_this_process(ends[1]) == "nobody waits for it" ? 0 : 1);
    };
    EXPECT_EXIT(alone(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace scb::scenes
