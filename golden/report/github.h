#pragma once

#include <cstddef>
#include <string>

#include "golden/compare/result.h"

namespace scb::golden {

/// Workflow commands of GitHub Actions for standard output, one error annotation a failing case:
/// "::error title=NAME (VERDICT)::MESSAGE", then its lines; one more where the run is incomplete.
/// GitHub shows ten errors of a step: where there are more cases, the tenth says how many. Empty
/// where nothing fails.
std::string github_annotations(const SuiteResult& result);

/// What GitHub accepts as the summary of a step (1 MiB), less a margin for what else is in it.
inline constexpr std::size_t largest_github_summary =
    (std::size_t{1} << 20) - (std::size_t{1} << 16);

/// The result as Markdown, for the file that GITHUB_STEP_SUMMARY names: a table of how many cases
/// came to which verdict, then the failing cases with their first lines and their commands. At most
/// `largest` bytes, which must be 4096 or more: cases for which there is no room are counted.
std::string github_summary(const SuiteResult& result, std::size_t largest = largest_github_summary);

}  // namespace scb::golden
