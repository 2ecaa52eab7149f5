#pragma once

#include <optional>

#include "core/analysis/trace.h"

namespace scb {

/// Of a query, some of its volume tests and the triangle tests that these led to: counts and pairs
/// of these alone. `chosen` are numbers of steps, ascending.
TraceFrame with_tests(const TraceHeader& header, const TraceFrame& frame,
                      const std::vector<std::uint32_t>& chosen);

/// The test of two nodes; a query makes it once at most.
std::optional<std::uint32_t> test_of(const Steps& steps, IndexPair nodes);

/// Of a query the part that begins with this test: as a query of its own whose roots are the two
/// nodes, but for their depths, which are those in the whole.
TraceFrame traversal_part(const TraceHeader& header, const TraceFrame& frame, std::uint32_t root);

/// The parts of a query worth a look of their own: together they are all of it but for some tests
/// at the top, each has at most a quarter of the tests, and none is in another. The largest first,
/// of equal ones the earlier; at most `most`.
std::vector<std::uint32_t> largest_parts(const Steps& steps, std::size_t most);

}  // namespace scb
