#include "core/analysis/distance_steps.h"

#include "core/analysis/contacts_below.h"
#include "core/collide/query_placement.h"
#include "core/distance/volume_gap.h"
#include "core/hierarchy/same_volumes.h"

namespace scb {
namespace {

/// The pairs of triangles that are as near as the answer. A query may end before it has seen all.
std::vector<IndexPair> nearest_pairs(const AnyHierarchy& a, const Mesh& mesh_a,
                                     const AnyHierarchy& b, const Mesh& mesh_b,
                                     const TraceHeader& header, const QueryTrace& frame) {
    if (header.kind != QueryKind::distance) return frame.found.pairs;
    if (!frame.nearest) return {};
    return within(a, mesh_a, b, mesh_b, frame.b_to_a, frame.nearest->distance,
                  header.distance.descent)
        .pairs;
}

double answer_of(const TraceHeader& header, const QueryTrace& frame) {
    if (header.kind != QueryKind::distance) return header.tolerance;
    return frame.nearest ? frame.nearest->distance : header.distance.limit;
}

}  // namespace

DistanceSteps distance_steps(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                             const Mesh& mesh_b, const TraceHeader& header,
                             const QueryTrace& frame) {
    DistanceSteps result;
    result.answer = answer_of(header, frame);
    with_both(a, b, [&]<class V>(const Hierarchy<V>& of_a, const Hierarchy<V>& of_b) {
        const Placement placed = query_placement(of_a, of_b, frame.b_to_a);
        result.bounds.reserve(frame.steps.volumes.size());
        for (const Step& step : frame.steps.volumes)
            result.bounds.push_back(
                volume_gap(of_a.volumes[step.nodes.a], of_b.volumes[step.nodes.b], placed).bound);
    });
    result.nearest = contacts_below(topology_of(a), topology_of(b), header.kind, frame.steps,
                                    nearest_pairs(a, mesh_a, b, mesh_b, header, frame));
    return result;
}

std::vector<TestedPair> tested_pairs(const DistanceSteps& steps, const QueryTrace& frame,
                                     const Outcomes& outcomes) {
    std::vector<TestedPair> pairs(outcomes.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const bool is_left_out = is_rejection(frame.steps.volumes[i].stage),
                   is_above = is_left_out ||
                              (outcomes[i] != Stage::left_over && steps.bounds[i] > steps.answer);
        pairs[i].exact = is_above ? Contact::disjoint : Contact::overlapping;
        pairs[i].gap = is_above ? steps.bounds[i] - steps.answer : 0;
        pairs[i].contacts = steps.nearest[i];
        pairs[i].leaves =
            outcomes[i] == Stage::triangles_apart || outcomes[i] == Stage::triangles_meet;
    }
    return pairs;
}

}  // namespace scb
