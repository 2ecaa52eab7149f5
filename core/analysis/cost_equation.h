#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "scb/any_collide.h"

namespace scb {

/// The time of one query, and its counts.
struct CostSample {
    double time = 0;  ///< in any unit, above 0
    double n_v = 0, n_p = 0, n_u = 0;
};

/// Equation 1 of the paper, T = N_v C_v + N_p C_p + N_u C_u: the cost of a test of two volumes, of
/// a test of two triangles, and of moving a volume into the other's frame.
struct CostEquation {
    double c_v = 0, c_p = 0, c_u = 0;  ///< in the samples' unit of time, not negative
    bool determined = false;           ///< whether C_v and C_p can be told apart
    /// Whether C_u can be told apart, too; else C_v includes it, and C_u is 0.
    bool moves_apart = false;
    double error = 0;  ///< root mean square of (predicted - time) / time
    /// The shares of volumes, triangles and moves in the time predicted for all samples.
    double share_v = 0, share_p = 0, share_u = 0;
};

/// The costs with the least relative error, so that a short query counts as much as a long one.
/// Samples without time are left out. A cost is 0 if the best one would be negative, or if its
/// count is always 0. Costs cannot be told apart if their counts are proportional in all samples:
/// volumes are mostly moved as often as they are tested, see `moves_apart`. If all poses are the
/// same, or samples are fewer than the costs, `determined` is false and only the error has a
/// meaning. All 0 for no samples.
CostEquation fit_cost_equation(std::span<const CostSample> samples);

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
