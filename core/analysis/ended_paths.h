#pragma once

#include <limits>
#include <vector>

#include "core/analysis/ending.h"
#include "core/hierarchy/tree_shape.h"

namespace scb {

/// A node of one body at which paths of a traversal ended, and their endings.
struct EndedPaths {
    std::uint32_t node = 0;
    std::uint16_t depth = 0;     ///< of the node
    std::uint32_t tests = 0;     ///< paths that ended here
    std::uint32_t rejected = 0;  ///< of these, paths that ended at a rejection
    std::uint32_t tested = 0;    ///< all tests of the node, also tests that were divided
    Stage first{}, last{};       ///< in the order of the tests
    Stage dominant{};  ///< the most frequent ending; of equals, the first in the order of Stage
    std::uint32_t of_dominant = 0;
};

/// Which paths count.
struct EndedPathsFilter {
    std::vector<Stage> endings;                                         ///< empty: all
    int least_depth = 0, most_depth = std::numeric_limits<int>::max();  ///< of the node
};

/// The nodes of A (`side` 0) or B (1) at which paths of a traversal ended, ascending. One node may
/// be below another, since they met different nodes of the other body.
std::vector<EndedPaths> ended_paths(const QueryTrace& frame, const Outcomes& outcomes,
                                    std::size_t side, const EndedPathsFilter& filter = {});

/// The nodes without another of these nodes below them: no volume encloses another, so each can be
/// seen.
std::vector<EndedPaths> innermost(const std::vector<EndedPaths>& nodes, const TreeShape& shape);

}  // namespace scb
