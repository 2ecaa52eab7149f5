#pragma once

#include <filesystem>
#include <string>
#include <vector>
#include "app/cli/command.h"

#include "golden/run/run_case.h"

namespace scb::app {

/// What every command of `scb golden` that runs cases understands.
struct GoldenOptions {
    std::string suite = "golden/cases.json", baselines;
    std::vector<std::string> names;
    std::string models, gl, runner;
    int jobs = 0;

    /// Refuses what makes no sense; throws InputError.
    void check() const;
    /// Where baselines are: beside the suite, unless told.
    std::filesystem::path baselines_folder() const;
    /// The cases named, in the order of the suite; all where none is. Their files are looked for
    /// beside the suite, then in the folder of models. Throws InputError where the suite has no
    /// case of a name.
    std::vector<golden::GoldenCase> chosen(const golden::Suite& all) const;
    golden::GoldenRunSettings settings() const;
    std::size_t job_count() const;
    /// " --suite S --baselines B", as far as they are not what is taken without; for commands of
    /// `scb golden` that are shown.
    std::string suite_words() const;
};

void add_suite_options(const Command& command, GoldenOptions& options);
/// These and how cases are run.
void add_golden_options(const Command& command, GoldenOptions& options);

}  // namespace scb::app
