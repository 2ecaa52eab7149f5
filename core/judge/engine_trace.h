#pragma once

#include <map>

#include "core/analysis/trace.h"
#include "core/judge/engine_query.h"

namespace scb {

/// An engine's query as traces have it: tests of nodes by their indices, those of nodes that there
/// are not left out; of objects, which are no triangles, the pairs of the nodes that hold them.
/// `stages` has the stage of each of the engine's numbers but 0, which means "overlapping".
TraceFrame trace_frame(const EngineQuery& query, const std::map<std::uint8_t, Stage>& stages);

}  // namespace scb
