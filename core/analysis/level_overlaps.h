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

/// Calls `use` with what stands for a node on the next level, its children or a leaf itself, as
/// long as it returns true; returns whether it did.
template <class Use>
bool on_next_level(const TreeShape& shape, std::uint32_t node, const Use& use) {
    if (shape.is_leaf(node)) return use(node);
    for (std::uint32_t child = shape.first_child[node]; child != no_index;
         child = shape.next_sibling[child])
        if (!use(child)) return false;
    return true;
}

/// Level by level, from the roots down, how many pairs of a volume of A's level and one of B's, as
/// level_cover has them, overlap; of those only below pairs that overlap on the level above. Ends
/// with the first level of none, which shows a gap between the two; or with that of all leaves, or
/// before the first level of more than `most` pairs, or of more than 64 tests for each of these.
/// `overlap` is asked of two nodes.
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

/// The same of two hierarchies of one type of volumes, by an overlap test. The shapes are theirs.
std::vector<std::size_t> level_overlaps(const AnyHierarchy& a, const TreeShape& shape_a,
                                        const AnyHierarchy& b, const TreeShape& shape_b,
                                        const Pose& b_to_a, const OverlapOptions& test,
                                        std::size_t most);

}  // namespace scb
