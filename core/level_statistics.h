#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/hierarchy.h"

namespace scb {

/// The quality of one level of a hierarchy: its nodes at one depth. Lengths are those of
/// Section 3.1 of the paper, the diameter d = 2r and the thickness tau = e - f (for an OBB the
/// diagonal and the shortest side); in the mesh's units.
struct LevelStatistics {
    std::uint32_t nodes = 0;
    std::uint32_t leaves = 0;  ///< of the nodes
    double mean_diameter = 0, max_diameter = 0;
    double mean_thickness = 0, max_thickness = 0;
    double area = 0, volume = 0;                          ///< summed over the nodes
    std::array<std::uint32_t, split_rule_count> rules{};  ///< nodes per SplitRule
};

/// One entry per level, root first. Sums run in the order of the nodes.
template <Volume V>
std::vector<LevelStatistics> level_statistics(const Hierarchy<V>& hierarchy);

}  // namespace scb
