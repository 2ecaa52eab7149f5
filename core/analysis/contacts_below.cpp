#include "core/analysis/contacts_below.h"

#include <utility>

namespace scb {
namespace {

std::vector<std::uint32_t> positions(const Topology& topology) {
    std::vector<std::uint32_t> position(topology.order.size());
    for (std::uint32_t i = 0; i < position.size(); ++i) position[topology.order[i]] = i;
    return position;
}

bool holds(const Topology& topology, std::uint32_t node, std::uint32_t position) {
    const TopologyNode& n = topology.nodes[node];
    return position >= n.first && position - n.first < n.count;
}

/// The steps that follow from each step.
struct Followers {
    std::vector<std::uint32_t> first, next;  ///< per step, or no_step

    explicit Followers(const std::vector<Step>& steps)
        : first(steps.size(), no_step), next(steps.size(), no_step) {
        for (std::size_t i = steps.size(); i-- > 0;) {
            if (steps[i].parent == no_step) continue;
            next[i] = first[steps[i].parent];
            first[steps[i].parent] = static_cast<std::uint32_t>(i);
        }
    }
};

}  // namespace

std::vector<std::uint64_t> contacts_below(const Topology& a, const Topology& b, QueryKind kind,
                                          const Steps& steps, std::span<const IndexPair> contacts) {
    const std::vector<std::uint32_t> position_a = positions(a), position_b = positions(b);
    const std::vector<Step>& tests = steps.volumes;
    const Followers followers(tests);
    // In a self query: per node, the root step of the node and its sibling.
    std::vector<std::uint32_t> roots(kind == QueryKind::self ? a.nodes.size() : 0, no_step);
    for (std::uint32_t i = 0; i < tests.size() && !roots.empty(); ++i)
        if (tests[i].parent == no_step) roots[tests[i].nodes.a] = i;
    const auto root_of = [&](IndexPair at) {
        if (roots.empty()) return tests.empty() ? no_step : 0;
        std::uint32_t left = a.nodes[0].left;
        while (holds(a, left, at.a) == holds(a, left, at.b))
            left = a.nodes[holds(a, left, at.a) ? left : left + 1].left;
        return roots[left];
    };
    std::vector<std::uint64_t> below(tests.size());
    for (const IndexPair& contact : contacts) {
        IndexPair at{position_a[contact.a], position_b[contact.b]};
        // The left triangle is below the first node of each step.
        if (!roots.empty() && at.a > at.b) std::swap(at.a, at.b);
        std::uint32_t test = root_of(at);
        while (test != no_step) {
            ++below[test];
            const std::uint32_t parent = test;
            test = no_step;
            for (std::uint32_t child = followers.first[parent]; child != no_step;
                 child = followers.next[child])
                if (holds(a, tests[child].nodes.a, at.a) && holds(b, tests[child].nodes.b, at.b)) {
                    test = child;
                    break;
                }
        }
    }
    return below;
}

}  // namespace scb
