#pragma once

#include <cstdint>

#include "scb/any_collide.h"

namespace scb {

/// Arithmetic operations (additions, subtractions, multiplications) that a test of two volumes has
/// made when it ends at the stage, the transformation of B among them: the last column of Table 1
/// of the paper, as the tests here are written, at most. Comparisons do not count, nor do the up to
/// five square roots of `extents`. Slab cut balls as counted by running the tests on numbers that
/// count; balls and boxes counted by hand.
std::uint32_t operation_cost(VolumeKind kind, const OverlapOptions& options, Stage stage);

/// The operations of all tests of a query.
std::uint64_t operation_count(VolumeKind kind, const OverlapOptions& options,
                              const StageCounts& stages);

}  // namespace scb
