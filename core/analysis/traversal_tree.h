#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scb/event_recorder.h"

namespace scb {

/// What became of a pair of nodes once its volumes had been tested.
enum class Outcome : std::uint8_t {
    rejected,         ///< at the stage that the test says
    divided_a,        ///< they overlap; the children of A's node were tested next
    divided_b,        ///< they overlap; the children of B's node were tested next
    triangles_apart,  ///< two leaves that overlap, whose triangles do not intersect
    triangles_meet,   ///< two leaves that overlap, whose triangles intersect
    found,            ///< nodes that overlap at the level where the query was to stop
    left_over,        ///< they overlap, but the query had its pairs before it came to divide them
};

/// How the tests of a query follow from each other.
struct TestTree {
    static constexpr std::uint32_t no_parent = 0xffffffff;

    std::vector<std::uint32_t> parents;  ///< per volume test: the test of the pair whose division
                                         ///< led to it; of the roots no_parent
    std::vector<Outcome> outcomes;       ///< per volume test
};

/// The tree of a query's tests, restored from the order in which collide makes them: without the
/// hierarchies. `found_nodes` are the query's pairs where it was to stop at a level, otherwise
/// empty. `events` must be those of one call of collide. O(n).
TestTree test_tree(const Events& events, std::span<const IndexPair> found_nodes);

}  // namespace scb
