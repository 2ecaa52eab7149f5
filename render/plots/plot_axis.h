#pragma once

#include <string>
#include <vector>

namespace scb::render {

/// Values beyond it (in either direction) have no place on an axis, since differences of larger
/// values overflow.
inline constexpr double largest_plot_value = 1e300;

/// A mark on an axis. Minor marks have no label.
struct AxisTick {
    double value = 0;
    std::string label;
};

/// The range of an axis: `low` at its left or bottom end, `high` at the other; low < high.
struct PlotAxis {
    double low = 0;
    double high = 1;
    bool log10 = false;
    bool zero_at_low = false;  ///< logarithmic, but its low end stands for 0
    std::vector<AxisTick> ticks;
};

/// The ends of a linear axis.
enum class AxisEnds {
    data,  ///< at the ends of the values, so that no width is lost
    ticks  ///< at the first marks beyond the values, so that the reader can see the limits
};

/// A linear axis for the values from `low` to `high`, marked at multiples of 1, 2 or 5 times a
/// power of ten (`whole`: of whole numbers), at most `most_ticks` of them; a limit below 3 counts
/// as 3. Labels are all different, and of one kind: with thousands separators below 10,000, else in
/// k, M or G. A range too small to divide (a billionth of its values) is drawn like a constant, in
/// the middle. Limits that are not finite count as 0.
PlotAxis linear_axis(double low, double high, int most_ticks, AxisEnds ends, bool whole = false);

/// A logarithmic axis for positive values from `low` to `high`, which begins and ends at 1, 2 or 5
/// times a power of ten. All of these are labelled if they are at most `most_ticks`, else powers of
/// ten only. `with_zero` adds a place for 0 below the smallest value, apart from the scale.
PlotAxis log_axis(double low, double high, int most_ticks, bool with_zero = false);

/// The position of a value, from 0 at the low end to 1 at the high end; values beyond are at the
/// ends. NaN if the axis has no place for the value: NaN, infinite, or not positive on a
/// logarithmic axis (0 has a place if zero_at_low).
double axis_position(const PlotAxis& axis, double value);

}  // namespace scb::render
