#pragma once

#include <filesystem>

#include "golden/compare/result.h"
#include "golden/suite/suite.h"

namespace scb::golden {

/// Where the comparison finds and leaves files.
struct ComparisonFolders {
    std::filesystem::path baselines;
    std::filesystem::path candidates;  ///< what the run made, named as baselines are
    std::filesystem::path report;      ///< where copies for the report go; empty: none are made
};

/// Compares what a run of the case made with its baseline: counts exactly, then ids exactly, then
/// colors with any accepted picture, exactly or within the case's tolerance. A file that cannot be
/// read ends no other comparison: the verdict is could_not_run, and the message says both what
/// differs and what is unreadable. Fills in everything of the result but the lines, commands,
/// traces and the time. Where something differs and there is a folder for the report, both pictures
/// and their difference are copied there. Throws OutputError where that cannot be written.
CaseResult compare_case(const GoldenCase& golden, const ComparisonFolders& folders);

}  // namespace scb::golden
