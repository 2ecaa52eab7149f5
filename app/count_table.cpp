#include "app/count_table.h"

#include <cstdio>

namespace scb {
namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
    char text[160];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

std::uint64_t tests_at(const Collision& found, Stage stage) {
    return found.stages[static_cast<std::size_t>(stage)];
}

unsigned long long wide(std::uint64_t value) { return value; }

std::span<const Stage> rejecting_stages(VolumeKind kind, const OverlapOptions& options) {
    switch (kind) {
        case VolumeKind::scb:
            break;
        case VolumeKind::ball:
        case VolumeKind::ritter:
            return ball_stages();
        case VolumeKind::obb:
            return obb_stages();
    }
    return stages_of(options.test);
}

}  // namespace

std::vector<Stage> counted_stages(VolumeKind kind, const OverlapOptions& options) {
    std::vector<Stage> stages = {Stage::overlapping};
    for (const Stage stage : rejecting_stages(kind, options)) stages.push_back(stage);
    return stages;
}

int stage_column_width(Stage stage) {
    return std::max(9, static_cast<int>(stage_name(stage).size()) + 1);
}

std::string count_table_header(const std::vector<Stage>& stages) {
    std::string line = "frame    pairs       N_v       N_p       N_u depth ";
    for (const Stage stage : stages)
        line += format("%*s", stage_column_width(stage), std::string(stage_name(stage)).c_str());
    return line + "\n";
}

std::string count_table_row(int frame, const Collision& c, const std::vector<Stage>& stages) {
    std::string line = format("%5d %8zu %9llu %9llu %9llu %5d ", frame, c.pairs.size(), wide(c.n_v),
                              wide(c.n_p), wide(c.n_u), c.depth);
    for (const Stage stage : stages)
        line += format("%*llu", stage_column_width(stage), wide(tests_at(c, stage)));
    return line + (c.complete ? "\n" : "  stopped\n");
}

nlohmann::ordered_json count_json(int frame, const Collision& c, const std::vector<Stage>& stages) {
    nlohmann::ordered_json counts;
    for (const Stage stage : stages) counts[std::string(stage_name(stage))] = tests_at(c, stage);
    return {
        {"frame", frame}, {"pairs", c.pairs.size()}, {"n_v", c.n_v},     {"n_p", c.n_p},
        {"n_u", c.n_u},   {"depth", c.depth},        {"stages", counts}, {"complete", c.complete}};
}

}  // namespace scb
