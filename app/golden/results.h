#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/golden/options.h"
#include "golden/compare/result.h"

namespace scb::app {

/// What drew and compared: versions, as index.json has them.
std::vector<std::pair<std::string, std::string>> golden_environment(
    const golden::GoldenRunSettings& settings);

/// Behind the name of one of uncompared_images.
inline constexpr const char* why_uncompared =
    "is never compared: accepted pictures are numbered from 2, without a gap.";

/// Where results go; empty: nowhere.
struct ResultFiles {
    std::string report, junit, json;

    /// Throws InputError where they would come among the baselines, or over the suite or another
    /// file that was read.
    void check(const std::filesystem::path& suite, const std::filesystem::path& baselines) const;
    /// Throws InputError where they would replace a file that was read, or one that holds no
    /// results.
    void refuse_inputs() const;

  private:
    /// The files, each with its option.
    std::vector<std::pair<std::string, std::filesystem::path>> written() const;
};

void add_result_files(const Command& command, ResultFiles& files);

/// Prints the result; writes the folder of the report, with what is in `work`; JUnit and JSON into
/// their files; and, where the environment has them, annotations and a summary for GitHub Actions:
/// as many of them as can be written. Throws OutputError where one cannot.
void write_results(const golden::SuiteResult& result, const ResultFiles& files,
                   const std::filesystem::path& work);

/// A line per case that is not the same, with what differs, and one with how many cases came to
/// what.
std::string results_text(const golden::SuiteResult& result);

}  // namespace scb::app
