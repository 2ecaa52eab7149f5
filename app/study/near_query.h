#pragma once

#include "app/study/query_setup.h"
#include "app/study/query_timing.h"
#include "scb/any_packed.h"

namespace scb::app {

/// The answer of a query of distances: the distance and counts, or the pairs within the tolerance.
QueryAnswer near_answer(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                        const Mesh& mesh_b, const Pose& b_to_a, const DistanceQuery& asked);
/// The same on packed hierarchies, which must have one layout.
QueryAnswer near_answer(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                        const Mesh& mesh_b, const Pose& b_to_a, const DistanceQuery& asked,
                        SimdLevel level = SimdLevel::best);

}  // namespace scb::app
