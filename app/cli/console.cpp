#include "app/cli/console.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/platform/output_file.h"
#include "core/platform/utf8.h"

namespace scb::app {
namespace {

/// The text with "./" before each line that GitHub Actions would take for a command. GitHub Actions
/// ignores blanks before a command, including those of Unicode, and a carriage return ends a line.
std::string without_commands(std::string_view text) {
    std::string plain;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find_first_of("\r\n") + 1);
        const std::string_view whole = line.empty() ? text : line;
        const auto is_blank = [](char c) {
            return c == ' ' || (c >= '\t' && c <= '\r') || static_cast<unsigned char>(c) >= 0x80;
        };
        const auto word = std::find_if_not(whole.begin(), whole.end(), is_blank);
        if (std::string_view(word, whole.end()).starts_with("::")) plain += "./";
        plain += whole;
        text.remove_prefix(whole.size());
    }
    return plain;
}

/// Text from outside, as a part of one line.
std::string one_line(std::string_view text) {
    return without_commands(printable(std::string(text)));
}

void print(std::string_view text) {
    errno = 0;
    const bool written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (written) return;
    throw OutputError(std::string("cannot write to standard output: ") + std::strerror(errno) +
                      "; send it elsewhere.");
}

bool colored(ColorMode mode, int file) {
    return mode == ColorMode::always || (mode == ColorMode::automatic && isatty(file) != 0);
}

}  // namespace

bool Console::colors_results() const { return colored(color, STDOUT_FILENO); }

void Console::error(std::string_view text) const {
    const std::string sentence = printable(std::string(text));
    const bool red = colored(color, STDERR_FILENO);
    std::fprintf(stderr, "%sscb: error:%s %.*s\n", red ? "\033[1;31m" : "", red ? "\033[0m" : "",
                 static_cast<int>(sentence.size()), sentence.data());
}

void Console::alarm(std::string_view line) const {
    const bool red = colored(color, STDERR_FILENO);
    std::fprintf(stderr, "%s%s%s\n", red ? "\033[1;31m" : "", one_line(line).c_str(),
                 red ? "\033[0m" : "");
}

void Console::note(std::string_view line) const {
    if (!quiet) std::fprintf(stderr, "%s\n", one_line(line).c_str());
}

std::function<void(const std::string&)> Console::notes() const {
    return [to = *this](const std::string& line) { to.note(line); };
}

void Console::progress(std::string_view what, std::size_t done, std::size_t total) const {
    if (quiet || isatty(STDERR_FILENO) == 0) return;
    constexpr int width = 30;
    const int filled = total == 0 ? width : static_cast<int>(width * done / total);
    std::fprintf(stderr, "\r[%.*s%*s] %zu/%zu %.*s\033[K%s", filled,
                 "##############################", width - filled, "", done, total,
                 static_cast<int>(what.size()), what.data(), done == total ? "\n" : "");
}

void print_result(std::string_view text) { print(without_commands(text)); }

void print_github_commands(std::string_view lines) { print(lines); }

}  // namespace scb::app
