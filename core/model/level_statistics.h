#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/model/tree.h"
#include "scb/any_hierarchy.h"

namespace scb {

/// Statistics of a set of volumes. Lengths are as in Section 3.1 of the paper, in the mesh's units:
/// the diameter d = 2r and the thickness tau = e - f; for an OBB, the diagonal and the shortest
/// side. Sums run in the order in which volumes were added.
struct VolumeStatistics {
    std::uint32_t volumes = 0;
    std::uint32_t leaves = 0;  ///< of the volumes
    double diameter_sum = 0, max_diameter = 0;
    double thickness_sum = 0, max_thickness = 0;
    double area = 0, volume = 0;  ///< summed

    double mean_diameter() const { return volumes == 0 ? 0 : diameter_sum / volumes; }
    double mean_thickness() const { return volumes == 0 ? 0 : thickness_sum / volumes; }

    void add(const VolumeSize& size, bool is_leaf) {
        add({1, is_leaf ? 1u : 0u, size.diameter, size.diameter, size.thickness, size.thickness,
             size.area, size.volume});
    }

    void add(const VolumeStatistics& other) {
        volumes += other.volumes;
        leaves += other.leaves;
        diameter_sum += other.diameter_sum;
        thickness_sum += other.thickness_sum;
        max_diameter = std::max(max_diameter, other.max_diameter);
        max_thickness = std::max(max_thickness, other.max_thickness);
        area += other.area;
        volume += other.volume;
    }
};

/// The quality of one level of a hierarchy: its nodes at one depth.
struct LevelStatistics : VolumeStatistics {
    std::array<std::uint32_t, split_rule_count> rules{};  ///< nodes per SplitRule
    std::uint32_t cover = 0;  ///< size of level_cover: the nodes, and the leaves above them
};

/// One entry per level, root first. Sums run in the order of the nodes.
template <Volume V>
std::vector<LevelStatistics> level_statistics(const Hierarchy<V>& hierarchy);

/// Statistics of the volumes of a cover; nodes without a volume are left out.
VolumeStatistics cover_statistics(const Tree& tree, const std::vector<std::uint32_t>& cover);

/// The same for the covers of all levels, see level_cover; root first. O(n).
std::vector<VolumeStatistics> cover_statistics(const Tree& tree);

std::vector<LevelStatistics> level_statistics(const AnyHierarchy& hierarchy);
/// The same for any tree: without rules.
std::vector<LevelStatistics> level_statistics(const Tree& tree);

}  // namespace scb
