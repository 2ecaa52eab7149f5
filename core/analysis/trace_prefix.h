#pragma once

#include "core/analysis/trace.h"

namespace scb {

/// The query as it was after its first `count` volume tests, and the triangle tests that these led
/// to: counts and pairs of these alone. Pairs of nodes that overlap but were not divided by then
/// are left over, see Stage.
TraceFrame trace_prefix(const TraceHeader& header, const TraceFrame& frame, std::size_t count);

}  // namespace scb
