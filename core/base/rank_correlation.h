#pragma once

#include <span>
#include <vector>

namespace scb {

/// The rank of each value, from 1 for the least; equal values have the mean of their ranks.
std::vector<double> ranks(std::span<const double> values);

/// Spearman's rank correlation: Pearson's correlation of the ranks, which is also valid for ties
/// (Kendall, "Rank Correlation Methods", chapter 3). From -1 to 1; NaN if one of the two has fewer
/// than two different values. All values must be finite, and both sizes equal.
double rank_correlation(std::span<const double> x, std::span<const double> y);

}  // namespace scb
