#include "core/analysis/level_overlaps.h"

#include <algorithm>

#include "core/collide/query_placement.h"
#include "core/overlap/test_functors.h"
#include "scb/observer.h"

namespace scb {
namespace {

/// What stands for a node on the next level: its children, or a leaf itself.
std::vector<std::uint32_t> next_level(const TreeShape& shape, std::uint32_t node) {
    if (shape.is_leaf(node)) return {node};
    std::vector<std::uint32_t> children;
    for (std::uint32_t child = shape.first_child[node]; child != no_index;
         child = shape.next_sibling[child])
        children.push_back(child);
    return children;
}

}  // namespace

std::vector<std::size_t> level_overlaps(
    const TreeShape& a, const TreeShape& b,
    const std::function<bool(std::uint32_t, std::uint32_t)>& overlap, std::size_t most) {
    std::vector<IndexPair> pairs;
    const auto try_pair = [&](std::uint32_t x, std::uint32_t y) {
        if (overlap(x, y)) pairs.push_back({x, y});
    };
    for (const std::uint32_t x : a.roots)
        for (const std::uint32_t y : b.roots) try_pair(x, y);
    std::vector<std::size_t> counts;
    const int levels = std::max(depth(a), depth(b));
    for (int level = 0; pairs.size() <= most; ++level) {
        counts.push_back(pairs.size());
        if (pairs.empty() || level == levels) break;
        std::vector<IndexPair> above;
        above.swap(pairs);
        for (const IndexPair pair : above) {
            const std::vector<std::uint32_t> of_b = next_level(b, pair.b);
            for (const std::uint32_t x : next_level(a, pair.a))
                for (const std::uint32_t y : of_b) {
                    try_pair(x, y);
                    if (pairs.size() > most) return counts;
                }
        }
    }
    return counts;
}

std::vector<std::size_t> level_overlaps(const AnyHierarchy& a, const AnyHierarchy& b,
                                        const Pose& b_to_a, const OverlapOptions& test,
                                        std::size_t most) {
    return std::visit(
        [&]<Volume V>(const Hierarchy<V>& of_a) {
            const auto& of_b = std::get<Hierarchy<V>>(b);
            const Placement placed = query_placement(of_a, of_b, b_to_a);
            return with_overlap_test<V>(test, [&](auto overlap) {
                return level_overlaps(
                    tree_shape(*of_a.topology), tree_shape(*of_b.topology),
                    [&](std::uint32_t x, std::uint32_t y) {
                        return overlap(of_a.volumes[x], of_b.volumes[y], placed) ==
                               Stage::overlapping;
                    },
                    most);
            });
        },
        a);
}

}  // namespace scb
