#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "golden/compare/comparison.h"
#include "golden/run/run_case.h"

namespace scb::golden {

/// The cases of a suite to run, and the settings.
struct GoldenCheck {
    std::vector<GoldenCase> cases;
    GoldenRunSettings settings;
    ComparisonFolders folders;  ///< must exist
    std::size_t jobs = 1;       ///< cases at a time
    bool traces = false;        ///< keep traces of failing cases in the folder of the report
};

/// The results of a run, in the order of its cases.
struct CheckedCases {
    std::vector<CaseResult> results;
    std::size_t lacked_gl = 0;  ///< cases that could not run without an OpenGL context
};

/// Runs all cases and compares each with its baseline; the results do not depend on the number of
/// jobs. `step` is called after each case, by one thread at a time. If it returns false, the run
/// ends, and cases that were not run, or were stopped, are left out.
CheckedCases check_cases(const GoldenCheck& check, const std::function<bool()>& step);

/// Whether the run of the case has made everything that is compared.
bool has_run(const GoldenCase& golden, const ComparisonFolders& folders);

/// Calls `work(i)` for 0 to count - 1 in `threads` threads; a free thread takes the next i. Calls
/// `step` after each, one thread at a time; if it returns false, the loop ends. An exception of
/// either ends the loop too, and is thrown here once all threads have ended.
void for_each_in_threads(std::size_t count, std::size_t threads,
                         const std::function<void(std::size_t)>& work,
                         const std::function<bool()>& step);

/// Adds to the result of the comparison the facts that a person needs to judge it. If files of the
/// baseline are missing or broken: the pictures and the counts of the run instead, and what to do.
/// If colors pass only because of the case's tolerance: by how much they differ. Throws InputError,
/// OutputError.
void complete_result(CaseResult& result, const GoldenCase& golden,
                     const ComparisonFolders& folders);

}  // namespace scb::golden
