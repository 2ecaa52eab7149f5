#include "core/level_statistics.h"

#include <algorithm>

namespace scb {

template <Volume V>
std::vector<LevelStatistics> level_statistics(const Hierarchy<V>& hierarchy) {
    const std::vector<std::uint16_t> depths = node_depths(*hierarchy.topology);
    std::vector<LevelStatistics> levels(*std::max_element(depths.begin(), depths.end()) +
                                        std::size_t{1});
    for (std::size_t i = 0; i < depths.size(); ++i) {
        LevelStatistics& level = levels[depths[i]];
        const V& v = hierarchy.volumes[i];
        ++level.nodes;
        level.leaves += hierarchy.topology->nodes[i].is_leaf();
        level.mean_diameter += diameter(v);
        level.mean_thickness += thickness(v);
        level.max_diameter = std::max(level.max_diameter, diameter(v));
        level.max_thickness = std::max(level.max_thickness, thickness(v));
        level.area += surface_area(v);
        level.volume += volume(v);
        ++level.rules[static_cast<std::size_t>(hierarchy.topology->rules[i])];
    }
    for (LevelStatistics& level : levels) {
        level.mean_diameter /= level.nodes;
        level.mean_thickness /= level.nodes;
    }
    return levels;
}

template std::vector<LevelStatistics> level_statistics(const Hierarchy<Scb>&);
template std::vector<LevelStatistics> level_statistics(const Hierarchy<Ball>&);
template std::vector<LevelStatistics> level_statistics(const Hierarchy<Obb>&);

}  // namespace scb
