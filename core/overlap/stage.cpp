#include "scb/stage.h"

#include <numeric>

#include "core/base/enum_names.h"

namespace scb {
namespace {

constexpr EnumNames<Stage, stage_count> stage_names = {
    "overlapping",   "ball-ball",     "slab-ball",   "ball-slab",  "slab-cylinder", "cylinder-slab",
    "slab-a",        "slab-b",        "center-line", "axis-a0",    "axis-a1",       "axis-a2",
    "axis-b0",       "axis-b1",       "axis-b2",     "axis-a0xb0", "axis-a0xb1",    "axis-a0xb2",
    "axis-a1xb0",    "axis-a1xb1",    "axis-a1xb2",  "axis-a2xb0", "axis-a2xb1",    "axis-a2xb2",
    "second-slab-a", "second-slab-b", "long-axes",   "search"};
static_assert(static_cast<std::size_t>(Stage::search) + 1 == stage_count);

}  // namespace

std::uint64_t test_count(const StageCounts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

std::string_view stage_name(Stage stage) { return stage_names[stage]; }
std::optional<Stage> stage_of(std::string_view name) { return stage_names.find(name); }

}  // namespace scb
