#pragma once

#include <cstdint>

#include "core/judge/engine_query.h"

namespace scb {

/// The number of tests that contradict a pose: they rejected overlapping volumes, passed disjoint
/// ones, or were wrong about two triangles.
struct PoseFit {
    std::uint64_t wrong = 0;           ///< tests of volumes
    std::uint64_t wrong_items = 0;     ///< tests of triangles
    std::uint64_t false_positive = 0;  ///< tests of volumes that passed

    std::uint64_t all_wrong() const { return wrong + wrong_items; }
};
PoseFit fit_of_pose(const EngineQuery& query, const Pose& b_to_a);

}  // namespace scb
