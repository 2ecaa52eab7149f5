#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/analysis/outcome.h"
#include "scb/event_recorder.h"

namespace scb {

/// How the tests of a query follow from each other.
struct TraversalTree {
    static constexpr std::uint32_t no_parent = 0xffffffff;

    std::vector<std::uint32_t> parents;  ///< per volume test: the test of the pair whose division
                                         ///< led to it; of the roots no_parent
    std::vector<Outcome> outcomes;       ///< per volume test
};

/// The tree of a query's tests, restored from the order in which collide makes them: without the
/// hierarchies. `found_nodes` are the query's pairs where it was to stop at a level, otherwise
/// empty. `events` must be those of one call of collide. O(n).
TraversalTree traversal_tree(const Events& events, std::span<const IndexPair> found_nodes);

/// The same of queries of whatever engine. `parents`: per volume test the one that led to it, an
/// earlier one, or no_parent. A pair of leaves may have had several tests of triangles, which
/// follow each other in `events`, ascending by `after`.
TraversalTree traversal_tree(const Events& events, std::span<const IndexPair> found_nodes,
                             std::span<const std::uint32_t> parents);

/// For each volume test, how many volume tests there are in the part of the tree that begins with
/// it, itself among them: what the pair cost. That of the roots is N_v; that of a pair which was
/// divided is one more than those of its children together. O(n).
std::vector<std::uint32_t> subtree_sizes(const TraversalTree& tree);

}  // namespace scb
