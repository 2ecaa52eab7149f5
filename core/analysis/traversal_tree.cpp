#include "core/analysis/traversal_tree.h"

#include <algorithm>
#include <cassert>

namespace scb {

TraversalTree traversal_tree(const Events& events, std::span<const IndexPair> found_nodes) {
    const std::vector<VolumeTest>& tests = events.volume_tests;
    TraversalTree tree;
    tree.parents.reserve(tests.size());
    tree.outcomes.reserve(tests.size());
    std::vector<std::uint32_t> pending;
    std::size_t next_triangles = 0;
    const auto visit = [&](std::uint32_t parent) {
        const auto index = static_cast<std::uint32_t>(tree.parents.size());
        const VolumeTest& test = tests[index];
        Outcome outcome = rejected_at(test.stage);
        if (test.stage == Stage::overlapping) {
            if (next_triangles < events.triangle_tests.size() &&
                events.triangle_tests[next_triangles].after == index) {
                outcome = events.triangle_tests[next_triangles].intersect
                              ? Outcome::triangles_meet
                              : Outcome::triangles_apart;
                ++next_triangles;
            } else if (std::binary_search(found_nodes.begin(), found_nodes.end(), test.nodes)) {
                outcome = Outcome::found;
            } else {
                outcome = Outcome::left_over;
                pending.push_back(index);
            }
        }
        tree.parents.push_back(parent);
        tree.outcomes.push_back(outcome);
    };
    if (!tests.empty()) visit(TraversalTree::no_parent);
    while (tree.parents.size() < tests.size()) {
        assert(!pending.empty() && "the events are those of one query");
        const std::uint32_t parent = pending.back();
        pending.pop_back();
        const bool divides_a = tests[tree.parents.size()].depth_a != tests[parent].depth_a;
        tree.outcomes[parent] = divides_a ? Outcome::divided_a : Outcome::divided_b;
        visit(parent);
        if (tree.parents.size() < tests.size()) visit(parent);
    }
    return tree;
}

TraversalTree traversal_tree(const Events& events, std::span<const IndexPair> found_nodes,
                             std::span<const std::uint32_t> parents) {
    const std::vector<VolumeTest>& tests = events.volume_tests;
    assert(parents.size() == tests.size() && "each test has a place");
    TraversalTree tree;
    tree.parents.assign(parents.begin(), parents.end());
    for (const VolumeTest& test : tests)
        tree.outcomes.push_back(
            test.stage != Stage::overlapping ? rejected_at(test.stage)
            : std::binary_search(found_nodes.begin(), found_nodes.end(), test.nodes)
                ? Outcome::found
                : Outcome::left_over);
    for (std::uint32_t i = 0; i < tests.size(); ++i) {
        if (parents[i] == TraversalTree::no_parent) continue;
        Outcome& parent = tree.outcomes[parents[i]];
        if (parent != Outcome::left_over && !is_divided(parent)) continue;
        const IndexPair nodes = tests[i].nodes, above = tests[parents[i]].nodes;
        const Outcome divided = nodes.a == above.a   ? Outcome::divided_b
                                : nodes.b == above.b ? Outcome::divided_a
                                                     : Outcome::divided_both;
        parent =
            parent == Outcome::left_over || parent == divided ? divided : Outcome::divided_both;
    }
    for (const TriangleTest& test : events.triangle_tests) {
        Outcome& leaves = tree.outcomes[test.after];
        if (is_rejection(leaves)) continue;  // the engine contradicts itself
        if (test.intersect)
            leaves = Outcome::triangles_meet;
        else if (leaves != Outcome::triangles_meet)
            leaves = Outcome::triangles_apart;
    }
    return tree;
}

std::vector<std::uint32_t> subtree_sizes(const TraversalTree& tree) {
    std::vector<std::uint32_t> sizes(tree.parents.size(), 1);
    // Parents come before their children.
    for (std::size_t i = sizes.size(); i-- > 0;)
        if (tree.parents[i] != TraversalTree::no_parent) sizes[tree.parents[i]] += sizes[i];
    return sizes;
}

}  // namespace scb
