#include "core/analysis/triangle_heat.h"

#include <cassert>

#include "core/analysis/traversal_tree.h"

namespace scb {

std::vector<bool> wasted_tests(const Events& events, std::span<const IndexPair> found) {
    // A query that was to stop at a level has pairs of nodes, and has tested no triangles.
    const bool nodes = events.triangle_tests.empty();
    const TraversalTree tree = traversal_tree(events, nodes ? found : std::span<const IndexPair>());
    const auto is_true = [](Outcome outcome) {
        return outcome == Outcome::triangles_meet || outcome == Outcome::found;
    };
    std::vector<bool> meets(tree.parents.size()), wasted(tree.parents.size());
    // Parents come before their children.
    for (std::size_t i = meets.size(); i-- > 0;) {
        if (is_true(tree.outcomes[i])) meets[i] = true;
        if (meets[i] && tree.parents[i] != TraversalTree::no_parent) meets[tree.parents[i]] = true;
    }
    for (std::size_t i = 0; i < meets.size(); ++i)
        wasted[i] = tree.parents[i] != TraversalTree::no_parent && !meets[tree.parents[i]];
    return wasted;
}

std::vector<std::uint32_t> triangle_heat(const Events& events, const Topology& topology,
                                         std::size_t side, HeatOf of,
                                         const std::vector<bool>& wasted) {
    assert((of != HeatOf::wasted || wasted.size() == events.volume_tests.size()) &&
           "which tests are wasted is known");
    std::vector<std::uint32_t> heat(topology.order.size());
    const auto index_on_side = [side](const IndexPair& pair) {
        return side == 0 ? pair.a : pair.b;
    };
    if (of == HeatOf::triangles) {
        for (const TriangleTest& test : events.triangle_tests)
            ++heat[index_on_side(test.triangles)];
        return heat;
    }
    std::vector<std::uint32_t> tests(topology.nodes.size());
    for (std::size_t i = 0; i < events.volume_tests.size(); ++i)
        if (of != HeatOf::wasted || wasted[i]) ++tests[index_on_side(events.volume_tests[i].nodes)];
    // Parents come before their children: what was tested of a node was tested of all below it.
    for (std::size_t i = 0; i < topology.nodes.size(); ++i) {
        const TopologyNode& node = topology.nodes[i];
        if (node.is_leaf()) {
            heat[topology.order[node.first]] = tests[i];
            continue;
        }
        tests[node.left] += tests[i];
        tests[node.left + 1] += tests[i];
    }
    return heat;
}

}  // namespace scb
