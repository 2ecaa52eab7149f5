#include "render/web/query_blocks.h"

#include <algorithm>
#include <cassert>

namespace scb::render {
namespace {

/// Whether the nodes of all tests follow from their outcomes, as query.js has it.
bool follow_from_outcomes(const QueryBodies& bodies, const TraceFrame& frame,
                          const TraversalTree& tree) {
    const TreeShape &a = bodies[0].tree->shape(), &b = bodies[1].tree->shape();
    if (a.roots.size() != 1 || b.roots.size() != 1) return false;
    std::vector<IndexPair> divided;  // whose children are still to be tested: the last one first
    std::size_t next = 0;
    const auto visit = [&](IndexPair nodes) {
        if (next >= tree.outcomes.size() || frame.events.volume_tests[next].nodes != nodes)
            return false;
        const Outcome outcome = tree.outcomes[next];
        if (outcome == Outcome::divided_a || outcome == Outcome::divided_b)
            divided.push_back(nodes);
        ++next;
        return true;
    };
    std::vector<std::size_t> tests;  // of those in `divided`
    if (!visit({a.roots[0], b.roots[0]})) return false;
    if (!divided.empty()) tests.push_back(0);
    while (!divided.empty()) {
        const IndexPair nodes = divided.back();
        const bool of_a = tree.outcomes[tests.back()] == Outcome::divided_a;
        divided.pop_back();
        tests.pop_back();
        const TreeShape& shape = of_a ? a : b;
        for (std::uint32_t child = shape.first_child[of_a ? nodes.a : nodes.b]; child != no_index;
             child = shape.next_sibling[child]) {
            const std::size_t before = divided.size();
            if (!visit(of_a ? IndexPair{child, nodes.b} : IndexPair{nodes.a, child})) return false;
            if (divided.size() > before) tests.push_back(next - 1);
        }
    }
    return next == tree.outcomes.size();
}

constexpr std::uint8_t erred = 1 << 6, meets_here = 1 << 7;
static_assert(2 + most_groups <= erred);

/// Per test the bits of what it is worth.
std::vector<std::uint8_t> worth_bits(const TraversalTree& tree, const Attribution& attribution) {
    std::vector<std::uint8_t> bits(tree.outcomes.size());
    // Of what passed and is not judged nobody knows that it did in vain.
    std::vector<char> meets(bits.size());
    for (std::size_t i = 0; i < bits.size(); ++i) meets[i] = !is_rejection(tree.outcomes[i]);
    for (const PassedPair& pair : attribution.passed) {
        if (pair.reason == PassReason::weak_test) bits[pair.test] |= erred;
        meets[pair.test] = pair.reason == PassReason::triangles_meet;
    }
    for (const WrongRejection& rejection : attribution.wrongly_rejected) {
        bits[rejection.test] |= erred;
        meets[rejection.test] = rejection.missed > 0;
    }
    // Tests follow those that led to them.
    std::vector<char> followed(bits.size());
    for (std::size_t i = bits.size(); i-- > 0;) {
        if (meets[i] && !followed[i]) bits[i] |= meets_here;
        if (meets[i] && tree.parents[i] != TraversalTree::no_parent) followed[tree.parents[i]] = 1;
    }
    return bits;
}

}  // namespace

QueryBlocks query_blocks(const QueryBodies& bodies, const TraceFrame& frame,
                         const TraversalTree& tree, const Attribution& attribution,
                         const std::vector<EndingGroup>& groups, BlockStore& store) {
    std::vector<std::uint8_t> outcomes = worth_bits(tree, attribution);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const Outcome outcome = tree.outcomes[i];
        if (is_divided(outcome)) {
            outcomes[i] |= outcome == Outcome::divided_b ? 1 : 0;
            continue;
        }
        const auto group =
            std::find_if(groups.begin(), groups.end(), [outcome](const EndingGroup& g) {
                return std::find(g.endings.begin(), g.endings.end(), outcome) != g.endings.end();
            });
        assert(group != groups.end());
        outcomes[i] |= static_cast<std::uint8_t>(2 + (group - groups.begin()));
    }
    QueryBlocks result;
    if (!follow_from_outcomes(bodies, frame, tree)) {
        std::vector<std::uint32_t> nodes;
        for (std::size_t i = 0; i < tree.parents.size(); ++i) {
            const IndexPair of_test = frame.events.volume_tests[i].nodes;
            nodes.insert(nodes.end(), {of_test.a, of_test.b, tree.parents[i]});
        }
        result.nodes = store.add(nodes);
    }
    result.outcomes = store.add(outcomes);
    std::vector<std::uint32_t> pairs;
    for (const IndexPair pair : frame.found.pairs) pairs.insert(pairs.end(), {pair.a, pair.b});
    result.pairs = store.add(pairs);
    return result;
}

}  // namespace scb::render
