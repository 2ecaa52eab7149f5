#pragma once

#include <cmath>
#include <compare>

#include "scb/placement.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb {

/// What was computed with CountingScalar: simple arithmetic operations, in the sense of Table 1,
/// and comparisons. Changes of sign and absolute values count as operations, as do square roots,
/// which are also counted by themselves.
struct OperationCounts {
    int operations = 0, comparisons = 0, square_roots = 0;

    friend auto operator<=>(const OperationCounts&, const OperationCounts&) = default;
};

/// A double that counts what is done with it. Copies, conversions and selections are free.
struct CountingScalar {
    double value = 0;

    static inline OperationCounts counts;

    CountingScalar() = default;
    CountingScalar(double v) : value(v) {}  // implicit, as the literals in a formula are

    friend CountingScalar operator+(CountingScalar a, CountingScalar b) {
        return counted(a.value + b.value);
    }
    friend CountingScalar operator-(CountingScalar a, CountingScalar b) {
        return counted(a.value - b.value);
    }
    friend CountingScalar operator*(CountingScalar a, CountingScalar b) {
        return counted(a.value * b.value);
    }
    friend CountingScalar operator/(CountingScalar a, CountingScalar b) {
        return counted(a.value / b.value);
    }
    friend CountingScalar operator-(CountingScalar a) { return counted(-a.value); }
    friend CountingScalar abs(CountingScalar a) { return counted(std::abs(a.value)); }
    friend CountingScalar sqrt(CountingScalar a) {
        ++counts.square_roots;
        return counted(std::sqrt(a.value));
    }
    CountingScalar& operator+=(CountingScalar b) { return *this = *this + b; }
    CountingScalar& operator-=(CountingScalar b) { return *this = *this - b; }
    CountingScalar& operator*=(CountingScalar b) { return *this = *this * b; }
    CountingScalar& operator/=(CountingScalar b) { return *this = *this / b; }

    friend bool operator<(CountingScalar a, CountingScalar b) {
        return compared(a.value < b.value);
    }
    friend bool operator>(CountingScalar a, CountingScalar b) {
        return compared(a.value > b.value);
    }
    friend bool operator<=(CountingScalar a, CountingScalar b) {
        return compared(a.value <= b.value);
    }
    friend bool operator>=(CountingScalar a, CountingScalar b) {
        return compared(a.value >= b.value);
    }
    friend bool operator==(CountingScalar a, CountingScalar b) {
        return compared(a.value == b.value);
    }

  private:
    static CountingScalar counted(double result) {
        ++counts.operations;
        return result;
    }
    static bool compared(bool result) {
        ++counts.comparisons;
        return result;
    }
};

}  // namespace scb

template <>
struct Eigen::NumTraits<scb::CountingScalar> : Eigen::NumTraits<double> {
    using Real = scb::CountingScalar;
    using NonInteger = scb::CountingScalar;
    using Nested = scb::CountingScalar;
    using Literal = double;
};

namespace scb {

inline Vector3<CountingScalar> counting(const Vec3& v) { return {v[0], v[1], v[2]}; }

inline BasicScb<CountingScalar> counting(const Scb& s) {
    return {counting(s.c), s.r, counting(s.n), s.e, s.f};
}

inline BasicScb2<CountingScalar> counting(const Scb2& s) {
    BasicScb2<CountingScalar> result;
    result.c = counting(s.c);
    result.r = s.r;
    for (std::size_t i = 0; i < 2; ++i)
        result.slabs[i] = {counting(s.slabs[i].n), s.slabs[i].e, s.slabs[i].f};
    return result;
}

inline BasicPlacement<CountingScalar> counting(const Placement& placed) {
    BasicPlacement<CountingScalar> result;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) result.b_to_a.rotation(i, j) = placed.b_to_a.rotation(i, j);
        result.b_to_a.translation[i] = placed.b_to_a.translation[i];
    }
    result.margin = placed.margin;
    result.squared_sine_bound = placed.squared_sine_bound;
    return result;
}

}  // namespace scb
