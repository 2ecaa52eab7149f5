#include "golden/run/command_worker.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>

#include "core/platform/input_files.h"
#include "golden/run/run_case.h"

namespace scb::golden {
namespace {

using Clock = std::chrono::steady_clock;

// A command is sent as the number of its bytes and then its words, each with a zero behind it. The
// answer is the exit status.
using Length = std::uint32_t;
using Status = std::int32_t;

bool read_whole(int file, std::span<char> bytes) {
    while (!bytes.empty()) {
        const ssize_t got = ::read(file, bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

/// False if there is no further command.
bool read_command(int file, std::vector<std::string>& words) {
    Length length = 0;
    if (!read_whole(file, {reinterpret_cast<char*>(&length), sizeof length})) return false;
    std::string text(length, '\0');
    if (!read_whole(file, text)) return false;
    words.clear();
    for (std::size_t at = 0; at < text.size(); at += words.back().size() + 1)
        words.emplace_back(text.c_str() + at);
    return true;
}

std::vector<std::uint8_t> command_bytes(const std::vector<std::string>& words) {
    std::vector<std::uint8_t> bytes(sizeof(Length));
    for (const std::string& word : words)
        bytes.insert(bytes.end(), word.c_str(), word.c_str() + word.size() + 1);
    const auto length = static_cast<Length>(bytes.size() - sizeof(Length));
    std::memcpy(bytes.data(), &length, sizeof length);
    return bytes;
}

}  // namespace

int run_commands(const std::function<int(const std::vector<std::string>&)>& run) {
    // After the descriptors that the command uses.
    const int socket = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 2),
              nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    ::dup2(nothing, STDIN_FILENO);
    std::vector<std::string> words;
    while (read_command(socket, words)) {
        forget_inputs();
        const Status status = run(words);
        std::fflush(nullptr);
        if (::send(socket, &status, sizeof status, MSG_NOSIGNAL) < 0) break;
    }
    return 0;
}

CommandWorker::CommandWorker(const GoldenRunSettings& settings)
    : child_({settings.program, worker_command}, inputs_, std::chrono::seconds(1), settings.folder),
      group_(settings.work, child_.id()) {}

CommandEnd CommandWorker::run(const GoldenRunSettings& settings,
                              const std::vector<std::string>& words) {
    user_ = std::this_thread::get_id();
    inputs_.clear();
    child_.forget_printed();
    const Clock::time_point end = Clock::now() + settings.patience;
    const auto is_over = [&] { return Clock::now() >= end || settings.stopped(); };
    CommandEnd result;
    Status status = 0;
    const bool answered =
        child_.write(command_bytes(words)) &&
        child_.read({reinterpret_cast<std::uint8_t*>(&status), sizeof status}, is_over);
    if (answered)
        result.end = {false, status};
    else
        result.end = child_.wait(
            std::max(std::chrono::milliseconds(0),
                     std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now())),
            settings.stopped);
    result.stopped = !result.end && settings.stopped();
    result.printed = child_.printed();
    result.last_line = child_.last_line();
    note_inputs_of(inputs_);
    return result;
}

}  // namespace scb::golden
