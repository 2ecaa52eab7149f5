#pragma once

#include "core/analysis/attribution.h"
#include "core/judge/query_check.h"

namespace scb {

/// What the tests of a judged query passed on and why, in the language of this project's own
/// queries: of the tests that are in `frame`, its trace_frame. Nothing where the query tells no
/// results.
Attribution attribution(const EngineQuery& query, const QueryJudgement& judged,
                        const TraceHeader& header, const TraceFrame& frame);

}  // namespace scb
