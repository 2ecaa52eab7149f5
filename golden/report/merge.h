#pragma once

#include <string>
#include <vector>

#include "golden/compare/result.h"

namespace scb::golden {

/// A result and the file that it was read from, for refusals.
struct ResultPart {
    std::string file;
    SuiteResult result;
};

/// The results of one run as one: of all shards 1/N to N/N, whose cases come into the order of the
/// suite, or of runs of parts of a suite, one behind the other. What is missing of the shards is
/// said in `incomplete`. Versions that are not the same in all shards are all kept. Throws
/// InputError, naming the file, where two results are not of one suite and one run: of several
/// suites, of another number of shards, or of a case or a shard that another has too.
SuiteResult merge_results(const std::vector<ResultPart>& parts);

}  // namespace scb::golden
