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
    return stage_tests(frame.found, header_stages(header));
}

std::vector<Column> columns_of(const StageTests& stages) {
    std::vector<Column> columns = {
        {"frame", "frame", 5}, {"pairs", "pairs", 9},  {"N_v", "n_v", 10}, {"N_p", "n_p", 10},
        {"N_u", "n_u", 10},    {"depth ", "depth", 7}, {"", "complete"}};
    for (const auto& [name, count] : stages)
        columns.push_back({name, name, std::max<std::size_t>(9, name.size() + 1)});
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
    return Table(columns_of(table_stages(header, {}))).text_header();
}

std::string count_table_row(const TraceHeader& header, const QueryTrace& frame) {
    const StageTests stages = table_stages(header, frame);
    const Collision& c = frame.found;
    Table table(columns_of(stages));
    table.add(
        cells_of(frame.frame, c, header.engine ? Cell("-") : Cell(c.n_u), depth_cell(c), stages),
        count_note(c));
    return table.text_row(0);
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
    }
    if (header.kind == QueryKind::distance) {
        std::optional<IndexPair> closest;
        if (frame.nearest) closest = frame.found.pairs.front();
        json.update(found_json(closest, frame.nearest.value_or(TriangleDistance{})));
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
