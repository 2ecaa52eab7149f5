#include "app/cli/console.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "render/files/output_file.h"
#include "scenes/text/utf8.h"

namespace scb::app {
namespace {

bool colored(ColorMode mode, int file) {
    return mode == ColorMode::always || (mode == ColorMode::automatic && isatty(file) != 0);
}

}  // namespace

bool Console::colors_results() const { return colored(color, STDOUT_FILENO); }

void Console::error(std::string_view text) const {
    const std::string sentence = scenes::printable(std::string(text));
    const bool red = colored(color, STDERR_FILENO);
    std::fprintf(stderr, "%sscb: error:%s %.*s\n", red ? "\033[1;31m" : "", red ? "\033[0m" : "",
                 static_cast<int>(sentence.size()), sentence.data());
}

void Console::alarm(std::string_view line) const {
    const bool red = colored(color, STDERR_FILENO);
    std::fprintf(stderr, "%s%s%s\n", red ? "\033[1;31m" : "",
                 scenes::printable(std::string(line)).c_str(), red ? "\033[0m" : "");
}

void Console::note(std::string_view line) const {
    if (!quiet) std::fprintf(stderr, "%s\n", scenes::printable(std::string(line)).c_str());
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
    throw render::OutputError(std::string("cannot write to standard output: ") +
                              std::strerror(errno) + "; send it elsewhere.");
}

}  // namespace scb::app
