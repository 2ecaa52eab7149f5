#pragma once

#include <map>

#include "core/analysis/trace.h"
#include "core/judge/engine_query.h"

namespace scb {

/// The number, in `stages` of trace_frame, of tests that left_out_tests finds; no recorded stage
/// has it.
inline constexpr std::uint8_t left_out_stage = 255;

/// Converts an engine's query to a frame of a trace. Tests name nodes by index; tests of unknown
/// nodes are left out. A pair of objects becomes the pair of nodes that hold them. `stages` maps
/// the engine's stage numbers; 0 means "overlapping" and has no entry.
QueryTrace trace_frame(const EngineQuery& query, const std::map<std::uint8_t, Stage>& stages);

}  // namespace scb
