#include "core/model/level_statistics.h"

#include <algorithm>

namespace scb {
namespace {

void count_covers(std::vector<LevelStatistics>& levels) {
    std::uint32_t leaves_above = 0;
    for (LevelStatistics& level : levels) {
        level.cover = level.volumes + leaves_above;
        leaves_above += level.leaves;
    }
}

}  // namespace

template <Volume V>
std::vector<LevelStatistics> level_statistics(const Hierarchy<V>& hierarchy) {
    const std::vector<std::uint16_t> depths = node_depths(*hierarchy.topology);
    std::vector<LevelStatistics> levels(*std::max_element(depths.begin(), depths.end()) +
                                        std::size_t{1});
    for (std::size_t i = 0; i < depths.size(); ++i) {
        LevelStatistics& level = levels[depths[i]];
        level.add(size_of(hierarchy.volumes[i]), hierarchy.topology->nodes[i].is_leaf());
        ++level.rules[static_cast<std::size_t>(hierarchy.topology->rules[i])];
    }
    count_covers(levels);
    return levels;
}

std::vector<LevelStatistics> level_statistics(const Tree& tree) {
    std::vector<LevelStatistics> levels(static_cast<std::size_t>(depth(tree.shape())) + 1);
    for (std::uint32_t node = 0; node < tree.size(); ++node)
        if (tree.shape().is_reachable(node))
            levels[tree.shape().depths[node]].add(
                tree.has_volume(node) ? tree.volume_size(node) : VolumeSize{}, tree.is_leaf(node));
    count_covers(levels);
    return levels;
}

VolumeStatistics cover_statistics(const Tree& tree, const std::vector<std::uint32_t>& cover) {
    VolumeStatistics statistics;
    for (const std::uint32_t node : cover)
        if (tree.has_volume(node)) statistics.add(tree.volume_size(node), tree.is_leaf(node));
    return statistics;
}

std::vector<VolumeStatistics> cover_statistics(const Tree& tree) {
    const TreeShape& shape = tree.shape();
    const std::size_t levels = static_cast<std::size_t>(depth(shape)) + 1;
    std::vector<VolumeStatistics> inner(levels), leaves(levels);
    for (std::uint32_t node = 0; node < tree.size(); ++node)
        if (shape.is_reachable(node) && tree.has_volume(node))
            (tree.is_leaf(node) ? leaves : inner)[shape.depths[node]].add(tree.volume_size(node),
                                                                          tree.is_leaf(node));
    VolumeStatistics above;
    for (std::size_t level = 0; level < levels; ++level) {
        above.add(leaves[level]);
        inner[level].add(above);
    }
    return inner;
}

std::vector<LevelStatistics> level_statistics(const AnyHierarchy& hierarchy) {
    return std::visit([](const auto& h) { return level_statistics(h); }, hierarchy);
}

#define SCB_INSTANTIATE(V) \
    template std::vector<LevelStatistics> level_statistics(const Hierarchy<V>&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
