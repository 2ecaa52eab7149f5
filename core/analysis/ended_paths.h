#pragma once

#include <limits>
#include <vector>

#include "core/analysis/ending.h"
#include "core/hierarchy/tree_shape.h"

namespace scb {

/// A node of one body at which paths of a traversal ended, and how they did.
struct EndedPaths {
    std::uint32_t node = 0;
    std::uint16_t depth = 0;     ///< of the node
    std::uint32_t tests = 0;     ///< paths that ended here
    std::uint32_t rejected = 0;  ///< of these, those whose volumes were rejected
    std::uint32_t tested = 0;    ///< all tests of the node, also those that were passed on
    Stage first{}, last{};       ///< in the order of the tests
    Stage dominant{};            ///< the most frequent one; of equally frequent ones the first in
                                 ///< the order of Stage
    std::uint32_t of_dominant = 0;
};

/// Which paths count.
struct EndedPathsFilter {
    std::vector<Stage> endings;                                         ///< empty: all
    int least_depth = 0, most_depth = std::numeric_limits<int>::max();  ///< of the node
};

/// Where the paths of a traversal ended, on one side: every node of A (`side` 0) or B (1) in whose
/// pair tests paths ended, ascending. One node may be below another, since it met other nodes of
/// the other body.
std::vector<EndedPaths> ended_paths(const TraceFrame& frame, const Outcomes& outcomes,
                                    std::size_t side, const EndedPathsFilter& filter = {});

/// Of these nodes, those without another one below them: their volumes do not hold each other, so
/// that each can be seen.
std::vector<EndedPaths> innermost(const std::vector<EndedPaths>& nodes, const TreeShape& shape);

}  // namespace scb
