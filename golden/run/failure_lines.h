#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/compare/comparison.h"
#include "golden/run/run_case.h"

namespace scb::golden {

/// What changed in the terms of the field, a sentence each: what the traces tell; then the nodes,
/// triangles and pairs that appeared, vanished, or have other pixels or colors. Also gives the
/// things of its ids their names, and says why it may differ, also where pictures have two sizes.
void add_lines(CaseResult& result, const GoldenCase& golden, const GoldenRunSettings& settings,
               const ComparisonFolders& folders);

}  // namespace scb::golden
