#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/analysis/trace.h"
#include "scb/any_collide.h"

namespace scb::app {

/// The stages that queries on this kind of volume count: `overlapping` first, then the stages that
/// can reject, in the test's order.
std::vector<Stage> counted_stages(VolumeKind kind, const OverlapOptions& options);

/// Fits the name of the stage and a count.
int stage_column_width(Stage stage);

/// A field of a line of CSV (RFC 4180). A text with a colon is quoted too, since print_result would
/// change a name that begins with two.
std::string csv_field(const std::string& text);

/// A table of queries: its header, and the row of a query. Each line has its line end.
std::string count_table_header(const std::vector<Stage>& stages);
std::string count_table_row(int frame, const Collision& found, const std::vector<Stage>& stages);

/// The same as JSON, in the paper's notation, with the pose of B in A's frame ([R|t] row by row)
/// and the hash of the pairs.
nlohmann::ordered_json count_json(int frame, const Pose& b_to_a, const Collision& found,
                                  const std::vector<Stage>& stages);

// The same for a trace or a recording. Other engines have no N_u and their own stages.
std::string count_table_header(const TraceHeader& header);
std::string count_table_row(const TraceHeader& header, const TraceFrame& frame);
nlohmann::ordered_json count_json(const TraceHeader& header, const TraceFrame& frame);

}  // namespace scb::app
