#pragma once

#include <cstdint>

#include "scb/any_collide.h"

namespace scb {

/// The most arithmetic operations (additions, subtractions, multiplications) of a test of two
/// volumes until it ends at the stage, with the transformation of B: the last column of Table 1 of
/// the paper, for the tests as written here. Comparisons do not count, nor do the up to five square
/// roots of `extents`. Slab cut balls are counted by running the tests on counting numbers; balls
/// and boxes by hand.
std::uint32_t operation_cost(VolumeKind kind, const OverlapOptions& options, Stage stage);

/// The operations of all tests of a query.
std::uint64_t operation_count(VolumeKind kind, const OverlapOptions& options,
                              const StageCounts& stages);

}  // namespace scb
