#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace scb::app {

/// Results go to standard output, messages and progress to standard error.
enum class ColorMode { automatic, always, never };

struct Console {
    ColorMode color = ColorMode::automatic;
    bool quiet = false;  ///< no notes and no progress; errors always

    /// Whether results on standard output have colors.
    bool colors_results() const;
    /// "scb: error: SENTENCE" on standard error.
    void error(std::string_view sentence) const;
    /// A line on standard error that must be seen, even with --quiet.
    void alarm(std::string_view line) const;
    /// A line on standard error.
    void note(std::string_view line) const;
    /// note() as a function, for code that knows no console.
    std::function<void(const std::string&)> notes() const;
    /// Progress on one line that overwrites itself; only on a terminal. `done == total` ends the
    /// line.
    void progress(std::string_view what, std::size_t done, std::size_t total) const;
};

/// Writes a result to standard output and flushes it; throws OutputError if that fails (a closed
/// pipe, a full disk). A name from outside may begin with "::", which GitHub Actions takes for a
/// command. Such a line gets "./" before it; a path keeps its meaning.
void print_result(std::string_view text);
/// The same for lines that are commands to GitHub Actions.
void print_github_commands(std::string_view lines);

}  // namespace scb::app
