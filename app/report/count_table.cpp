#include "app/report/count_table.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "app/report/scene_report.h"
#include "core/analysis/ending.h"
#include "core/base/text_format.h"
#include "core/collide/index_pairs.h"

namespace scb::app {
namespace {

std::uint64_t tests_at(const Collision& found, Stage stage) {
    return found.stages[static_cast<std::size_t>(stage)];
}

using StageTests = std::vector<std::pair<std::string, std::uint64_t>>;

StageTests stage_tests(const Collision& found, const std::vector<Stage>& stages) {
    StageTests tests;
    for (const Stage stage : stages) tests.emplace_back(stage_name(stage), tests_at(found, stage));
    return tests;
}

/// The stages that the queries of a trace count.
std::vector<Stage> header_stages(const TraceHeader& header) {
    return is_of_distance(header.kind) ? counted_distance_stages(header.volume)
                                       : counted_stages(header.volume, header.options.overlap);
}

/// The tests by stage of a frame of a trace.
StageTests stage_tests(const TraceHeader& header, const QueryTrace& frame) {
    if (header.engine) return tests_by_stage(header, frame);
    StageTests tests = stage_tests(frame.found, header_stages(header));
    if (is_of_distance(header.kind)) tests.front().first = distance_stage_name(Stage::overlapping);
    return tests;
}

void add_stage_columns(std::vector<Column>& columns, const StageTests& stages) {
    for (const auto& [name, count] : stages)
        columns.push_back({name, name, std::max<std::size_t>(9, name.size() + 1)});
}

std::vector<Column> columns_of(const StageTests& stages) {
    std::vector<Column> columns = {
        {"frame", "frame", 5}, {"pairs", "pairs", 9},  {"N_v", "n_v", 10}, {"N_p", "n_p", 10},
        {"N_u", "n_u", 10},    {"depth ", "depth", 7}, {"", "complete"}};
    add_stage_columns(columns, stages);
    return columns;
}

Cell depth_cell(const Collision& c) { return {c.depth, std::to_string(c.depth) + " "}; }

/// `n_u`, `depth`: "-" where they are not counted.
std::vector<Cell> cells_of(int frame, const Collision& c, Cell n_u, Cell depth,
                           const StageTests& stages) {
    std::vector<Cell> cells = {frame, c.pairs.size(), c.n_v,
                               c.n_p, std::move(n_u), std::move(depth)};
    cells.emplace_back(c.complete);
    for (const auto& [name, count] : stages) cells.emplace_back(count);
    return cells;
}

/// The stages of a table of a trace.
StageTests table_stages(const TraceHeader& header, const QueryTrace& frame) {
    StageTests stages = stage_tests(header, frame);
    if (stages.size() > most_stage_columns) stages.clear();
    return stages;
}

/// The closest triangles of a query for the smallest distance.
std::optional<IndexPair> closest_of(const QueryTrace& frame) {
    return frame.nearest ? std::optional(frame.found.pairs.front()) : std::nullopt;
}

/// This program's own queries of distances, as `scb distance` counts them.
bool has_answer_table(const TraceHeader& header) {
    return is_of_distance(header.kind) && !header.engine;
}

Table answer_table(const TraceHeader& header, const QueryTrace& frame) {
    const StageTests stages = table_stages(header, frame);
    std::vector<Column> columns = {{"frame", "frame", 5}};
    if (header.kind == QueryKind::within)
        columns.push_back({"pairs", "pairs", 9});
    else
        for (Column& column : found_columns()) columns.push_back(std::move(column));
    for (const auto& [title, key] :
         {std::pair("N_v", "n_v"), std::pair("N_p", "n_p"), std::pair("N_u", "n_u")})
        columns.push_back({title, key, 10});
    add_stage_columns(columns, stages);
    Table table(std::move(columns));
    std::vector<Cell> cells = {frame.frame};
    if (header.kind == QueryKind::within)
        cells.emplace_back(frame.found.pairs.size());
    else
        for (Cell& cell :
             found_cells(closest_of(frame), frame.nearest.value_or(TriangleDistance{})))
            cells.push_back(std::move(cell));
    for (const std::uint64_t count : {frame.found.n_v, frame.found.n_p, frame.found.n_u})
        cells.emplace_back(count);
    for (const auto& [name, count] : stages) cells.emplace_back(count);
    table.add(std::move(cells));
    return table;
}

}  // namespace

std::vector<Stage> counted_stages(VolumeKind kind, const OverlapOptions& options) {
    std::vector<Stage> stages = {Stage::overlapping};
    for (const Stage stage : stages_of(kind, options)) stages.push_back(stage);
    return stages;
}

std::vector<Stage> counted_distance_stages(VolumeKind kind) {
    std::vector<Stage> stages = {Stage::overlapping};
    for (const Stage stage : distance_stages(kind)) stages.push_back(stage);
    return stages;
}

std::string distance_stage_name(Stage stage) {
    return stage == Stage::overlapping ? "near" : std::string(stage_name(stage));
}

std::vector<Column> count_columns(const std::vector<Stage>& stages) {
    return columns_of(stage_tests({}, stages));
}

std::vector<Cell> count_cells(int frame, const Collision& c, const std::vector<Stage>& stages) {
    return cells_of(frame, c, c.n_u, depth_cell(c), stage_tests(c, stages));
}

std::vector<Cell> packed_count_cells(int frame, const Collision& c) {
    const nlohmann::ordered_json none;
    return cells_of(frame, c, {none, std::string("-")}, {none, std::string("- ")}, {});
}

std::string count_note(const Collision& c) { return c.complete ? "" : "  stopped"; }

std::string count_table_header(const TraceHeader& header) {
    if (has_answer_table(header)) return answer_table(header, {}).text_header();
    return Table(columns_of(table_stages(header, {}))).text_header();
}

std::string count_table_row(const TraceHeader& header, const QueryTrace& frame) {
    if (has_answer_table(header)) return answer_table(header, frame).text_row(0);
    const StageTests stages = table_stages(header, frame);
    const Collision& c = frame.found;
    Table table(columns_of(stages));
    table.add(
        cells_of(frame.frame, c, header.engine ? Cell("-") : Cell(c.n_u), depth_cell(c), stages),
        count_note(c));
    return table.text_row(0);
}

std::vector<Column> found_columns() {
    std::vector<Column> columns = {{"distance", "distance", 12},
                                   {"triangle A", "triangle_a", 11},
                                   {"triangle B", "triangle_b", 11}};
    for (const char* coordinate :
         {"point_a_x", "point_a_y", "point_a_z", "point_b_x", "point_b_y", "point_b_z"})
        columns.push_back({"", coordinate});
    return columns;
}

std::vector<Cell> found_cells(const std::optional<IndexPair>& triangles,
                              const TriangleDistance& found) {
    if (!triangles) {
        std::vector<Cell> cells(9);
        for (std::size_t i = 0; i < 3; ++i) cells[i].text = "-";
        return cells;
    }
    std::vector<Cell> cells = {Cell(found.distance, "%.6g"), triangles->a, triangles->b};
    for (const Vec3& p : {found.point_a, found.point_b})
        for (int i = 0; i < 3; ++i) cells.emplace_back(p[i], "%.6g");
    return cells;
}

nlohmann::ordered_json found_json(const std::optional<IndexPair>& triangles,
                                  const TriangleDistance& found) {
    if (!triangles) return {{"distance", nullptr}, {"triangles", nullptr}, {"points", nullptr}};
    const auto xyz = [](const Vec3& p) { return nlohmann::ordered_json{p[0], p[1], p[2]}; };
    return {{"distance", found.distance},
            {"triangles", {triangles->a, triangles->b}},
            {"points", {xyz(found.point_a), xyz(found.point_b)}}};
}

nlohmann::ordered_json count_json(const TraceHeader& header, const QueryTrace& frame) {
    nlohmann::ordered_json json =
        count_json(frame.frame, frame.b_to_a, frame.found, header_stages(header));
    if (is_of_distance(header.kind)) {
        json["stages"] = nlohmann::ordered_json::object();
        for (const Stage stage : header_stages(header))
            json["stages"][distance_stage_name(stage)] = tests_at(frame.found, stage);
        if (!header.engine) json.erase("depth");  // these queries do not count it
    }
    if (header.kind == QueryKind::distance) {
        json.update(found_json(closest_of(frame), frame.nearest.value_or(TriangleDistance{})));
        if (frame.nearest && frame.rounding > 0) json["rounding"] = frame.rounding;
    }
    if (!header.engine) return json;
    json.erase("n_u");
    json["stages"] = nlohmann::ordered_json::object();
    for (const auto& [name, count] : tests_by_stage(header, frame)) json["stages"][name] = count;
    return json;
}

nlohmann::ordered_json count_json(int frame, const Pose& b_to_a, const Collision& c,
                                  const std::vector<Stage>& stages) {
    nlohmann::ordered_json counts;
    for (const Stage stage : stages) counts[std::string(stage_name(stage))] = tests_at(c, stage);
    return {{"frame", frame},
            {"pose", pose_json(b_to_a)},
            {"pairs", c.pairs.size()},
            {"pairs_hash", hash_text(pairs_hash(c.pairs))},
            {"n_v", c.n_v},
            {"n_p", c.n_p},
            {"n_u", c.n_u},
            {"depth", c.depth},
            {"stages", counts},
            {"complete", c.complete}};
}

nlohmann::ordered_json packed_count_json(int frame, const Pose& b_to_a, const Collision& c) {
    nlohmann::ordered_json json = count_json(frame, b_to_a, c, {});
    for (const char* not_counted : {"n_u", "depth", "stages"}) json.erase(not_counted);
    return json;
}

}  // namespace scb::app
