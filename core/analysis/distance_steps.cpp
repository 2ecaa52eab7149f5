#include "core/analysis/distance_steps.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/contacts_below.h"
#include "core/base/parallel_for.h"
#include "core/collide/query_placement.h"
#include "core/distance/distance_certificate.h"
#include "core/distance/volume_gap.h"
#include "core/explain/exact_overlap.h"
#include "core/hierarchy/same_volumes.h"
#include "core/model/node_volume.h"
#include "core/volumes/shape.h"

namespace scb {
namespace {

/// The pairs of triangles that are as near as the answer, up to rounding. Triangles with the
/// closest vertex in common count, though each distance is rounded its own way. A query may end
/// before it has seen all of these pairs.
std::vector<IndexPair> nearest_pairs(const AnyHierarchy& a, const Mesh& mesh_a,
                                     const AnyHierarchy& b, const Mesh& mesh_b,
                                     const TraceHeader& header, const QueryTrace& frame) {
    if (header.kind != QueryKind::distance) return frame.found.pairs;
    if (!frame.nearest) return {};
    const double rounding =
        distance_rounding({mesh_a, topology_of(a)}, {mesh_b, topology_of(b)}, frame.b_to_a);
    return within(a, mesh_a, b, mesh_b, frame.b_to_a, frame.nearest->distance + rounding,
                  header.distance.descent)
        .pairs;
}

/// Adds the verdicts: are the volumes of a step nearer than the reach? A search for closest points
/// proves each verdict. The search does not use the bound of the step.
template <class V>
void add_verdicts(DistanceSteps& steps, const Hierarchy<V>& a, const Hierarchy<V>& b,
                  const QueryTrace& frame, const Placement& placed) {
    constexpr std::size_t tests_in_block = 128;
    const std::vector<Step>& tests = frame.steps.volumes;
    steps.exact.assign(tests.size(), Contact::touching);
    steps.gaps.assign(tests.size(), 0);
    if (!std::isfinite(steps.reach)) return;
    parallel_blocks(
        processor_count(), tests.size(),
        [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) {
                const auto& of_a = shape_of(a.volumes[tests[i].nodes.a]);
                const auto& of_b = shape_of(b.volumes[tests[i].nodes.b]);
                const ContactCertificate found =
                    steps.reach > 0 ? exact_verdict(exact_shape(of_a), exact_shape(of_b),
                                                    frame.b_to_a, placed.margin, steps.reach)
                                    : exact_verdict(of_a, of_b, placed);
                steps.exact[i] = found.contact;
                if (found.contact == Contact::disjoint) steps.gaps[i] = found.margin;
            }
        },
        tests_in_block);
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
    result.reach = result.answer;
    // The query divides a distance that it found, and no limit.
    if (frame.nearest) result.reach /= 1 + header.distance.relative_error;
    with_both(a, b, [&]<class V>(const Hierarchy<V>& of_a, const Hierarchy<V>& of_b) {
        const Placement placed = query_placement(of_a, of_b, frame.b_to_a);
        result.bounds.reserve(frame.steps.volumes.size());
        for (const Step& step : frame.steps.volumes)
            result.bounds.push_back(
                volume_gap(of_a.volumes[step.nodes.a], of_b.volumes[step.nodes.b], placed).bound);
        add_verdicts(result, of_a, of_b, frame, placed);
    });
    result.nearest = contacts_below(topology_of(a), topology_of(b), header.kind, frame.steps,
                                    nearest_pairs(a, mesh_a, b, mesh_b, header, frame));
    return result;
}

std::vector<TestedPair> tested_pairs(const DistanceSteps& steps, const QueryTrace& frame,
                                     const Outcomes& outcomes) {
    std::vector<TestedPair> pairs(outcomes.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        TestedPair& pair = pairs[i];
        pair.exact = steps.exact[i];
        pair.gap = steps.gaps[i];
        // With a relative error, triangles as near as the answer may be left out.
        const bool may_lack =
            is_rejection(frame.steps.volumes[i].stage) && steps.reach < steps.answer;
        pair.contacts = may_lack ? 0 : steps.nearest[i];
        pair.early = pair.exact != Contact::overlapping && steps.bounds[i] > steps.reach;
        pair.leaves = outcomes[i] == Stage::triangles_apart || outcomes[i] == Stage::triangles_meet;
    }
    return pairs;
}

}  // namespace scb
