#include "core/analysis/attribution.h"
#include "core/analysis/assumed_time.h"

#include <cassert>

#include "core/analysis/cost_equation.h"
#include "core/base/parallel_for.h"
#include "core/collide/query_placement.h"
#include "core/explain/exact_overlap.h"
#include "core/volumes/shape.h"
#include "scb/collide.h"

namespace scb {
namespace {

constexpr std::uint32_t none = no_step;

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
    std::vector<std::uint32_t> first, next;  ///< per step, or none

    explicit Followers(const std::vector<Step>& steps)
        : first(steps.size(), none), next(steps.size(), none) {
        for (std::size_t i = steps.size(); i-- > 0;) {
            if (steps[i].parent == none) continue;
            next[i] = first[steps[i].parent];
            first[steps[i].parent] = static_cast<std::uint32_t>(i);
        }
    }
};

/// For each test, the number of intersecting pairs of triangles below its nodes.
std::vector<std::uint64_t> contacts_below(const Topology& a, const Topology& b, QueryKind kind,
                                          const QueryTrace& frame,
                                          std::span<const IndexPair> contacts) {
    const std::vector<std::uint32_t> position_a = positions(a), position_b = positions(b);
    const std::vector<Step>& tests = frame.steps.volumes;
    const Followers followers(tests);
    // In a self query: per node, the root step of the node and its sibling.
    std::vector<std::uint32_t> roots(kind == QueryKind::self ? a.nodes.size() : 0, none);
    for (std::uint32_t i = 0; i < tests.size() && !roots.empty(); ++i)
        if (tests[i].parent == none) roots[tests[i].nodes.a] = i;
    const auto root_of = [&](IndexPair at) {
        if (roots.empty()) return tests.empty() ? none : 0;
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
        while (test != none) {
            ++below[test];
            const std::uint32_t parent = test;
            test = none;
            for (std::uint32_t child = followers.first[parent]; child != none;
                 child = followers.next[child])
                if (holds(a, tests[child].nodes.a, at.a) && holds(b, tests[child].nodes.b, at.b)) {
                    test = child;
                    break;
                }
        }
    }
    return below;
}

/// For each test, the work below it.
std::vector<Work> work_below(const TraceHeader& header, const QueryTrace& frame) {
    const std::vector<Step>& tests = frame.steps.volumes;
    std::vector<Work> below(tests.size());
    for (const ItemStep& test : frame.steps.items)
        below[test.step].triangle_tests += test.neighbors ? 0 : 1;
    for (std::size_t i = tests.size(); i-- > 0;) {
        if (tests[i].parent == none) continue;
        Work& parent = below[tests[i].parent];
        parent += below[i];
        parent +=
            {1, 0,
             header.engine ? 0
                           : operation_cost(header.volume, header.options.overlap, tests[i].stage)};
    }
    return below;
}

/// For each test, whether neighbors are below it: triangles of one body with a common vertex. They
/// are no pair, but no volumes and no test could keep them apart.
std::vector<char> neighbors_below(const QueryTrace& frame) {
    std::vector<char> below(frame.steps.volumes.size());
    for (const ItemStep& item : frame.steps.items)
        for (std::uint32_t i = item.neighbors ? item.step : none; i != none && below[i] == 0;
             i = frame.steps.volumes[i].parent)
            below[i] = 1;
    return below;
}

template <class V>
std::vector<TestedPair> tested_pairs(const Hierarchy<V>& a, const Hierarchy<V>& b,
                                     const QueryTrace& frame,
                                     const std::vector<std::uint64_t>& contacts) {
    const Placement placed = query_placement(a, b, frame.b_to_a);
    // A verdict takes microseconds, of some shapes more.
    constexpr std::size_t tests_in_block = 128;
    std::vector<TestedPair> pairs(contacts.size());
    parallel_blocks(
        processor_count(), pairs.size(),
        [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) {
                const Step& test = frame.steps.volumes[i];
                const IndexPair nodes = test.nodes;
                const auto& of_a = shape_of(a.volumes[nodes.a]);
                const auto& of_b = shape_of(b.volumes[nodes.b]);
                // The gap of a right rejection is not wanted: `attribute` skips such tests.
                if (test.stage != Stage::overlapping && contacts[i] == 0 &&
                    apart_along_centers(of_a, of_b, placed)) {
                    pairs[i].exact = Contact::disjoint;
                    continue;
                }
                const ContactCertificate certificate = exact_verdict(of_a, of_b, placed);
                pairs[i] = {
                    true, certificate.contact, certificate.margin, contacts[i],
                    a.topology->nodes[nodes.a].is_leaf() && b.topology->nodes[nodes.b].is_leaf()};
            }
        },
        tests_in_block);
    return pairs;
}

/// A passed pair, without `below` and the members that depend on other tests.
PassedPair passed_pair(std::uint32_t test, const TestedPair& of, bool meets) {
    PassedPair pair;
    pair.test = test;
    pair.exact = of.exact;
    pair.leaves = of.leaves;
    if (meets) {
        pair.reason = PassReason::triangles_meet;
    } else if (of.exact == Contact::disjoint) {
        pair.reason = PassReason::weak_test;
        pair.gap = of.gap;
    } else {
        pair.reason = PassReason::loose_fit;
    }
    return pair;
}

}  // namespace

Attribution attribute(const TraceHeader& header, const QueryTrace& frame,
                      std::span<const TestedPair> pairs) {
    const std::vector<Step>& tests = frame.steps.volumes;
    assert(pairs.size() == tests.size());
    const std::vector<Work> below = work_below(header, frame);
    Attribution result;
    PassCounts& counts = result.counts;
    counts.all = header.engine ? Work{frame.found.n_v, frame.found.n_p}
                               : work_of(header.volume, header.options.overlap,
                                         header.options.descent, frame.found);
    // Parents come before their children.
    std::vector<char> weak_so_far(tests.size());
    const std::vector<char> neighbors = neighbors_below(frame);
    const auto meets = [&](std::uint32_t i) { return pairs[i].contacts > 0 || neighbors[i] != 0; };
    for (std::uint32_t i = 0; i < tests.size(); ++i) {
        const TestedPair& of = pairs[i];
        if (!of.known) continue;
        if (tests[i].stage != Stage::overlapping) {
            if (of.exact != Contact::overlapping && of.contacts == 0) continue;
            result.wrongly_rejected.push_back({i, of.contacts, of.exact});
            ++counts.wrongly_rejected;
            counts.missed += of.contacts;
            continue;
        }
        PassedPair pair = passed_pair(i, of, meets(i));
        pair.below = below[i];
        if (const std::uint32_t parent = tests[i].parent; parent != none) {
            pair.within_false_pair = pairs[parent].known && !meets(parent);
            pair.within_weak_test = weak_so_far[parent] != 0;
        }
        const bool weak = pair.reason == PassReason::weak_test;
        weak_so_far[i] = weak || pair.within_weak_test;
        if (pair.reason != PassReason::triangles_meet && !pair.within_false_pair)
            counts.wasted += pair.below;
        if (weak && !pair.within_weak_test) counts.wasted_by_tests += pair.below;
        counts.touching += pair.exact == Contact::touching;
        ++(pair.leaves ? counts.leaves : counts.inner)[static_cast<std::size_t>(pair.reason)];
        result.passed.push_back(pair);
    }
    return result;
}

Attribution attribute(const AnyHierarchy& a, const AnyHierarchy& b, const TraceHeader& header,
                      const QueryTrace& frame, std::span<const IndexPair> contacts) {
    const std::vector<std::uint64_t> below =
        contacts_below(topology_of(a), topology_of(b), header.kind, frame, contacts);
    return std::visit(
        [&]<class V>(const Hierarchy<V>& hierarchy) {
            return attribute(header, frame,
                             tested_pairs(hierarchy, std::get<Hierarchy<V>>(b), frame, below));
        },
        a);
}

Collision asked_again(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                      const Mesh& mesh_b, const TraceHeader& header, const QueryTrace& frame,
                      const CollideOptions& options) {
    if (header.kind == QueryKind::self)
        return collide_self(a, mesh_a, joined_vertices(mesh_a), options);
    return collide(a, mesh_a, b, mesh_b, frame.b_to_a, options);
}

std::vector<IndexPair> all_contacts(const AnyHierarchy& a, const Mesh& mesh_a,
                                    const AnyHierarchy& b, const Mesh& mesh_b,
                                    const TraceHeader& header, const QueryTrace& frame) {
    const bool correct = header.volume != VolumeKind::scb || is_sound(header.options.overlap.test);
    if (correct && frame.found.complete && header.options.stop_level < 0) return frame.found.pairs;
    return asked_again(a, mesh_a, b, mesh_b, header, frame, {}).pairs;
}

}  // namespace scb
