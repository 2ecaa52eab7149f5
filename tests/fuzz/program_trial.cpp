#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "tests/temporary_folder.h"

// Runs the program on files that were changed by chance, and holds it to what it promises of every
// input: status 0 or 2 (1 where a test fails), a refusal in one sentence that names the file, less
// than 2 GB and 10 seconds, and no output where it refuses. Prints what does not hold, and keeps
// the file. SEED starts the generator; FILE is what the program reads; OUT, where ARGUMENTS have
// it, is a folder that is not there; ORIGINAL are what is changed.
//
//     program_trial PROGRAM RUNS SEED FOUND FILE ARGUMENTS ORIGINAL...

namespace {

namespace fs = std::filesystem;
using scb::Random;

std::string read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string mutated(Random& random, std::string bytes, const std::string& other) {
    const auto below = [&](std::size_t bound) {
        return bound == 0 ? 0 : static_cast<std::size_t>(random.next() % bound);
    };
    const char* const numbers[] = {"-1",  "0",      "4294967295", "1e308", "-1e308", "nan",
                                   "inf", "1e-320", "2147483648", "65536", "0x10",   "\"\""};
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
        const std::size_t at = below(bytes.size() + 1), size = 1 + below(16);
        switch (below(12)) {
            case 0:
                if (at < bytes.size()) bytes[at] = static_cast<char>(random.next());
                break;
            case 1:
                if (at < bytes.size()) bytes[at] = static_cast<char>(bytes[at] ^ 1 << below(8));
                break;
            case 2:
                bytes.erase(std::min(at, bytes.size()), size);
                break;
            case 3:
                bytes.insert(std::min(at, bytes.size()),
                             bytes.substr(below(bytes.size() + 1), size));
                break;
            case 4:
                bytes.resize(at);
                break;
            case 5: {
                const std::size_t from = below(other.size() + 1);
                bytes.insert(std::min(at, bytes.size()), other.substr(from, below(64)));
                break;
            }
            default: {
                // A number becomes another one.
                const std::size_t start = bytes.find_first_of("0123456789", at);
                if (start == bytes.npos) break;
                const std::size_t end = bytes.find_first_not_of("0123456789.eE+-", start);
                bytes.replace(start, (end == bytes.npos ? bytes.size() : end) - start,
                              numbers[below(std::size(numbers))]);
            }
        }
    }
    return bytes;
}

/// Gives a trace the checksum that its bytes ask for, which chance does not find.
void mend_checksum(std::string& trace) {
    constexpr std::size_t size = 4;
    if (!trace.starts_with("\x89scbtr") || trace.size() < size) return;
    const auto* bytes = reinterpret_cast<const unsigned char*>(trace.data());
    const uLong sum = ::crc32_z(0, bytes, trace.size() - size);
    for (std::size_t i = 0; i < size; ++i)
        trace[trace.size() - size + i] = static_cast<char>(sum >> (8 * i));
}

struct Run {
    int status = 0;
    double seconds = 0;
    long kilobytes = 0;
    std::string out, err;
};

volatile pid_t running = -1;
constexpr unsigned patience = 30;  // seconds

void end_running(int) { ::kill(running, SIGKILL); }

Run run(const std::string& program, const std::string& arguments, const fs::path& folder) {
    std::vector<std::string> words = {program};
    for (std::size_t at = 0; at < arguments.size();) {
        const std::size_t end = std::min(arguments.find(' ', at), arguments.size());
        words.push_back(arguments.substr(at, end - at));
        at = end + 1;
    }
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string out = folder / "printed", err = folder / "errors";
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), flags, 0600);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), flags, 0600);
    const auto start = std::chrono::steady_clock::now();
    pid_t child = -1;
    Run result;
    if (::posix_spawn(&child, program.c_str(), &files, nullptr, pointers.data(), environ) != 0) {
        std::perror(program.c_str());
        std::exit(3);
    }
    posix_spawn_file_actions_destroy(&files);
    int status = 0;
    rusage usage{};
    running = child;
    ::alarm(patience);
    while (::wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    ::alarm(0);
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.kilobytes = usage.ru_maxrss;
    result.out = read_file(out);
    result.err = read_file(err);
    return result;
}

std::string broken_promise(const Run& run, const std::string& file, bool left_output) {
    if (run.seconds > 10) return "it took " + std::to_string(run.seconds) + " s";
    if (run.kilobytes > 2'000'000) return "it took " + std::to_string(run.kilobytes) + " KB";
    if (run.status == 0 || run.status == 1) return "";
    if (run.status != 2) return "it ended with status " + std::to_string(run.status);
    const auto lines = std::count(run.err.begin(), run.err.end(), '\n');
    if (lines != 1 || !run.err.ends_with(".\n")) return "its refusal is not one sentence";
    if (run.err.find(file) == run.err.npos) return "its refusal does not name the file";
    if (run.err.size() > 2000) return "its refusal is long";
    if (!run.out.empty()) return "it printed something besides";
    if (left_output) return "it left output";
    return "";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 8) {
        std::fprintf(stderr,
                     "usage: program_trial PROGRAM RUNS SEED FOUND FILE ARGUMENTS ORIGINAL...\n");
        return 2;
    }
    const std::string program = argv[1], file = argv[5];
    const int runs = std::atoi(argv[2]);
    Random random(static_cast<std::uint64_t>(std::atoll(argv[3])));
    const fs::path found = argv[4];
    const scb::TemporaryFolder folder;
    const std::string out = folder / "out";
    std::string arguments = argv[6];
    if (const std::size_t at = arguments.find("OUT"); at != arguments.npos)
        arguments.replace(at, 3, out);
    std::vector<std::string> originals;
    for (int i = 7; i < argc; ++i) originals.push_back(read_file(argv[i]));
    std::signal(SIGALRM, end_running);
    std::map<int, int> statuses;
    int broken = 0;
    double slowest = 0;
    long largest = 0;
    for (int i = 0; i < runs; ++i) {
        const std::string& original = originals[random.next() % originals.size()];
        const std::string& other = originals[random.next() % originals.size()];
        std::string bytes = mutated(random, original, other);
        if (random.next() % 4 != 0) mend_checksum(bytes);
        std::ofstream(file, std::ios::binary) << bytes;
        const Run result = run(program, arguments, folder.path);
        const std::string promise = broken_promise(result, file, fs::exists(out));
        fs::remove_all(out);
        ++statuses[result.status];
        slowest = std::max(slowest, result.seconds);
        largest = std::max(largest, result.kilobytes);
        if (promise.empty()) continue;
        ++broken;
        fs::create_directories(found);
        const fs::path kept = found / (std::to_string(i) + fs::path(file).extension().string());
        fs::copy_file(file, kept, fs::copy_options::overwrite_existing);
        std::printf("%s: %s: %s\n", kept.c_str(), promise.c_str(),
                    result.err.substr(0, 300).c_str());
    }
    std::printf("%d runs, %d broke a promise; status", runs, broken);
    for (const auto& [status, count] : statuses) std::printf(" %d: %d", status, count);
    std::printf("; at most %.1f s and %ld MB\n", slowest, largest / 1000);
    return broken == 0 ? 0 : 1;
}
