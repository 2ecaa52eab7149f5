#pragma once

#include <array>
#include <cstdint>

namespace scb {

/// A finite double as an integer and a power of two: +-mantissa * 2^exponent, with mantissa < 2^53
/// and exponent >= -1074. Zero has mantissa 0.
struct Dyadic {
    std::uint64_t mantissa = 0;
    int exponent = 0;
    bool negative = false;

    Dyadic() = default;
    explicit Dyadic(double value);
};

/// A real number of any magnitude, significand * 2^exponent.
struct ScaledDouble {
    double significand = 0;
    int exponent = 0;
};

/// A sum of up to 2^20 products of three finite doubles, exact for any magnitudes: nothing
/// overflows, underflows or is rounded. The products are added as integers to a fixed-point number.
/// It is as long as their exponents need, at most the 6300 bits between the cubes of the smallest
/// denormal and of the largest double. Integer arithmetic only, so no compiler option and no
/// rounding mode matters; no allocation.
///
/// This is the long accumulator of Kulisch and Snyder ("The Exact Dot Product as Basic Tool for
/// Long Interval Arithmetic"). Compared with the expansions of Shewchuk, it costs a few hundred
/// nanoseconds a determinant at worst, but it is simple and valid for all exponents.
class ExactSum {
  public:
    /// An empty sum, for products x y z whose exponents add up to lowest_exponent at least and
    /// highest_exponent at most (products that are zero may have any).
    ExactSum(int lowest_exponent, int highest_exponent);

    void add(const Dyadic& x, const Dyadic& y, const Dyadic& z) { accumulate(x, y, z, false); }
    void subtract(const Dyadic& x, const Dyadic& y, const Dyadic& z) { accumulate(x, y, z, true); }

    /// -1, 0 or 1.
    int sign() const;

    /// The sum with a relative error of at most 2^-50; significand 0 only if the sum is zero.
    ScaledDouble value() const;

  private:
    static constexpr int max_digits = 200;

    void accumulate(const Dyadic& x, const Dyadic& y, const Dyadic& z, bool negate);

    // Digits of 32 bits, lowest first, in words with room for delayed carries and borrows.
    std::array<std::int64_t, max_digits> digits_;
    int count_;
    int lowest_exponent_;
};

}  // namespace scb
