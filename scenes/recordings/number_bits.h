#pragma once

#include <cmath>

namespace scb::scenes {

/// Whether a number shows how many bits its engine uses: it takes more than 16 bits. Whole numbers
/// and short fractions do not.
inline bool is_long(double value) {
    constexpr double short_bits = 0x1p16;
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent) * short_bits;
    return std::isfinite(value) && value != std::trunc(value) && mantissa != std::trunc(mantissa);
}

/// Whether the value is exact in 32 bits, or is not finite.
inline bool is_of_32_bits(double value) {
    return static_cast<double>(static_cast<float>(value)) == value || !std::isfinite(value);
}

}  // namespace scb::scenes
