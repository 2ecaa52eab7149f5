#include "app/console.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "render/image_file.h"

namespace scb {
namespace {

bool colored(ColorMode mode) {
    return mode == ColorMode::always ||
           (mode == ColorMode::automatic && isatty(STDERR_FILENO) != 0);
}

}  // namespace

void Console::error(std::string_view text) const {
    // Names from outside may hold anything; a message is one line and does not steer the terminal.
    std::string sentence(text);
    for (char& c : sentence)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    const bool red = colored(color);
    std::fprintf(stderr, "%sscb: error:%s %.*s\n", red ? "\033[1;31m" : "", red ? "\033[0m" : "",
                 static_cast<int>(sentence.size()), sentence.data());
}

void Console::note(std::string_view line) const {
    if (!quiet) std::fprintf(stderr, "%.*s\n", static_cast<int>(line.size()), line.data());
}

void Console::progress(std::string_view what, std::size_t done, std::size_t total) const {
    if (quiet || isatty(STDERR_FILENO) == 0) return;
    constexpr int width = 30;
    const int filled = total == 0 ? width : static_cast<int>(width * done / total);
    std::fprintf(stderr, "\r[%.*s%*s] %zu/%zu %.*s\033[K%s", filled,
                 "##############################", width - filled, "", done, total,
                 static_cast<int>(what.size()), what.data(), done == total ? "\n" : "");
}

void print_result(std::string_view text) {
    errno = 0;
    const bool written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (written) return;
    throw OutputError(std::string("cannot write to standard output: ") + std::strerror(errno) +
                      "; make room there, or send it elsewhere.");
}

}  // namespace scb
