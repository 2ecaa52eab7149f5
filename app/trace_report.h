#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/trace_diff.h"

namespace scb {

/// What was asked, as lines, and as JSON.
std::string trace_header_text(const TraceHeader& header);
nlohmann::ordered_json trace_header_json(const TraceHeader& header);

/// One test: nodes, depths, stage, and what follows from it.
nlohmann::ordered_json traced_test_json(const TracedTest& test);

/// Every test of a frame: a line each, under a line of headings; or a list.
std::string trace_events_text(const TraceHeader& header, const TraceFrame& frame);
nlohmann::ordered_json trace_events_json(const TraceHeader& header, const TraceFrame& frame);

}  // namespace scb
