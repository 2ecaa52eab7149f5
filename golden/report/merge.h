#pragma once

#include <string>
#include <vector>

#include "golden/compare/result.h"

namespace scb::golden {

/// A result and the file that it was read from, for messages.
struct ResultPart {
    std::string file;
    SuiteResult result;
};

/// Merges the results of one run: of all shards 1/N to N/N, with the cases in the order of the
/// suite, or of runs of parts of a suite, in sequence. `incomplete` names the missing shards.
/// Versions that differ between shards are all kept. Throws InputError, naming the file, if two
/// results are not of one suite and one run: different suites, different numbers of shards, or a
/// case or a shard twice.
SuiteResult merge_results(const std::vector<ResultPart>& parts);

}  // namespace scb::golden
