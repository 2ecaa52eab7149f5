#pragma once

#include <map>
#include <string_view>

#include "core/analysis/trace.h"
#include "core/judge/engine_query.h"

namespace scb {

/// A stage of an engine by a number, 1 to 127, and the name that it gives it: this project's own
/// where it has the name of one, so that it has its color too.
Stage stage_of_engine(std::uint8_t number, std::string_view name);

/// An engine's query as traces have it: tests of nodes by their indices, those of nodes that there
/// are not left out; of objects, which are no triangles, the pairs of the nodes that hold them.
/// `stages` are what the engine's numbers of stages mean, by number.
TraceFrame trace_frame(const EngineQuery& query, const std::map<std::uint8_t, Stage>& stages);

}  // namespace scb
