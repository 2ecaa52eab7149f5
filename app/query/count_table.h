#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/analysis/trace.h"
#include "scb/any_collide.h"

namespace scb::app {

/// The stages that queries on this kind of volume count: overlapping first, then those at which the
/// test rejects, in its order.
std::vector<Stage> counted_stages(VolumeKind kind, const OverlapOptions& options);

/// As wide as the name of the stage, and at least as a count is.
int stage_column_width(Stage stage);

/// The text as a field of CSV (RFC 4180): in quotes if it has a comma, a quote or a line end.
std::string csv_field(const std::string& text);

/// A table of queries: its header, and one query. Lines with their ends.
std::string count_table_header(const std::vector<Stage>& stages);
std::string count_table_row(int frame, const Collision& found, const std::vector<Stage>& stages);

/// The same as JSON, in the paper's language, with the pose of B as A sees it, [R|t] row by row,
/// and the hash of the pairs.
nlohmann::ordered_json count_json(int frame, const Pose& b_to_a, const Collision& found,
                                  const std::vector<Stage>& stages);

// The same of a trace or a recording. Of another engine there is no N_u, and the stages are its
// own.
std::string count_table_header(const TraceHeader& header);
std::string count_table_row(const TraceHeader& header, const TraceFrame& frame);
nlohmann::ordered_json count_json(const TraceHeader& header, const TraceFrame& frame);

}  // namespace scb::app
