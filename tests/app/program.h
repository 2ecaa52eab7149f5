#pragma once

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <functional>
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

/// Working folder of a run, and the environment variables that differ from the tests' own.
struct Surroundings {
    std::string folder{};                    ///< working folder; empty: the tests' own
    std::vector<std::string> environment{};  ///< "NAME=value" sets a variable, "NAME" removes it
};

/// Runs `scb ARGUMENTS` in this process, without a terminal, SCB_MODELS and CI. The words of the
/// arguments are split, quoted and expanded as a shell does.
ProgramRun run_scb(const std::string& arguments, const Surroundings& surroundings = {});

/// Runs `scb ARGUMENTS` in a process of its own, through the shell, without a terminal, SCB_MODELS
/// and CI: for tests of limits, closed descriptors, or how a process ends. `prefix` stands before
/// the program: a limit, an emulator.
ProgramRun run_scb_process(const std::string& arguments, const std::string& prefix = "");

/// The same, with `signal` once `ready` is true of the process, or after two minutes. The process
/// is killed if the signal has not ended it after another minute. `prefix` is a program with its
/// arguments.
ProgramRun run_scb_interrupted(const std::string& arguments,
                               const std::function<bool(pid_t)>& ready, int signal = SIGINT,
                               const std::string& prefix = "");

/// Whether a process has computed for two seconds: far longer than it takes to begin.
bool has_computed(pid_t process);

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
