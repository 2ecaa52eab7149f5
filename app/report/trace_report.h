#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/analysis/trace_diff.h"

namespace scb::app {

/// The parameters of the queries, as lines, and as JSON.
std::string trace_header_text(const TraceHeader& header);
/// A body and the fingerprint of its mesh.
nlohmann::ordered_json body_json(const TraceBody& body);
nlohmann::ordered_json trace_header_json(const TraceHeader& header);

/// One test: nodes, depths, stage, and its consequence.
nlohmann::ordered_json traced_test_json(const TracedTest& test, const BodyNames& bodies);

/// The order and the limits of queries for the smallest distance.
nlohmann::ordered_json limits_json(const DistanceOptions& limits);

}  // namespace scb::app
