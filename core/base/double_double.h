#pragma once

#include <cmath>

namespace scb {

/// An unevaluated sum of two doubles, with some 106 bits. Its operations have relative errors below
/// 2^-100 unless they underflow or overflow (Joldes, Muller and Popescu, "Tight and Rigorous Error
/// Bounds for Basic Building Blocks of Double-Word Arithmetic", 2017).
struct DoubleDouble {
    double high = 0, low = 0;

    DoubleDouble() = default;
    /// Implicit, as from int to double.
    DoubleDouble(double value) : high(value) {}
    /// The sum of two doubles, exactly (Knuth's two-sum).
    static DoubleDouble sum(double x, double y) {
        DoubleDouble result;
        result.high = x + y;
        const double of_y = result.high - x;
        result.low = (x - (result.high - of_y)) + (y - of_y);
        return result;
    }
    /// The product of two doubles, exactly.
    static DoubleDouble product(double x, double y) {
        DoubleDouble result;
        result.high = x * y;
        result.low = std::fma(x, y, -result.high);
        return result;
    }

    friend DoubleDouble operator-(const DoubleDouble& x) {
        DoubleDouble result;
        result.high = -x.high;
        result.low = -x.low;
        return result;
    }
    friend DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
        const DoubleDouble of_high = sum(x.high, y.high), of_low = sum(x.low, y.low),
                           middle = sum(of_high.high, of_high.low + of_low.high);
        return sum(middle.high, middle.low + of_low.low);
    }
    friend DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }
    friend DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
        const DoubleDouble of_high = product(x.high, y.high);
        return sum(of_high.high, of_high.low + (x.high * y.low + x.low * y.high));
    }
    friend DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
        const double first = x.high / y.high;
        const DoubleDouble rest = x - y * DoubleDouble(first);
        const double second = rest.high / y.high;
        const DoubleDouble last = rest - y * DoubleDouble(second);
        return sum(first, second) + DoubleDouble(last.high / y.high);
    }
    friend bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
        return x.high < y.high || (x.high == y.high && x.low < y.low);
    }
};

}  // namespace scb
