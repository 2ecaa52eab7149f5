#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/temporary_folder.h"

namespace scb::app {

/// What a run of the program gave.
struct ProgramRun {
    int status = 0;  ///< exit status; 128 + the signal where one ended it
    std::string out;
    std::string err;
};

/// Runs `scb ARGUMENTS` through the shell, without a terminal or SCB_MODELS. `prefix` stands before
/// the program: an environment, a limit.
ProgramRun run_scb(const std::string& arguments, const std::string& prefix = "");

/// A prefix for a run that gets a signal once it has begun to give results: after a time that is
/// enough for that on a busy machine, with sanitizers too.
inline std::string interrupted_by(const std::string& signal) {
#ifdef SCB_SANITIZED
    return "timeout --preserve-status -s " + signal + " 8";
#else
    return "timeout --preserve-status -s " + signal + " 3";
#endif
}
/// As by Ctrl-C.
inline const std::string interrupted = interrupted_by("INT");

/// The whole file, as bytes.
std::string file_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

std::vector<std::string> lines(const std::string& text);
std::size_t lines_of(const std::string& text);
std::size_t files_in(const std::filesystem::path& folder);

/// A scene file of two spheres, "left" and "right", that meet a little in each of its 1,000,000
/// frames: far more than a test waits for.
extern const char* const endless_scene;

}  // namespace scb::app
