#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/hierarchy/volume_statistics.h"
#include "scb/hierarchy.h"

namespace scb {

/// The quality of one level of a hierarchy: its nodes at one depth.
struct LevelStatistics : VolumeStatistics {
    std::array<std::uint32_t, split_rule_count> rules{};  ///< nodes per SplitRule
    std::uint32_t cover = 0;  ///< size of level_cover: the nodes, and the leaves above them
};

/// One entry per level, root first. Sums run in the order of the nodes.
template <Volume V>
std::vector<LevelStatistics> level_statistics(const Hierarchy<V>& hierarchy);

}  // namespace scb
