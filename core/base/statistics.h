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

}  // namespace scb
