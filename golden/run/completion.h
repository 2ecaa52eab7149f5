#pragma once

#include "golden/compare/comparison.h"

namespace scb::golden {

/// Adds to the result of the comparison the facts that a person needs to judge it. If files of the
/// baseline are missing or broken: the pictures and the counts of the run instead, and what to do.
/// If colors pass only because of the case's tolerance: by how much they differ. Throws InputError,
/// OutputError.
void complete_result(CaseResult& result, const GoldenCase& golden,
                     const ComparisonFolders& folders);

}  // namespace scb::golden
