#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scb/step_recorder.h"

namespace scb {

/// The volume tests at one depth of A and one of B.
struct DepthCell {
    std::uint64_t tests = 0;
    std::uint64_t rejected = 0;  ///< of these, tests that rejected

    friend bool operator==(const DepthCell&, const DepthCell&) = default;
};

/// Counts of a traversal's volume tests by the depths of the nodes of A and B, from 0 (the roots)
/// to the deepest tested nodes.
struct DepthMatrix {
    std::size_t depths_a = 0, depths_b = 0;
    std::vector<DepthCell> cells;  ///< depths_a x depths_b, by depth in B, then in A

    const DepthCell& at(std::size_t depth_a, std::size_t depth_b) const {
        return cells[depth_b * depths_a + depth_a];
    }
};

/// The matrix of a query's steps; empty without steps.
DepthMatrix depth_matrix(const Steps& steps);

/// The matrix with `step` depths of each body, at least 1, added up in each cell.
DepthMatrix coarser(const DepthMatrix& matrix, std::size_t step);

}  // namespace scb
