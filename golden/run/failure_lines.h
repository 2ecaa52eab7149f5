#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/compare/comparison.h"
#include "golden/run/run_case.h"

namespace scb::golden {

/// Adds the changes in the terms of the field, a sentence each: first from the traces; then the
/// nodes, triangles and pairs that appeared, vanished, or have other pixels or colors. Also names
/// the owners of its ids, and adds the cause, also if pictures have two sizes.
void add_lines(CaseResult& result, const GoldenCase& golden, const GoldenRunSettings& settings,
               const ComparisonFolders& folders);

}  // namespace scb::golden
