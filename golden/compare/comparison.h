#pragma once

#include <filesystem>

#include "golden/compare/result.h"
#include "golden/suite/suite.h"

namespace scb::golden {

/// The folders in which the comparison finds and leaves files.
struct ComparisonFolders {
    std::filesystem::path baselines;
    std::filesystem::path candidates;  ///< files of the run, named like baselines
    std::filesystem::path report;      ///< where copies for the report go; empty: none are made
};

/// Compares the files of a run of the case with its baseline: counts exactly, then ids exactly,
/// then colors with any accepted picture, exactly or within the case's tolerance. If a file cannot
/// be read, the other comparisons still run: the verdict is could_not_run, and the message names
/// both the differences and the unreadable file. Sets all members of the result except the lines,
/// commands, traces and the time. If something differs and there is a folder for the report, both
/// pictures and their difference are copied there. Throws OutputError if they cannot be written.
CaseResult compare_case(const GoldenCase& golden, const ComparisonFolders& folders);

}  // namespace scb::golden
