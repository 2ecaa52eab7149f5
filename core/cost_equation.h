#pragma once

#include <array>
#include <span>

namespace scb {

/// What one query took, and how often it did what it is thought to take time.
struct CostSample {
    double time = 0;  ///< in any unit, above 0
    double n_v = 0, n_p = 0, n_u = 0;
};

/// Equation 1 of the paper, T = N_v C_v + N_p C_p + N_u C_u: the cost of a test of two volumes, of
/// a test of two triangles, and of moving a volume into the other's frame.
struct CostEquation {
    double c_v = 0, c_p = 0, c_u = 0;  ///< in the samples' unit of time, not negative
    double error = 0;                  ///< root mean square of (predicted - time) / time
    /// The shares of volumes, triangles and moves in the time predicted for all samples.
    double share_v = 0, share_p = 0, share_u = 0;
};

/// The costs that leave the least error, each sample weighted by its time, so that a short query
/// counts as much as a long one. A cost is 0 where the best one would be negative or nothing of its
/// kind was done. Costs of counts that go together in all samples cannot be told apart: the split
/// between them is then without meaning. All 0 for no samples.
CostEquation fit_cost_equation(std::span<const CostSample> samples);

}  // namespace scb
