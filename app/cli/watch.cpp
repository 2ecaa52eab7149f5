#include "app/cli/watch.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <thread>

#include "core/platform/input_files.h"

namespace scb::app {

void run_again_after_change(const Watch& watch, char** words) {
    const auto read = input_versions();
    if (read.empty()) {
        std::fputs("scb: --watch: nothing is waited for, as no file was read.\n", stderr);
        return;
    }
    if (!watch.quiet)
        std::fprintf(stderr, "scb: waiting for a change of %zu %s; Ctrl-C ends.\n", read.size(),
                     read.size() == 1 ? "file" : "files");
    constexpr auto pause = std::chrono::milliseconds(200);
    auto now = present_versions(read);
    // Wait until the file no longer changes: its writer has finished.
    for (auto before = now; now == read || now != before; now = present_versions(read)) {
        before = now;
        std::this_thread::sleep_for(pause);
    }
    ::execv("/proc/self/exe", words);
    std::perror("scb: --watch: the program cannot be started again");
}

}  // namespace scb::app
