#include "app/query/count_table.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "app/query/poses_json.h"
#include "core/analysis/ending.h"
#include "core/base/text_format.h"
#include "core/collide/index_pairs.h"

namespace scb::app {
namespace {

std::uint64_t tests_at(const Collision& found, Stage stage) {
    return found.stages[static_cast<std::size_t>(stage)];
}

/// The sixteen stages of boxes are too many for a table.
constexpr std::size_t most_columns = 8;

int column_width(const std::string& name) { return std::max(9, static_cast<int>(name.size()) + 1); }

std::string header_line(const std::vector<std::string>& stages) {
    std::string line = "frame    pairs       N_v       N_p       N_u depth ";
    for (const std::string& name : stages) line += format("%*s", column_width(name), name.c_str());
    return line + "\n";
}

std::string end_of_row(const Collision& c) { return c.complete ? "\n" : "  stopped\n"; }

std::vector<Stage> table_stages(const TraceHeader& header) {
    std::vector<Stage> stages = counted_stages(header.volume, header.options.overlap);
    if (stages.size() > most_columns) stages.clear();
    return stages;
}

}  // namespace

std::vector<Stage> counted_stages(VolumeKind kind, const OverlapOptions& options) {
    std::vector<Stage> stages = {Stage::overlapping};
    for (const Stage stage : stages_of(kind, options)) stages.push_back(stage);
    return stages;
}

int stage_column_width(Stage stage) { return column_width(std::string(stage_name(stage))); }

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",:\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string count_table_header(const std::vector<Stage>& stages) {
    std::vector<std::string> names;
    for (const Stage stage : stages) names.emplace_back(stage_name(stage));
    return header_line(names);
}

std::string count_table_row(int frame, const Collision& c, const std::vector<Stage>& stages) {
    std::string line = format("%5d %8zu %9llu %9llu %9llu %5d ", frame, c.pairs.size(), wide(c.n_v),
                              wide(c.n_p), wide(c.n_u), c.depth);
    for (const Stage stage : stages)
        line += format("%*llu", stage_column_width(stage), wide(tests_at(c, stage)));
    return line + end_of_row(c);
}

std::string count_table_header(const TraceHeader& header) {
    if (!header.engine) return count_table_header(table_stages(header));
    std::vector<std::string> names;
    for (const auto& [name, count] : tests_by_stage(header, {})) names.push_back(name);
    if (names.size() > most_columns) names.clear();
    return header_line(names);
}

std::string count_table_row(const TraceHeader& header, const TraceFrame& frame) {
    const Collision& c = frame.found;
    if (!header.engine) return count_table_row(frame.frame, c, table_stages(header));
    std::string line = format("%5d %8zu %9llu %9llu %9s %5d ", frame.frame, c.pairs.size(),
                              wide(c.n_v), wide(c.n_p), "-", c.depth);
    const auto stages = tests_by_stage(header, frame);
    if (stages.size() <= most_columns)
        for (const auto& [name, count] : stages)
            line += format("%*llu", column_width(name), wide(count));
    return line + end_of_row(c);
}

nlohmann::ordered_json count_json(const TraceHeader& header, const TraceFrame& frame) {
    nlohmann::ordered_json json = count_json(frame.frame, frame.b_to_a, frame.found,
                                             counted_stages(header.volume, header.options.overlap));
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

}  // namespace scb::app
