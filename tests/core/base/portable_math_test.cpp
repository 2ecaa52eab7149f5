#include "core/base/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scb {
namespace {

TEST(SinCosTurns, IsExactAtQuarters) {
    const double expected[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
    for (int k = -9; k <= 9; ++k) {
        const SinCos at = sin_cos_turns(k / 4.0);
        const double* e = expected[((k % 4) + 4) % 4];
        EXPECT_EQ(at.sin, e[0]) << k;
        EXPECT_EQ(at.cos, e[1]) << k;
    }
    EXPECT_EQ(sin_cos_degrees(90).cos, 0);
    EXPECT_NEAR(sin_cos_degrees(30).sin, 0.5, 1e-16);
}

TEST(SinCosTurns, IsWithinAnUlpOrTwoOfTheExactValue) {
    for (int k = -2000; k <= 2000; ++k) {
        const double turns = k * 0.00173;
        const long double angle = 2 * 3.14159265358979323846264338327950288L * turns;
        EXPECT_NEAR(sin_cos_turns(turns).sin, static_cast<double>(std::sin(angle)), 3e-16);
        EXPECT_NEAR(sin_cos_turns(turns).cos, static_cast<double>(std::cos(angle)), 3e-16);
    }
}

TEST(DecimalLogarithm, IsThatOfTheCLibrary) {
    double previous = -400;
    for (double x = 1e-300; x < 1e300; x *= 1.00731) {
        const double log = decimal_logarithm(x);
        ASSERT_NEAR(log, std::log10(x), 4e-16 * std::max(1.0, std::abs(log))) << x;
        ASSERT_GT(log, previous);
        previous = log;
    }
    EXPECT_EQ(decimal_logarithm(1), 0);
    for (int e = -1000; e <= 1000; e += 7) EXPECT_EQ(binary_logarithm(std::ldexp(1, e)), e);
}

TEST(DecimalLogarithm, HasTheSameBitsEverywhere) {
    EXPECT_EQ(decimal_logarithm(2), 0x1.34413509f79ffp-2);
    EXPECT_EQ(decimal_logarithm(1e-300), -300);
    EXPECT_EQ(decimal_logarithm(12345.678), 0x1.05db618083a9dp+2);
}

}  // namespace

}  // namespace scb
