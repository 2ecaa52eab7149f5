#pragma once

#include "scb/hierarchy.h"
#include "scb/placement.h"

namespace scb {

/// The placement of B for a query on whole hierarchies. Volumes below the root may stick out of it.
template <Volume V>
Placement query_placement(const Hierarchy<V>& a, const Hierarchy<V>& b, const Pose& b_to_a) {
    // The center of a fitted volume is among its points, which are in the root. Its size is at most
    // some diameters of these points.
    return placement(b_to_a, 4 * reach(a.volumes[0]), 4 * reach(b.volumes[0]));
}

}  // namespace scb
