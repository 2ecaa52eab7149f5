#pragma once

#include "app/golden/options.h"
#include "golden/run/check_cases.h"

namespace scb::app {

/// The case of that name, which must be there.
const golden::GoldenCase& case_of(const std::string& name,
                                  const std::vector<golden::GoldenCase>& cases);

/// Gives each failing case the commands to type: the one that draws it again, and the one that
/// takes over what the run made, where it made something. They have the options that the check had,
/// and the name of the case comes last, so that further names can follow.
void add_commands(golden::SuiteResult& result, const golden::GoldenCheck& check,
                  const GoldenOptions& options);

/// Gives each case whose traces are kept in that folder the command that compares them.
void add_diff_commands(golden::SuiteResult& result, const std::filesystem::path& folder);

}  // namespace scb::app
