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

/// The versions of everything that drew and compared, as in index.json.
std::vector<std::pair<std::string, std::string>> golden_environment(
    const golden::GoldenRunSettings& settings);

/// Text after the name of one of uncompared_images.
inline constexpr const char* why_uncompared =
    "is never compared: accepted pictures are numbered from 2, without a gap.";

/// Where to write results; empty: nowhere.
struct ResultFiles {
    std::string report, junit, json;

    /// Throws InputError if results would be among the baselines, or would replace the suite or
    /// another input.
    void check(const std::filesystem::path& suite, const std::filesystem::path& baselines) const;
    /// Throws InputError if results would replace an input, or a file that holds no results.
    void refuse_inputs() const;
    /// Where all lines of failed cases are, or would be.
    std::string with_all_lines() const;

  private:
    /// The files, each with its option.
    std::vector<std::pair<std::string, std::filesystem::path>> written() const;
};

void add_result_files(const Command& command, ResultFiles& files);

/// Prints the result; writes the folder of the report, with the contents of `work`; writes JUnit
/// and JSON files; and, if the environment asks for them, annotations and a summary for GitHub
/// Actions. If one output fails, the others are still written. Throws OutputError if one fails.
void write_results(const golden::SuiteResult& result, const ResultFiles& files,
                   const std::filesystem::path& work);

/// A line per case that is not the same, with the differences, and a line with the number of cases
/// per verdict. A case has at most 25 lines; the last says how many more `all_lines` has.
std::string results_text(const golden::SuiteResult& result, const std::string& all_lines);

}  // namespace scb::app
