#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "golden/run/command_workers.h"
#include "golden/run/work_folder.h"
#include "golden/suite/case_command.h"
#include "golden/suite/suite.h"

namespace scb::golden {

/// Words of the command line that put an error into a run, see `scb golden selftest`.
struct RunMutation {
    std::vector<std::string> words{};  ///< empty: no error
    bool of_pictures = false;          ///< only commands that draw accept them
};

/// The settings of runs of cases.
struct GoldenRunSettings {
    std::string program;                ///< this program
    std::vector<std::string> runner{};  ///< the command that runs the program, such as an emulator
    std::string folder;                 ///< the folder of the suite, where cases run
    std::string models;                 ///< --models, as a path that is valid anywhere; empty: none
    std::string gl;                     ///< --gl
    RunMutation mutation{};             ///< of the runs
    std::chrono::seconds patience{300};
    const GoldenWork* work = nullptr;  ///< receives the running processes; may be null
    /// Processes that run commands if there is no runner; they must end before `work` does.
    std::shared_ptr<CommandWorkers> workers = std::make_shared<CommandWorkers>();
    /// Polled while a case runs; if it returns true, the case is ended.
    std::function<bool()> stopped = [] { return false; };
};

/// How a run of a case ended.
struct GoldenRunEnd {
    bool ran = false;
    bool skipped = false;    ///< a mesh file that the scene needs is not here
    bool lacked_gl = false;  ///< there is no OpenGL context
    bool stopped = false;    ///< it was ended early, see GoldenRunSettings
    std::string message;     ///< why it did not run: a sentence
    double seconds = 0;
};

/// Runs the case in another process, with one thread, and leaves its files in `folder`, named like
/// baselines; its index.json as NAME.index.json. The folder must exist. A case that draws more than
/// one picture counts as not run.
GoldenRunEnd run_case(const GoldenCase& golden, const GoldenRunSettings& settings,
                      const std::filesystem::path& folder);

/// Records the trace of the case's query as NAME.trace.scbrec in `folder`, where run_case has left
/// its counts. Does nothing if the counts are not of a query, or of several frames, whose traces
/// are too large to keep. Returns why it could not be recorded, a sentence; else nothing.
std::string record_trace(const GoldenCase& golden, const GoldenRunSettings& settings,
                         const std::filesystem::path& folder);

/// The command line of a case as a user would type it.
std::string typed(const std::vector<std::string>& command);
/// The command that makes the case's recording, and "&&" behind it; empty if there is none.
std::string typed_maker(const GoldenCase& golden);
/// The same for a case with its files in this folder, behind the command that makes its recording,
/// if there is one.
std::string typed(const GoldenCase& golden, const std::filesystem::path& folder);

}  // namespace scb::golden
