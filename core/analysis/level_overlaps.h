#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/hierarchy/tree_shape.h"
#include "scb/any_hierarchy.h"
#include "scb/observer.h"
#include "scb/overlap_options.h"
#include "scb/pose.h"

namespace scb {

/// Calls `use` with each child of a node, or with the node itself if it is a leaf, until `use`
/// returns false. Returns whether it never did.
template <class Use>
bool on_next_level(const TreeShape& shape, std::uint32_t node, const Use& use) {
    if (shape.is_leaf(node)) return use(node);
    for (std::uint32_t child = shape.first_child[node]; child != no_index;
         child = shape.next_sibling[child])
        if (!use(child)) return false;
    return true;
}

/// Per level, from the roots down, the number of overlapping pairs of a volume of A and a volume of
/// B. A level has the volumes of its level_cover. Only pairs below overlapping pairs are tested.
/// Ends with the first level without a pair, which shows a gap between the bodies, or with the
/// level of all leaves. Ends before a level of more than `most` pairs, or of more than 64 * `most`
/// tests. `overlap(node_of_a, node_of_b)` tests two nodes.
template <class Overlap>
std::vector<std::size_t> level_overlaps(const TreeShape& a, const TreeShape& b,
                                        const Overlap& overlap, std::size_t most) {
    const std::size_t most_tests = most > SIZE_MAX / 64 ? SIZE_MAX : 64 * most;
    std::vector<IndexPair> above, pairs;
    std::size_t tests = 0;
    const auto try_pair = [&](std::uint32_t x, std::uint32_t y) {
        if (++tests > most_tests) return false;
        if (overlap(x, y)) pairs.push_back({x, y});
        return pairs.size() <= most;
    };
    std::vector<std::size_t> counts;
    for (const std::uint32_t x : a.roots)
        for (const std::uint32_t y : b.roots)
            if (!try_pair(x, y)) return counts;
    counts.push_back(pairs.size());
    for (int left = std::max(depth(a), depth(b)); left > 0 && !pairs.empty(); --left) {
        above.swap(pairs);
        pairs.clear();
        tests = 0;
        for (const IndexPair pair : above)
            if (!on_next_level(a, pair.a, [&](std::uint32_t x) {
                    return on_next_level(b, pair.b,
                                         [&](std::uint32_t y) { return try_pair(x, y); });
                }))
                return counts;
        counts.push_back(pairs.size());
    }
    return counts;
}

/// The same for two hierarchies of one volume type, by an overlap test. The shapes belong to them.
std::vector<std::size_t> level_overlaps(const AnyHierarchy& a, const TreeShape& shape_a,
                                        const AnyHierarchy& b, const TreeShape& shape_b,
                                        const Pose& b_to_a, const OverlapOptions& test,
                                        std::size_t most);

}  // namespace scb
