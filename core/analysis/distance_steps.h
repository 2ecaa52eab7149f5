#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/attribution.h"

namespace scb {

/// How the tests of a query of distances compare with its answer.
struct DistanceSteps {
    /// The distance that was found, or the distance up to which the query looked. Not finite if
    /// neither exists.
    double answer = 0;
    /// Volumes that are nearer than this cannot be left out: the answer, less the relative error
    /// that it may have.
    double reach = 0;
    std::vector<double> bounds;  ///< by step: the lower bound of the distance of the two volumes
    /// By step: the proven verdict on the two volumes. They overlap if they are nearer than
    /// `reach`, and are disjoint if they are farther apart. They touch if no proof was found.
    std::vector<Contact> exact;
    std::vector<double> gaps;  ///< by step: how much farther apart, at least; 0 if not disjoint
    /// By step: how many pairs of triangles below the two nodes are as near as the answer, up to
    /// rounding.
    std::vector<std::uint64_t> nearest;
};

/// Computes the bounds of a query again, judges the volumes of each step without the bounds, and
/// looks for all triangles that are as near as its answer. The hierarchies must be of the header's
/// volume kind.
DistanceSteps distance_steps(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                             const Mesh& mesh_b, const TraceHeader& header,
                             const QueryTrace& frame);

/// The pairs of a query of distances for `attribute`: one holds contacts if it holds triangles as
/// near as the answer. It was passed early if its bound is above the answer. `outcomes`: of the
/// frame.
std::vector<TestedPair> tested_pairs(const DistanceSteps& steps, const QueryTrace& frame,
                                     const Outcomes& outcomes);

}  // namespace scb
