#include "core/attribution.h"

#include "core/exact_overlap.h"
#include "core/operation_cost.h"
#include "core/placed_volume.h"

namespace scb {
namespace {

constexpr std::uint32_t none = TestTree::no_parent;

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
std::vector<std::uint32_t> first_children(const TestTree& tree) {
    std::vector<std::uint32_t> children(tree.parents.size(), none);
    for (std::size_t i = tree.parents.size(); i-- > 0;)
        if (tree.parents[i] != none) children[tree.parents[i]] = static_cast<std::uint32_t>(i);
    return children;
}

/// Which of the tests are of nodes that hold a pair of triangles which intersect, as far down as
/// pairs passed.
std::vector<char> tests_with_contact(const Topology& a, const Topology& b, const TraceFrame& frame,
                                     const TestTree& tree, std::span<const IndexPair> contacts) {
    const std::vector<std::uint32_t> position_a = positions(a), position_b = positions(b),
                                     children = first_children(tree);
    const std::vector<VolumeTest>& tests = frame.events.volume_tests;
    std::vector<char> marked(tests.size());
    for (const IndexPair& contact : contacts) {
        std::uint32_t test = tests.empty() ? none : 0;
        while (test != none) {
            marked[test] = 1;
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
    return marked;
}

/// For each test, the work below it.
std::vector<Work> work_below(const TraceHeader& header, const TraceFrame& frame,
                             const TestTree& tree) {
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
                  const TraceFrame& frame, const std::vector<char>& contact) {
    const std::vector<VolumeTest>& tests = frame.events.volume_tests;
    for (std::uint32_t i = 0; i < tests.size(); ++i) {
        const IndexPair nodes = tests[i].nodes;
        const ContactProof proof =
            exact_overlap(a.volumes[nodes.a], placed(b.volumes[nodes.b], frame.b_to_a));
        if (tests[i].stage != Stage::overlapping) {
            if (proof.contact == Contact::overlapping) result.wrongly_rejected.push_back(i);
            continue;
        }
        PassedPair pair;
        pair.test = i;
        pair.exact = proof.contact;
        pair.leaves = a.topology->nodes[nodes.a].is_leaf() && b.topology->nodes[nodes.b].is_leaf();
        if (contact[i]) {
            pair.reason = PassReason::contact;
        } else if (proof.contact == Contact::disjoint) {
            pair.reason = PassReason::weak_test;
            pair.gap = proof.margin;
        } else {
            pair.reason = PassReason::loose_fit;
        }
        result.touching += proof.contact == Contact::touching;
        result.passed.push_back(pair);
    }
}

}  // namespace

std::string_view pass_reason_name(PassReason reason) {
    switch (reason) {
        case PassReason::weak_test:
            return "test";
        case PassReason::loose_fit:
            return "fit";
        case PassReason::contact:
            break;
    }
    return "true";
}

Work& Work::operator+=(const Work& other) {
    volume_tests += other.volume_tests;
    triangle_tests += other.triangle_tests;
    operations += other.operations;
    return *this;
}

std::uint64_t Attribution::count(PassReason reason) const {
    return inner[static_cast<std::size_t>(reason)] + leaves[static_cast<std::size_t>(reason)];
}

Attribution attribute(const AnyHierarchy& a, const AnyHierarchy& b, const TraceHeader& header,
                      const TraceFrame& frame, const TestTree& tree,
                      std::span<const IndexPair> contacts) {
    const std::vector<char> contact =
        tests_with_contact(topology_of(a), topology_of(b), frame, tree, contacts);
    const std::vector<Work> below = work_below(header, frame, tree);
    Attribution result;
    std::visit(
        [&]<class V>(const Hierarchy<V>& hierarchy) {
            add_verdicts(result, hierarchy, std::get<Hierarchy<V>>(b), frame, contact);
        },
        a);
    const std::vector<VolumeTest>& tests = frame.events.volume_tests;
    for (std::size_t i = 0; i < tests.size(); ++i)
        result.all += {1, 0, operation_cost(header.volume, header.options.overlap, tests[i].stage)};
    result.all.triangle_tests = frame.events.triangle_tests.size();
    // Parents come before their children.
    std::vector<char> weak_so_far(tests.size());
    for (PassedPair& pair : result.passed) {
        pair.below = below[pair.test];
        const std::uint32_t parent = tree.parents[pair.test];
        if (parent != none) {
            pair.within_false_pair = !contact[parent];
            pair.within_weak_test = weak_so_far[parent] != 0;
        }
        const bool weak = pair.reason == PassReason::weak_test;
        weak_so_far[pair.test] = weak || pair.within_weak_test;
        if (pair.reason != PassReason::contact && !pair.within_false_pair)
            result.wasted += pair.below;
        if (weak && !pair.within_weak_test) result.wasted_by_tests += pair.below;
        ++(pair.leaves ? result.leaves : result.inner)[static_cast<std::size_t>(pair.reason)];
    }
    return result;
}

}  // namespace scb
