#include "app/query/count_table.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "app/query/poses_json.h"
#include "core/base/text_format.h"
#include "core/collide/pairs_hash.h"

namespace scb::app {
namespace {

std::uint64_t tests_at(const Collision& found, Stage stage) {
    return found.stages[static_cast<std::size_t>(stage)];
}

}  // namespace

std::vector<Stage> counted_stages(VolumeKind kind, const OverlapOptions& options) {
    std::vector<Stage> stages = {Stage::overlapping};
    for (const Stage stage : stages_of(kind, options)) stages.push_back(stage);
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
