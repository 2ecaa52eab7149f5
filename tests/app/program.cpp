#include "tests/app/program.h"

#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include "render/files/output_file.h"

namespace scb::app {

std::string file_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    render::write_file_whole(path, text);
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
}

std::size_t lines_of(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::size_t files_in(const std::filesystem::path& folder) {
    using Entries = std::filesystem::directory_iterator;
    return static_cast<std::size_t>(std::distance(Entries(folder), Entries()));
}

namespace {

struct RunFiles {
    TemporaryFolder folder;

    std::string command(const std::string& arguments, const std::string& prefix) const {
        // What else than its arguments changes what a command does.
        return "unset SCB_MODELS CI; export XDG_CONFIG_HOME=/nowhere; " + prefix +
               " " SCB_PROGRAM " " + arguments + " >" + (folder / "out") + " 2>" +
               (folder / "err") + " </dev/null";
    }
    ProgramRun result(int status) const {
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                file_text(folder / "out"), file_text(folder / "err")};
    }
};

}  // namespace

ProgramRun run_scb(const std::string& arguments, const std::string& prefix) {
    const RunFiles files;
    return files.result(std::system(files.command(arguments, prefix).c_str()));
}

ProgramRun run_scb_interrupted(const std::string& arguments,
                               const std::function<bool(pid_t)>& ready, int signal,
                               const std::string& prefix) {
    const RunFiles files;
    const std::string command = files.command(arguments, "exec " + prefix);
    const pid_t process = ::fork();
    if (process == 0) {
        ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        ::_exit(127);
    }
    int status = 0;
    const auto ends_within = [&](std::chrono::minutes time, const auto& stop) {
        for (const auto end = std::chrono::steady_clock::now() + time;
             std::chrono::steady_clock::now() < end && !stop();
             std::this_thread::sleep_for(std::chrono::milliseconds(20)))
            if (::waitpid(process, &status, WNOHANG) == process) return true;
        return false;
    };
    bool ended = ends_within(std::chrono::minutes(2), [&] { return ready(process); });
    for (const int last : {signal, SIGKILL}) {
        if (ended) break;
        ::kill(process, last);
        ended = ends_within(std::chrono::minutes(1), [] { return false; });
    }
    return files.result(status);
}

bool has_computed(pid_t process) {
    clockid_t clock{};
    timespec time{};
    return ::clock_getcpuclockid(process, &clock) == 0 && ::clock_gettime(clock, &time) == 0 &&
           time.tv_sec >= 2;
}

const char* const endless_scene = R"({
  "scb_scene": 1, "name": "endless", "frames": 1000000,
  "models": [{"name": "m", "icosphere": {"subdivisions": 3, "radius": 1}}],
  "bodies": [{"name": "left", "model": "m"},
             {"name": "right", "model": "m", "position": [1.98, 0, 0]}]
})";

}  // namespace scb::app
