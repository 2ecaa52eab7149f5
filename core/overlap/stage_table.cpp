#include "core/overlap/stage_table.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

namespace scb {
namespace {

struct NamedRow {
    StageRow row;
    Hue hue;
};

// In the order of Stage.
constexpr std::array<NamedRow, named_stage_count> named_rows = {{
    {{"overlapping", ""}, Hue::grey},
    {{"ball-ball", "ball A, ball B"}, Hue::grey},
    {{"slab-ball", "slab A, ball B"}, Hue::blue},
    {{"ball-slab", "ball A, slab B"}, Hue::sky},
    {{"slab-cylinder", "slab A, cylinder B"}, Hue::green},
    {{"cylinder-slab", "cylinder A, slab B"}, Hue::yellow},
    {{"slab-a", "normal of A"}, Hue::blue},
    {{"slab-b", "normal of B"}, Hue::sky},
    {{"center-line", "line of centers"}, Hue::green},
    {{"axis-a0", "faces of A"}, Hue::blue},
    {{"axis-a1", "faces of A"}, Hue::blue},
    {{"axis-a2", "faces of A"}, Hue::blue},
    {{"axis-b0", "faces of B"}, Hue::sky},
    {{"axis-b1", "faces of B"}, Hue::sky},
    {{"axis-b2", "faces of B"}, Hue::sky},
    {{"axis-a0xb0", "edges A × B"}, Hue::green},
    {{"axis-a0xb1", "edges A × B"}, Hue::green},
    {{"axis-a0xb2", "edges A × B"}, Hue::green},
    {{"axis-a1xb0", "edges A × B"}, Hue::green},
    {{"axis-a1xb1", "edges A × B"}, Hue::green},
    {{"axis-a1xb2", "edges A × B"}, Hue::green},
    {{"axis-a2xb0", "edges A × B"}, Hue::green},
    {{"axis-a2xb1", "edges A × B"}, Hue::green},
    {{"axis-a2xb2", "edges A × B"}, Hue::green},
    {{"second-slab-a", "second normal of A"}, Hue::violet},
    {{"second-slab-b", "second normal of B"}, Hue::olive},
    {{"long-axes", "long axes"}, Hue::yellow},
    {{"search", "by search"}, Hue::sky},
    {{"triangles apart", "triangles apart"}, Hue::purple},
    {{"triangles meet", "triangles meet"}, Hue::vermillion},
    {{"found", "overlap"}, Hue::vermillion},
    {{"neighbors", "triangles share a vertex"}, Hue::tan},
    {{"left over", "left over"}, Hue::left_over},
    {{"divided a", ""}, Hue::grey},
    {{"divided b", ""}, Hue::grey},
    {{"divided both", ""}, Hue::grey},
}};
static_assert(named_rows[static_cast<std::size_t>(Stage::search)].row.name == "search" &&
              named_rows[static_cast<std::size_t>(Stage::divided_both)].row.name == "divided both");

// Of an engine's rows, in their order.
constexpr std::array added_hues = {Hue::blue,  Hue::sky,  Hue::green, Hue::yellow, Hue::violet,
                                   Hue::olive, Hue::navy, Hue::brown, Hue::mint};

}  // namespace

std::uint64_t test_count(const StageCounts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

std::string_view stage_name(Stage stage) {
    return named_rows.at(static_cast<std::size_t>(stage)).row.name;
}

std::optional<Stage> stage_of(std::string_view name) {
    for (std::size_t i = 0; i < named_rows.size(); ++i)
        if (named_rows[i].row.name == name) return static_cast<Stage>(i);
    return std::nullopt;
}

Hue hue_of(Stage stage) {
    const auto row = static_cast<std::size_t>(stage);
    if (row < named_stage_count) return named_rows[row].hue;
    const std::size_t added = row - named_stage_count;
    return added < added_hues.size() ? added_hues[added] : Hue::grey;
}

std::optional<Stage> StageTable::find(std::string_view name) const {
    if (const std::optional<Stage> named = stage_of(name); named && is_rejection(*named))
        return named;
    const auto known = std::find(added_.begin(), added_.end(), name);
    if (known == added_.end()) return std::nullopt;
    return static_cast<Stage>(named_stage_count + static_cast<std::size_t>(known - added_.begin()));
}

Stage StageTable::add(std::string name) {
    if (const std::optional<Stage> known = find(name)) return *known;
    const std::size_t row = named_stage_count + added_.size();
    if (row >= most_rows) throw std::length_error("StageTable::add: more than 127 stages");
    added_.push_back(std::move(name));
    return static_cast<Stage>(row);
}

StageRow StageTable::row(Stage stage) const {
    const auto row = static_cast<std::size_t>(stage);
    if (row < named_stage_count) return named_rows[row].row;
    const std::size_t added = row - named_stage_count;
    const std::string_view name = added_.at(added);
    return {name, added < added_hues.size() ? name : "other stages"};
}

}  // namespace scb
