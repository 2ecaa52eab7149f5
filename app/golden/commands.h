#pragma once

#include "app/golden/options.h"
#include "golden/run/check_cases.h"

namespace scb::app {

/// The case of that name, which must be there.
const golden::GoldenCase& case_of(const std::string& name,
                                  const std::vector<golden::GoldenCase>& cases);

/// Gives each failing case its commands: one to draw it again, and, if the run made files, one to
/// accept them. They have the options of the check. The name of the case comes last, so that more
/// names can follow.
void add_commands(golden::SuiteResult& result, const golden::GoldenCheck& check,
                  const GoldenOptions& options);

/// Gives each case whose traces are kept in the folder the command that compares them.
void add_diff_commands(golden::SuiteResult& result, const std::filesystem::path& folder);

}  // namespace scb::app
