#pragma once

#include "core/analysis/attribution.h"
#include "core/judge/query_check.h"

namespace scb {

/// Attributes the tests of a judged query, like tests of this project's own queries. `frame` is the
/// query's trace_frame; only its tests are attributed. Empty if the recording has no results.
Attribution attribution(const EngineQuery& query, const QueryJudgement& judged,
                        const TraceHeader& header, const QueryTrace& frame);

}  // namespace scb
