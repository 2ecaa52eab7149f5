#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/compare/cause.h"
#include "golden/compare/comparison.h"
#include "golden/run/run_case.h"

namespace scb::golden {

/// Adds the changes in the terms of the field, a sentence each: first from the traces; then the
/// nodes, triangles and pairs that appeared, vanished, or have other pixels or colors. Also names
/// the owners of its ids, and adds the cause, also if pictures have two sizes.
void add_lines(CaseResult& result, const GoldenCase& golden, const GoldenRunSettings& settings,
               const ComparisonFolders& folders);

/// Adds the differences of the traces of the baseline and of the run, if both exist: lines for
/// settings that differ (if the cause does not name them), for the pairs that only one found, and
/// for the first test that differs; the whole difference as text; and the counts of tests per depth
/// that differ. Returns whether both have the same meshes, as far as traces show. Throws
/// InputError.
bool add_trace_lines(CaseResult& result, const ComparisonFolders& folders, const Cause& cause);

}  // namespace scb::golden
