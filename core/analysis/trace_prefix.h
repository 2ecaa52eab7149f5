#pragma once

#include "core/analysis/trace.h"

namespace scb {

/// The query cut off after its first `count` volume tests and their triangle tests, with the counts
/// and pairs of these alone. Overlapping pairs that were not divided by then are left over, see
/// Stage.
TraceFrame trace_prefix(const TraceHeader& header, const TraceFrame& frame, std::size_t count);

}  // namespace scb
