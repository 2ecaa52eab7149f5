#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scb/step_recorder.h"

namespace scb {

/// The volume tests at one depth of A and one of B.
struct DepthCell {
    std::uint64_t tests = 0;
    std::uint64_t rejected = 0;  ///< of these, those that did not end with `overlapping`

    friend bool operator==(const DepthCell&, const DepthCell&) = default;
};

/// Where in the two hierarchies a traversal made its volume tests: counts by the depth of the node
/// of A and that of the node of B, from 0, the roots, to the deepest that were tested.
struct DepthMatrix {
    std::size_t depths_a = 0, depths_b = 0;
    std::vector<DepthCell> cells;  ///< depths_a x depths_b, by depth in B, then in A

    const DepthCell& at(std::size_t depth_a, std::size_t depth_b) const {
        return cells[depth_b * depths_a + depth_a];
    }
};

/// Of a query's events. No events give an empty matrix.
DepthMatrix depth_matrix(const Steps& steps);

/// The same with `step` depths of both bodies, at least 1, added up in each cell.
DepthMatrix coarser(const DepthMatrix& matrix, std::size_t step);

}  // namespace scb
