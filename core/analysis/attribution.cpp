#include "core/analysis/attribution.h"
#include "core/analysis/assumed_time.h"
#include "core/analysis/contacts_below.h"

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

/// Whether the operations of the tests are not known: of another engine's, and of bounds.
bool has_no_operations(const TraceHeader& header) {
    return header.engine || is_of_distance(header.kind);
}

Work work_of_test(const TraceHeader& header, const Step& test) {
    return {1, 0,
            has_no_operations(header)
                ? 0
                : operation_cost(header.volume, header.options.overlap, test.stage)};
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
        parent += work_of_test(header, tests[i]);
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

PassReason reason_of(const TestedPair& pair, bool meets, QueryKind kind) {
    if (meets) return PassReason::triangles_meet;
    if (pair.early) return PassReason::early;
    if (pair.exact == Contact::disjoint) return PassReason::weak_test;
    // Volumes that touch may or may not be as near as the answer.
    const bool is_open = is_of_distance(kind) && pair.exact == Contact::touching;
    return is_open ? PassReason::unjudged : PassReason::loose_fit;
}

}  // namespace

Attribution attribute(const TraceHeader& header, const QueryTrace& frame,
                      std::span<const TestedPair> pairs) {
    const std::vector<Step>& tests = frame.steps.volumes;
    assert(pairs.size() == tests.size());
    const std::vector<Work> below = work_below(header, frame);
    Attribution result;
    PassCounts& counts = result.counts;
    counts.all = has_no_operations(header) ? Work{frame.found.n_v, frame.found.n_p}
                                           : work_of(header.volume, header.options.overlap,
                                                     header.options.descent, frame.found);
    // Why tests that a pair leads to are wasted. Parents come before their children.
    std::vector<PassReason> below_pair(tests.size(), PassReason::triangles_meet);
    result.wasted_by = below_pair;
    const std::vector<char> neighbors = neighbors_below(frame);
    for (std::uint32_t i = 0; i < tests.size(); ++i) {
        const TestedPair& of = pairs[i];
        if (const std::uint32_t parent = tests[i].parent; parent != none) {
            result.wasted_by[i] = below_pair[i] = below_pair[parent];
            counts.waste(below_pair[i], work_of_test(header, tests[i]));
        }
        if (!of.known) continue;
        if (tests[i].stage != Stage::overlapping) {
            if (of.exact != Contact::overlapping && of.contacts == 0) continue;
            result.wrongly_rejected.push_back({i, of.contacts, of.exact});
            ++counts.wrongly_rejected;
            counts.missed += of.contacts;
            continue;
        }
        const bool meets = of.contacts > 0 || neighbors[i] != 0;
        PassedPair pair;
        pair.test = i;
        pair.reason = reason_of(of, meets, header.kind);
        pair.leaves = of.leaves;
        pair.exact = of.exact;
        if (pair.reason == PassReason::weak_test || pair.reason == PassReason::early)
            pair.gap = of.gap;
        pair.below = below[i];
        pair.within = below_pair[i];
        below_pair[i] = governing_reason(below_pair[i], pair.reason);
        counts.touching += pair.exact == Contact::touching;
        ++(pair.leaves ? counts.leaves : counts.inner)[static_cast<std::size_t>(pair.reason)];
        result.passed.push_back(pair);
    }
    for (const ItemStep& test : frame.steps.items)
        if (!test.neighbors && test.step != no_step) counts.waste(below_pair[test.step], {0, 1});
    return result;
}

Attribution attribute(const AnyHierarchy& a, const AnyHierarchy& b, const TraceHeader& header,
                      const QueryTrace& frame, std::span<const IndexPair> contacts) {
    const std::vector<std::uint64_t> below =
        contacts_below(topology_of(a), topology_of(b), header.kind, frame.steps, contacts);
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
