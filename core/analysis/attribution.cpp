#include "core/analysis/attribution.h"

#include "core/analysis/operation_cost.h"
#include "core/collide/query_placement.h"
#include "core/explain/exact_verdict.h"
#include "core/volumes/shape.h"
#include "scb/collide.h"

namespace scb {
namespace {

constexpr std::uint32_t none = TraversalTree::no_parent;

std::vector<std::uint32_t> positions(const Topology& topology) {
    std::vector<std::uint32_t> position(topology.order.size());
    for (std::uint32_t i = 0; i < position.size(); ++i) position[topology.order[i]] = i;
    return position;
}

bool holds(const Topology& topology, std::uint32_t node, std::uint32_t position) {
    const TopologyNode& n = topology.nodes[node];
    return position >= n.first && position - n.first < n.count;
}

/// For each test, the first of those that the division of its pair led to. They follow each other.
std::vector<std::uint32_t> first_children(const TraversalTree& tree) {
    std::vector<std::uint32_t> children(tree.parents.size(), none);
    for (std::size_t i = tree.parents.size(); i-- > 0;)
        if (tree.parents[i] != none) children[tree.parents[i]] = static_cast<std::uint32_t>(i);
    return children;
}

/// For each test, how many of the pairs of triangles that intersect its nodes hold.
std::vector<std::uint64_t> contacts_below(const Topology& a, const Topology& b,
                                          const TraceFrame& frame, const TraversalTree& tree,
                                          std::span<const IndexPair> contacts) {
    const std::vector<std::uint32_t> position_a = positions(a), position_b = positions(b),
                                     children = first_children(tree);
    const std::vector<VolumeTest>& tests = frame.events.volume_tests;
    std::vector<std::uint64_t> below(tests.size());
    for (const IndexPair& contact : contacts) {
        std::uint32_t test = tests.empty() ? none : 0;
        while (test != none) {
            ++below[test];
            const std::uint32_t parent = test;
            test = none;
            for (std::uint32_t child = children[parent];
                 child < tests.size() && tree.parents[child] == parent; ++child)
                if (holds(a, tests[child].nodes.a, position_a[contact.a]) &&
                    holds(b, tests[child].nodes.b, position_b[contact.b])) {
                    test = child;
                    break;
                }
        }
    }
    return below;
}

/// For each test, the work below it.
std::vector<Work> work_below(const TraceHeader& header, const TraceFrame& frame,
                             const TraversalTree& tree) {
    const std::vector<VolumeTest>& tests = frame.events.volume_tests;
    std::vector<Work> below(tests.size());
    for (const TriangleTest& test : frame.events.triangle_tests) ++below[test.after].triangle_tests;
    for (std::size_t i = tests.size(); i-- > 0;) {
        if (tree.parents[i] == none) continue;
        Work& parent = below[tree.parents[i]];
        parent += below[i];
        parent += {1, 0, operation_cost(header.volume, header.options.overlap, tests[i].stage)};
    }
    return below;
}

template <class V>
void add_verdicts(Attribution& result, const Hierarchy<V>& a, const Hierarchy<V>& b,
                  const TraceFrame& frame, const std::vector<std::uint64_t>& contacts) {
    const std::vector<VolumeTest>& tests = frame.events.volume_tests;
    const Placement placed = query_placement(a, b, frame.b_to_a);
    for (std::uint32_t i = 0; i < tests.size(); ++i) {
        const IndexPair nodes = tests[i].nodes;
        const ContactCertificate certificate =
            exact_verdict(shape_of(a.volumes[nodes.a]), shape_of(b.volumes[nodes.b]), placed);
        if (tests[i].stage != Stage::overlapping) {
            if (certificate.contact == Contact::overlapping || contacts[i] > 0)
                result.wrongly_rejected.push_back({i, contacts[i], certificate.contact});
            continue;
        }
        PassedPair pair;
        pair.test = i;
        pair.exact = certificate.contact;
        pair.leaves = a.topology->nodes[nodes.a].is_leaf() && b.topology->nodes[nodes.b].is_leaf();
        if (contacts[i] > 0) {
            pair.reason = PassReason::triangles_meet;
        } else if (certificate.contact == Contact::disjoint) {
            pair.reason = PassReason::weak_test;
            pair.gap = certificate.margin;
        } else {
            pair.reason = PassReason::loose_fit;
        }
        result.counts.touching += certificate.contact == Contact::touching;
        result.passed.push_back(pair);
    }
}

}  // namespace

Attribution attribute(const AnyHierarchy& a, const AnyHierarchy& b, const TraceHeader& header,
                      const TraceFrame& frame, const TraversalTree& tree,
                      std::span<const IndexPair> contacts) {
    const std::vector<std::uint64_t> contact =
        contacts_below(topology_of(a), topology_of(b), frame, tree, contacts);
    const std::vector<Work> below = work_below(header, frame, tree);
    Attribution result;
    std::visit(
        [&]<class V>(const Hierarchy<V>& hierarchy) {
            add_verdicts(result, hierarchy, std::get<Hierarchy<V>>(b), frame, contact);
        },
        a);
    PassCounts& counts = result.counts;
    counts.all = {frame.found.n_v, frame.found.n_p,
                  operation_count(header.volume, header.options.overlap, frame.found.stages)};
    counts.wrongly_rejected = result.wrongly_rejected.size();
    for (const WrongRejection& rejection : result.wrongly_rejected)
        counts.missed += rejection.missed;
    // Parents come before their children.
    std::vector<char> weak_so_far(frame.events.volume_tests.size());
    for (PassedPair& pair : result.passed) {
        pair.below = below[pair.test];
        const std::uint32_t parent = tree.parents[pair.test];
        if (parent != none) {
            pair.within_false_pair = contact[parent] == 0;
            pair.within_weak_test = weak_so_far[parent] != 0;
        }
        const bool weak = pair.reason == PassReason::weak_test;
        weak_so_far[pair.test] = weak || pair.within_weak_test;
        if (pair.reason != PassReason::triangles_meet && !pair.within_false_pair)
            counts.wasted += pair.below;
        if (weak && !pair.within_weak_test) counts.wasted_by_tests += pair.below;
        ++(pair.leaves ? counts.leaves : counts.inner)[static_cast<std::size_t>(pair.reason)];
    }
    return result;
}

std::vector<IndexPair> all_contacts(const AnyHierarchy& a, const Mesh& mesh_a,
                                    const AnyHierarchy& b, const Mesh& mesh_b,
                                    const TraceHeader& header, const TraceFrame& frame) {
    const bool sound = header.volume != VolumeKind::scb || is_sound(header.options.overlap.test);
    if (sound && frame.found.complete && header.options.stop_level < 0) return frame.found.pairs;
    return collide(a, mesh_a, b, mesh_b, frame.b_to_a).pairs;
}

}  // namespace scb
