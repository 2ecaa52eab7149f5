#pragma once

#include "golden/compare/cause.h"
#include "golden/compare/comparison.h"

namespace scb::golden {

/// What the traces of the baseline and of the run tell, where there are both: lines for what was
/// asked of only one of them (as far as the cause does not say it), for the pairs that only one
/// found, and for the first test at which they part; all of it as text; and the counts of tests per
/// depth that differ. Returns whether both are of the same meshes, as far as traces tell. Throws
/// InputError.
bool add_trace_lines(CaseResult& result, const ComparisonFolders& folders, const Cause& cause);

}  // namespace scb::golden
