#pragma once

#include <functional>
#include <vector>

#include "golden/compare/comparison.h"
#include "golden/run/run_case.h"

namespace scb::golden {

/// What of a suite is run, and how.
struct GoldenCheck {
    std::vector<GoldenCase> cases;
    GoldenRunSettings settings;
    ComparisonFolders folders;  ///< which must be there
    std::size_t jobs = 1;       ///< cases at a time
    bool traces = false;        ///< keep those of failing cases in the folder of the report
};

/// The results of a run, in the order of its cases.
struct CheckedCases {
    std::vector<CaseResult> results;
    std::size_t lacked_gl = 0;  ///< that many could not run for want of an OpenGL context
};

/// Runs all cases and compares each with its baseline, whatever the number of jobs. `step` is
/// called after each, by one thread at a time, and ends the run by returning false; then the cases
/// that were not run, or were stopped, are left out.
CheckedCases check_cases(const GoldenCheck& check, const std::function<bool()>& step);

/// Whether the run of the case has left everything that is compared.
bool has_run(const GoldenCase& golden, const ComparisonFolders& folders);

}  // namespace scb::golden
