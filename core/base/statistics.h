#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace scb {

/// The mean of the values that are finite; NaN where there are none.
double mean(std::span<const double> values);
double mean(std::span<const std::uint64_t> values);

/// The middle one of the values that are finite, or the mean of the two in the middle; NaN where
/// there are none.
double median(std::vector<double> values);

/// `value / by`, or `otherwise` where `by` is not above 0.
inline double ratio(double value, double by, double otherwise = 0) {
    return by > 0 ? value / by : otherwise;
}

/// The rank of each value, from 1 for the least; equal values have the mean of their ranks.
std::vector<double> ranks(std::span<const double> values);

/// Spearman's rank correlation: Pearson's correlation of the ranks, which is also valid for ties
/// (Kendall, "Rank Correlation Methods", chapter 3). From -1 to 1; NaN if one of the two has fewer
/// than two different values. All values must be finite, and both sizes equal.
double rank_correlation(std::span<const double> x, std::span<const double> y);

}  // namespace scb
