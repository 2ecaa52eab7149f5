#include "tests/app/program.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <wordexp.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "app/program.h"
#include "core/platform/input_files.h"
#include "core/platform/output_file.h"

namespace scb::app {

std::string file_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    write_file_whole(path, text);
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

struct Descriptor {
    int number;

    explicit Descriptor(int opened) : number(opened) {
        if (number < 0) throw std::system_error(errno, std::generic_category());
    }
    ~Descriptor() { ::close(number); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
};

/// While it exists, a descriptor of this process is another open file.
class ReplacedDescriptor {
  public:
    ReplacedDescriptor(int number, int file)
        : number_(number), before_(::fcntl(number, F_DUPFD_CLOEXEC, 0)) {
        ::dup2(file, number_);
    }
    ~ReplacedDescriptor() { ::dup2(before_.number, number_); }

  private:
    int number_;
    Descriptor before_;
};

/// While it exists, text printed to a standard stream goes to a file without a name.
class CapturedStream {
  public:
    explicit CapturedStream(FILE* stream)
        : stream_(flushed(stream)),
          file_(::memfd_create("printed", MFD_CLOEXEC)),
          replaced_(::fileno(stream), file_.number) {}
    ~CapturedStream() { std::fflush(stream_); }

    std::string text() const {
        std::fflush(stream_);
        std::string bytes(static_cast<std::size_t>(::lseek(file_.number, 0, SEEK_END)), '\0');
        const ssize_t got = ::pread(file_.number, bytes.data(), bytes.size(), 0);
        bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        return bytes;
    }

  private:
    static FILE* flushed(FILE* stream) {
        std::fflush(stream);
        return stream;
    }

    FILE* stream_;
    Descriptor file_;
    ReplacedDescriptor replaced_;
};

/// Sets or removes a variable as the word says; returns the word that undoes it.
std::string changed(const std::string& word) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const char* const value = std::getenv(name.c_str());
    const std::string before = value == nullptr ? name : name + "=" + value;
    if (equals == std::string::npos)
        ::unsetenv(name.c_str());
    else
        ::setenv(name.c_str(), word.c_str() + equals + 1, 1);
    return before;
}

/// Sets the environment of a run, and restores the former one at its end.
class ChangedEnvironment {
  public:
    explicit ChangedEnvironment(const std::vector<std::string>& words) {
        for (const char* word : {"SCB_MODELS", "CI", "XDG_CONFIG_HOME=/dev/null"})
            undo_.push_back(changed(word));
        for (const std::string& word : words) undo_.push_back(changed(word));
    }
    ~ChangedEnvironment() {
        for (auto word = undo_.rbegin(); word != undo_.rend(); ++word) changed(*word);
    }
    ChangedEnvironment(const ChangedEnvironment&) = delete;
    ChangedEnvironment& operator=(const ChangedEnvironment&) = delete;

  private:
    std::vector<std::string> undo_;
};

/// While it exists, this process works in another folder.
class ChangedFolder {
  public:
    explicit ChangedFolder(const std::string& folder) : before_(std::filesystem::current_path()) {
        if (!folder.empty()) std::filesystem::current_path(folder);
    }
    ~ChangedFolder() {
        std::error_code ignored;
        std::filesystem::current_path(before_, ignored);
    }
    ChangedFolder(const ChangedFolder&) = delete;
    ChangedFolder& operator=(const ChangedFolder&) = delete;

  private:
    std::filesystem::path before_;
};

std::vector<std::string> words_of(const std::string& arguments) {
    wordexp_t expanded{};
    if (::wordexp(arguments.c_str(), &expanded, WRDE_NOCMD) != 0)
        throw std::invalid_argument("These are not words alone: " + arguments);
    std::vector<std::string> words(expanded.we_wordv, expanded.we_wordv + expanded.we_wordc);
    ::wordfree(&expanded);
    return words;
}

struct RunFiles {
    TemporaryFolder folder;

    std::string command(const std::string& arguments, const std::string& prefix) const {
        return "unset SCB_MODELS CI; export XDG_CONFIG_HOME=/dev/null; " + prefix +
               " " SCB_PROGRAM " " + arguments + " >" + (folder / "out") + " 2>" +
               (folder / "err") + " </dev/null";
    }
    ProgramRun result(int status) const {
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                file_text(folder / "out"), file_text(folder / "err")};
    }
};

}  // namespace

ProgramRun run_scb(const std::string& arguments, const Surroundings& surroundings) {
    // Two threads would leave each other's streams behind.
    static std::mutex running;
    const std::unique_lock alone(running, std::try_to_lock);
    if (!alone) throw std::logic_error("run_scb is for one thread; others start processes");
    const std::vector<std::string> words = words_of(arguments);
    const ChangedEnvironment environment(surroundings.environment);
    const ChangedFolder folder(surroundings.folder);
    forget_inputs();
    ProgramRun run;
    CapturedStream out(stdout), err(stderr);
    const Descriptor nothing(::open("/dev/null", O_RDONLY));
    const ReplacedDescriptor in(STDIN_FILENO, nothing.number);
    Watch watch;
    run.status = run_program(words, watch);
    run.out = out.text();
    run.err = err.text();
    return run;
}

ProgramRun run_scb_process(const std::string& arguments, const std::string& prefix) {
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
