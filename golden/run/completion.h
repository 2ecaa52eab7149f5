#pragma once

#include "golden/compare/comparison.h"

namespace scb::golden {

/// Adds to what the comparison found what a person needs to judge it: where the baseline lacks or
/// has broken files, the pictures and the counts that the run made instead, and what to do; and
/// where colors pass only because the case declares a tolerance, by how much they differ. Throws
/// InputError, OutputError.
void complete_result(CaseResult& result, const GoldenCase& golden,
                     const ComparisonFolders& folders);

}  // namespace scb::golden
