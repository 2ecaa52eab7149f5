#pragma once

#include <span>
#include <vector>

#include "core/overlap/stage_table.h"
#include "scb/step.h"

namespace scb {

/// For each step of a query its stage or, if the volumes overlap, what followed.
using Outcomes = std::vector<Stage>;

/// The outcomes of a query's steps. `found_nodes`: the query's pairs, sorted, if they are pairs of
/// nodes; else empty. O(n log n).
Outcomes outcomes_of(const Steps& steps, std::span<const IndexPair> found_nodes);

}  // namespace scb
