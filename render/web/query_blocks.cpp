#include "render/web/query_blocks.h"

#include <algorithm>
#include <cassert>

namespace scb::render {
namespace {

/// Whether query.js predicts the nodes and the parents of all steps: first the roots, then all
/// children of the pair that was divided last.
bool are_predicted(const QueryBodies& bodies, const Steps& steps, const Outcomes& outcomes) {
    const TreeShape &a = bodies[0].tree->shape(), &b = bodies[1].tree->shape();
    if (a.roots.size() != 1 || b.roots.size() != 1) return false;
    const std::vector<Step>& volumes = steps.volumes;
    std::vector<std::uint32_t> divided;
    std::uint32_t next = 0;
    const auto visit = [&](IndexPair nodes, std::uint32_t parent) {
        if (next >= volumes.size() || volumes[next].nodes != nodes ||
            volumes[next].parent != parent)
            return false;
        const Stage outcome = outcomes[next];
        if (outcome == Stage::divided_a || outcome == Stage::divided_b) divided.push_back(next);
        ++next;
        return true;
    };
    if (!visit({a.roots[0], b.roots[0]}, no_step)) return false;
    while (!divided.empty()) {
        const std::uint32_t parent = divided.back();
        divided.pop_back();
        const IndexPair nodes = volumes[parent].nodes;
        const bool of_a = outcomes[parent] == Stage::divided_a;
        const TreeShape& shape = of_a ? a : b;
        for (std::uint32_t child = shape.first_child[of_a ? nodes.a : nodes.b]; child != no_index;
             child = shape.next_sibling[child])
            if (!visit(of_a ? IndexPair{child, nodes.b} : IndexPair{nodes.a, child}, parent))
                return false;
    }
    return next == volumes.size();
}

constexpr std::uint8_t erred = 1 << 6, meets_here = 1 << 7;
static_assert(2 + most_groups <= erred);

/// Per test the bits of its verdict.
std::vector<std::uint8_t> worth_bits(const Steps& steps, const Outcomes& outcomes,
                                     const Attribution& attribution) {
    std::vector<std::uint8_t> bits(outcomes.size());
    // A pair that passed and is not judged may have passed rightly.
    std::vector<char> meets(bits.size());
    for (std::size_t i = 0; i < bits.size(); ++i) meets[i] = !is_rejection(outcomes[i]);
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
        if (const std::uint32_t parent = steps.volumes[i].parent; meets[i] && parent != no_step)
            followed[parent] = 1;
    }
    return bits;
}

}  // namespace

QueryBlocks query_blocks(const QueryBodies& bodies, const QueryTrace& frame,
                         const Outcomes& outcomes, const Attribution& attribution,
                         const std::vector<EndingGroup>& groups, BlockStore& store) {
    std::vector<std::uint8_t> bytes = worth_bits(frame.steps, outcomes, attribution);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const Stage outcome = outcomes[i];
        if (is_divided(outcome)) {
            bytes[i] |= outcome == Stage::divided_b ? 1 : 0;
            continue;
        }
        const auto group =
            std::find_if(groups.begin(), groups.end(), [outcome](const EndingGroup& g) {
                return std::find(g.endings.begin(), g.endings.end(), outcome) != g.endings.end();
            });
        assert(group != groups.end());
        bytes[i] |= static_cast<std::uint8_t>(2 + (group - groups.begin()));
    }
    QueryBlocks result;
    if (!are_predicted(bodies, frame.steps, outcomes)) {
        std::vector<std::uint32_t> nodes;
        for (const Step& step : frame.steps.volumes)
            nodes.insert(nodes.end(), {step.nodes.a, step.nodes.b, step.parent});
        result.nodes = store.add(nodes);
    }
    result.outcomes = store.add(bytes);
    std::vector<std::uint32_t> pairs;
    for (const IndexPair pair : frame.found.pairs) pairs.insert(pairs.end(), {pair.a, pair.b});
    result.pairs = store.add(pairs);
    return result;
}

}  // namespace scb::render
