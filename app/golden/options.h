#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "golden/run/run_case.h"

namespace scb::app {

/// Options of every command of `scb golden` that runs cases.
struct GoldenOptions {
    std::string suite = "golden/cases.json", baselines;
    std::vector<std::string> names;
    std::string models, gl, runner;
    int jobs = 0;

    /// Refuses invalid options; throws InputError.
    void check() const;
    /// The folder of baselines; by default beside the suite.
    std::filesystem::path baselines_folder() const;
    /// The named cases, in the order of the suite; all cases if none is named. Their files are
    /// looked up beside the suite, then in the folder of models. Throws InputError if the suite has
    /// no case of a name.
    std::vector<golden::GoldenCase> chosen(const golden::Suite& all) const;
    golden::GoldenRunSettings settings() const;
    std::size_t job_count() const;
    /// " --suite S --baselines B", without defaults; for printed commands of `scb golden`.
    std::string suite_words() const;
};

void add_suite_options(const Command& command, GoldenOptions& options);
/// The options above, and how cases are run.
void add_golden_options(const Command& command, GoldenOptions& options);

}  // namespace scb::app
