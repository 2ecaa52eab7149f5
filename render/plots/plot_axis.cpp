#include "render/plots/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "core/base/text_format.h"
#include "render/overlay/figure_layout.h"

#include "core/base/portable_math.h"

namespace scb::render {
namespace {

// The tolerance for counting the steps of a range, as a share of a step.
constexpr double rounding = 1e-9;

/// mantissa times ten to the exponent; the mantissa is 1, 2 or 5.
struct RoundNumber {
    int mantissa = 1;
    int exponent = 0;
};

RoundNumber next(RoundNumber n) {
    if (n.mantissa == 5) return {1, n.exponent + 1};
    return {n.mantissa == 1 ? 2 : 5, n.exponent};
}

// count * number, correctly rounded: through text, as powers of ten below one are not exact.
double times(double count, RoundNumber n) {
    const std::string text = format("%.0fe%d", count * n.mantissa, n.exponent);
    const CLocale with_points;
    return std::strtod(text.c_str(), nullptr);
}

int exponent_of(double value) { return static_cast<int>(std::floor(std::log10(value))); }

std::string fixed_text(double value, int decimals) {
    std::string result = format("%.*f", decimals, value);
    if (std::abs(value) < 1e3 || std::abs(value) >= 1e15) return result;
    const std::size_t begin = value < 0 ? 1 : 0;
    const std::size_t point = std::min(result.find('.'), result.size());
    for (std::size_t i = point; i > begin + 3; i -= 3) result.insert(i - 3, ",");
    return result;
}

// A mark of a linear axis whose marks are multiples of 10^exponent, up to `largest`.
std::string linear_label(double value, int exponent, double largest) {
    if (value == 0) return "0";
    const int digits = exponent_of(largest) - exponent + 1;
    if (largest >= 1e15 || exponent < -7) return format("%.*g", std::clamp(digits, 1, 17), value);
    const int thousands = largest >= 1e9 ? 9 : largest >= 1e6 ? 6 : largest >= 1e4 ? 3 : 0;
    // Numbers with more digits after the point than before it are harder to read than separators.
    if (thousands > 0 && thousands - exponent <= 2)
        return fixed_text(value / std::pow(10.0, thousands), std::max(0, thousands - exponent)) +
               (thousands == 9   ? "G"
                : thousands == 6 ? "M"
                                 : "k");
    return fixed_text(value, std::max(0, -exponent));
}

std::string log_label(RoundNumber n) {
    if (n.exponent < -4 || n.exponent >= 12)
        return std::to_string(n.mantissa) + "e" + std::to_string(n.exponent);
    if (n.exponent < 0) return fixed_text(times(1, n), -n.exponent);
    const int thousands = n.exponent >= 9 ? 9 : n.exponent >= 6 ? 6 : n.exponent >= 3 ? 3 : 0;
    const std::string number = std::to_string(n.mantissa) +
                               std::string(static_cast<std::size_t>(n.exponent - thousands), '0');
    return number + (thousands == 9 ? "G" : thousands == 6 ? "M" : thousands == 3 ? "k" : "");
}

double finite(double value) {
    return std::isfinite(value) ? std::clamp(value, -largest_plot_value, largest_plot_value) : 0;
}

}  // namespace

PlotAxis linear_axis(double low, double high, int most_ticks, AxisEnds ends, bool whole) {
    low = finite(low);
    high = finite(high);
    if (high < low) std::swap(low, high);
    const double magnitude = std::max(std::abs(low), std::abs(high));
    if (!(high - low > std::max(rounding * magnitude, 1e-290))) {
        const double half = magnitude < 1e-280 || (whole && magnitude < 1e8) ? 0.5 : magnitude / 10;
        low -= half;
        high += half;
    }
    most_ticks = std::max(most_ticks, 3);

    PlotAxis axis{low, high, false, false, {}};
    RoundNumber step{1, exponent_of((high - low) / most_ticks) - 1};
    if (whole) step.exponent = std::max(step.exponent, 0);
    for (;; step = next(step)) {
        const double length = times(1, step);
        const double first = ends == AxisEnds::data ? std::ceil(low / length - rounding)
                                                    : std::floor(low / length + rounding);
        const double last = ends == AxisEnds::data ? std::floor(high / length + rounding)
                                                   : std::ceil(high / length - rounding);
        if (last - first + 1 > most_ticks) continue;
        const double largest = std::max(std::abs(first), std::abs(last)) * length;
        for (double i = first; i <= last; ++i) {
            const double value = times(i, step);
            axis.ticks.push_back({value, linear_label(value, step.exponent, largest)});
        }
        if (ends == AxisEnds::ticks) {
            axis.low = axis.ticks.front().value;
            axis.high = axis.ticks.back().value;
        }
        return axis;
    }
}

PlotAxis log_axis(double low, double high, int most_ticks, bool with_zero) {
    // Smaller and larger ones have no neighbors to end at.
    low = std::clamp(std::isfinite(low) ? low : 1, 1 / largest_plot_value, largest_plot_value);
    high = std::clamp(std::isfinite(high) ? high : 1, low, largest_plot_value);
    if (!(high > low * (1 + rounding))) {
        low /= 2;
        high *= 2;
    }
    std::vector<RoundNumber> marks;
    RoundNumber mark{1, exponent_of(low) - 1};
    while (times(1, next(mark)) <= low * (1 + rounding)) mark = next(mark);
    marks.push_back(mark);
    do marks.push_back(mark = next(mark));
    while (times(1, mark) < high * (1 - rounding));

    PlotAxis axis{times(1, marks.front()), times(1, marks.back()), true, with_zero, {}};
    if (with_zero) {
        axis.low /= 4;
        axis.ticks.push_back({0, "0"});
    }
    const auto count = [&](int mantissa, int stride) {
        return std::count_if(marks.begin(), marks.end(), [&](RoundNumber n) {
            return (mantissa == 0 || n.mantissa == mantissa) && n.exponent % stride == 0;
        });
    };
    most_ticks = std::max(most_ticks, 2);
    const bool all = count(0, 1) <= most_ticks;
    int stride = 1;
    while (!all && count(1, stride) > most_ticks) ++stride;
    for (const RoundNumber n : marks) {
        const bool labelled = all || (n.mantissa == 1 && n.exponent % stride == 0);
        if (labelled || stride == 1)
            axis.ticks.push_back({times(1, n), labelled ? log_label(n) : ""});
    }
    return axis;
}

double axis_position(const PlotAxis& axis, double value) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(value)) return none;
    if (!axis.log10) return std::clamp((value - axis.low) / (axis.high - axis.low), 0.0, 1.0);
    if (value == 0 && axis.zero_at_low) return 0;
    if (!(value > 0)) return none;
    const double low = decimal_logarithm(axis.low), high = decimal_logarithm(axis.high);
    return std::clamp((decimal_logarithm(value) - low) / (high - low), 0.0, 1.0);
}

}  // namespace scb::render
