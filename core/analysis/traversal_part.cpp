#include "core/analysis/traversal_part.h"

#include <algorithm>

namespace scb {

TraceFrame with_tests(const TraceHeader& header, const TraceFrame& frame, const TraversalTree& tree,
                      const std::vector<std::uint32_t>& chosen) {
    TraceFrame result{frame.frame, frame.b_to_a, {}, {}};
    result.trees = frame.trees;
    const std::vector<TriangleTest>& triangle_tests = frame.events.triangle_tests;
    Collision& found = result.found;
    // Where the tests of another engine are now.
    std::vector<std::uint32_t> place(header.engine ? tree.parents.size() : 0,
                                     TraversalTree::no_parent);
    std::size_t next = 0;
    for (const std::uint32_t i : chosen) {
        const VolumeTest& test = frame.events.volume_tests[i];
        if (!is_foreign(test.stage)) ++found.stages[static_cast<std::size_t>(test.stage)];
        found.depth = std::max(found.depth, test.depth_a + test.depth_b);
        if (tree.outcomes[i] == Outcome::found) found.pairs.push_back(test.nodes);
        while (next < triangle_tests.size() && triangle_tests[next].after < i) ++next;
        for (; next < triangle_tests.size() && triangle_tests[next].after == i; ++next) {
            TriangleTest of_leaves = triangle_tests[next];
            of_leaves.after = static_cast<std::uint32_t>(result.events.volume_tests.size());
            result.events.triangle_tests.push_back(of_leaves);
            ++found.n_p;
            if (of_leaves.intersect) found.pairs.push_back(of_leaves.triangles);
        }
        if (header.engine) {
            const std::uint32_t parent = tree.parents[i];
            place[i] = static_cast<std::uint32_t>(result.events.volume_tests.size());
            result.parents.push_back(parent == TraversalTree::no_parent ? parent : place[parent]);
        }
        result.events.volume_tests.push_back(test);
    }
    found.n_v = chosen.size();
    if (!header.engine)
        found.n_u = transform_count(header.volume, found.stages, header.options.overlap);
    found.complete = frame.found.complete;
    std::sort(found.pairs.begin(), found.pairs.end());
    found.pairs.erase(std::unique(found.pairs.begin(), found.pairs.end()), found.pairs.end());
    return result;
}

std::optional<std::uint32_t> test_of(const Events& events, IndexPair nodes) {
    for (std::uint32_t i = 0; i < events.volume_tests.size(); ++i)
        if (events.volume_tests[i].nodes == nodes) return i;
    return std::nullopt;
}

TraceFrame traversal_part(const TraceHeader& header, const TraceFrame& frame,
                          const TraversalTree& tree, std::uint32_t root) {
    std::vector<char> below(tree.parents.size());
    std::vector<std::uint32_t> chosen;
    // Parents come before their children.
    for (std::uint32_t i = root; i < tree.parents.size(); ++i) {
        const std::uint32_t parent = tree.parents[i];
        below[i] = i == root || (parent != TraversalTree::no_parent && below[parent]);
        if (below[i]) chosen.push_back(i);
    }
    return with_tests(header, frame, tree, chosen);
}

std::vector<std::uint32_t> largest_parts(const TraversalTree& tree, std::size_t most) {
    const std::vector<std::uint32_t> sizes = subtree_sizes(tree);
    std::vector<std::uint32_t> parts;
    if (sizes.empty()) return parts;
    const auto small = [&](std::uint32_t i) { return 4 * std::uint64_t{sizes[i]} <= sizes.size(); };
    // Of another engine there may be several roots.
    for (std::uint32_t i = 0; i < sizes.size(); ++i)
        if (small(i) && (tree.parents[i] == TraversalTree::no_parent || !small(tree.parents[i])))
            parts.push_back(i);
    std::stable_sort(parts.begin(), parts.end(),
                     [&](std::uint32_t x, std::uint32_t y) { return sizes[x] > sizes[y]; });
    parts.resize(std::min(parts.size(), most));
    return parts;
}

}  // namespace scb
