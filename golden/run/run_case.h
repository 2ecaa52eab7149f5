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
    bool of_pictures = false;          ///< only commands that draw understand them
};

/// How cases are run.
struct GoldenRunSettings {
    std::string program;                ///< this one
    std::vector<std::string> runner{};  ///< what the program is run with: an emulator, say
    std::string folder;                 ///< of the suite, where cases run, whatever this one is
    std::string models;                 ///< --models, from wherever; empty: none
    std::string gl;                     ///< --gl
    RunMutation mutation{};             ///< of the runs
    std::chrono::seconds patience{300};
    const GoldenWork* work = nullptr;  ///< is told of the processes that run, if there is one
    /// Processes that run commands where there is no runner; they must end before `work` does.
    std::shared_ptr<CommandWorkers> workers = std::make_shared<CommandWorkers>();
    /// Asked while a case runs; where it says true, that is ended.
    std::function<bool()> stopped = [] { return false; };
};

/// How a run of a case ended.
struct GoldenRunEnd {
    bool ran = false;
    bool skipped = false;    ///< a mesh file that the scene needs is not here
    bool lacked_gl = false;  ///< there is no OpenGL context
    bool stopped = false;    ///< it was ended before its time, see GoldenRunSettings
    std::string message;     ///< why it did not run: a sentence
    double seconds = 0;
};

/// Runs the case in another process, with one thread, and leaves what it made in `folder`,
/// named as baselines are; its index.json as NAME.index.json. The folder must be there. A case that
/// draws more than one picture has not run.
GoldenRunEnd run_case(const GoldenCase& golden, const GoldenRunSettings& settings,
                      const std::filesystem::path& folder);

/// Records the trace of the case's query as NAME.scbtrace in `folder`, where run_case has left its
/// counts. Nothing where these are of no query, or of more frames than one, whose traces are too
/// large to be kept. Returns why it could not be recorded, a sentence; else nothing.
std::string record_trace(const GoldenCase& golden, const GoldenRunSettings& settings,
                         const std::filesystem::path& folder);

/// The command line of a case as a user would type it.
std::string typed(const std::vector<std::string>& command);
/// The command that makes the case's recording, and "&&" behind it; empty where there is none.
std::string typed_maker(const GoldenCase& golden);
/// The same of the case whose files go to that folder, behind the command that makes its recording,
/// if there is one.
std::string typed(const GoldenCase& golden, const std::filesystem::path& folder);

}  // namespace scb::golden
