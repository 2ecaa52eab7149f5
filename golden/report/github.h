#pragma once

#include <cstddef>
#include <string>

#include "golden/compare/result.h"

namespace scb::golden {

/// Workflow commands of GitHub Actions for standard output, one error annotation a failing case:
/// "::error title=NAME (VERDICT)::MESSAGE", then its lines; one more if the run is incomplete.
/// GitHub shows ten errors of a step: if there are more cases, the tenth has their number. Empty if
/// nothing fails.
std::string github_annotations(const SuiteResult& result);

/// The size that GitHub accepts as the summary of a step (1 MiB), minus a margin for other parts of
/// it.
inline constexpr std::size_t largest_github_summary =
    (std::size_t{1} << 20) - (std::size_t{1} << 16);

/// The result as Markdown, for the file that GITHUB_STEP_SUMMARY names: a table of the number of
/// cases by verdict, then the failing cases with their first lines and their commands. At most
/// `largest` bytes, which must be 4096 or more: cases without room are only counted.
std::string github_summary(const SuiteResult& result, std::size_t largest = largest_github_summary);

}  // namespace scb::golden
