#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/report/table.h"
#include "core/analysis/trace.h"
#include "scb/any_collide.h"

namespace scb::app {

/// The stages that queries on this kind of volume count: `overlapping` first, then the stages that
/// can reject, in the test's order.
std::vector<Stage> counted_stages(VolumeKind kind, const OverlapOptions& options);

/// The same of queries of distances: `overlapping` are volumes nearer than the answer so far.
std::vector<Stage> counted_distance_stages(VolumeKind kind);
/// The name of such a stage; "near" for `overlapping`.
std::string distance_stage_name(Stage stage);

/// The sixteen stages of boxes are too many for a table of text.
inline constexpr std::size_t most_stage_columns = 8;

/// A table of queries: its columns, and the cells and the note of a query's row.
std::vector<Column> count_columns(const std::vector<Stage>& stages);
std::vector<Cell> count_cells(int frame, const Collision& found, const std::vector<Stage>& stages);
std::string count_note(const Collision& found);
/// The cells of a query on packed layouts, which count neither N_u nor depths and stages.
std::vector<Cell> packed_count_cells(int frame, const Collision& found);

/// A query as JSON, in the paper's notation, with the pose of B in A's frame ([R|t] row by row)
/// and the hash of the pairs.
nlohmann::ordered_json count_json(int frame, const Pose& b_to_a, const Collision& found,
                                  const std::vector<Stage>& stages);
/// The same of a query on packed layouts.
nlohmann::ordered_json packed_count_json(int frame, const Pose& b_to_a, const Collision& found);

/// The columns and the cells of the closest triangles: their distance, their numbers, and the
/// points between which it was measured; "-" without triangles.
std::vector<Column> found_columns();
std::vector<Cell> found_cells(const std::optional<IndexPair>& triangles,
                              const TriangleDistance& found);
/// The closest triangles, their distance and the points between which it was measured, as JSON;
/// null without triangles.
nlohmann::ordered_json found_json(const std::optional<IndexPair>& triangles,
                                  const TriangleDistance& found);

/// A table of a trace or a recording, line by line, each with its line end. Other engines have no
/// N_u and their own stages.
std::string count_table_header(const TraceHeader& header);
std::string count_table_row(const TraceHeader& header, const QueryTrace& frame);
/// The same as JSON.
nlohmann::ordered_json count_json(const TraceHeader& header, const QueryTrace& frame);

}  // namespace scb::app
