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
    std::vector<double> bounds;  ///< by step: the lower bound of the distance of the two volumes
    /// By step: how many pairs of triangles below the two nodes are as near as the answer.
    std::vector<std::uint64_t> nearest;
};

/// Computes the bounds of a query again, and looks for all triangles that are as near as its
/// answer. The hierarchies must be of the header's volume kind.
DistanceSteps distance_steps(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                             const Mesh& mesh_b, const TraceHeader& header,
                             const QueryTrace& frame);

/// The pairs of a query of distances for `attribute`: one holds contacts if it holds triangles as
/// near as the answer, and its volumes are disjoint if their bound is above the answer. This is
/// no fault of a pair that was not needed any more, so there they are not.
std::vector<TestedPair> tested_pairs(const DistanceSteps& steps, const QueryTrace& frame,
                                     const Outcomes& outcomes);

}  // namespace scb
