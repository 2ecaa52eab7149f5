#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/trace.h"
#include "scb/step.h"

namespace scb {

/// Chosen volume tests of a query and their triangle tests, with the counts and pairs of these
/// alone. `chosen`: numbers of steps, ascending.
QueryTrace with_tests(const TraceHeader& header, const QueryTrace& frame,
                      const std::vector<std::uint32_t>& chosen);

/// The test of two nodes; a query makes it once at most.
std::optional<std::uint32_t> test_of(const Steps& steps, IndexPair nodes);

/// The part of a query that begins with the test `root`, as a query whose roots are the two nodes.
/// Depths stay as in the whole query.
QueryTrace traversal_part(const TraceHeader& header, const QueryTrace& frame, std::uint32_t root);

/// The first tests of parts of a query. Together the parts are the whole query except some tests at
/// the top. Each has at most a quarter of the tests, and none is in another. Returns at most
/// `most`, the largest first, equal ones in order.
std::vector<std::uint32_t> largest_parts(const Steps& steps, std::size_t most);

/// For each step of a query, the number of steps in the part of the query that begins with it,
/// itself included: the cost of the pair. The cost of a divided pair is one more than the costs of
/// its children together. O(n).
std::vector<std::uint32_t> subtree_sizes(const Steps& steps);

/// At most `most` steps of a query, ascending: the steps of `first`, in its order, then the steps
/// with the most steps below them, equal ones in order.
std::vector<std::uint32_t> costly_tests(const Steps& steps, std::span<const std::uint32_t> first,
                                        std::size_t most);

}  // namespace scb
