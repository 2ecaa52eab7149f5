#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/golden_case.h"
#include "golden/comparison.h"

namespace scb {

/// What changed in the terms of the field, a sentence each: nodes, triangles and pairs that
/// appeared, vanished, or have other pixels or colors; and, where there are traces of both, the
/// first test at which they part and the pairs that only one of them found. Also adds the counts of
/// tests per depth that differ to the result.
void add_lines(CaseResult& result, const GoldenCase& golden, const GoldenRunSettings& settings,
               const ComparisonFolders& folders);

}  // namespace scb
