#pragma once

#include "core/analysis/trace.h"

namespace scb {

/// The query cut off after its first `count` volume tests and their triangle tests, with the counts
/// and pairs of these alone. Overlapping pairs that were not divided by then are left over, see
/// Stage.
QueryTrace trace_prefix(const TraceHeader& header, const QueryTrace& frame, std::size_t count);

}  // namespace scb
