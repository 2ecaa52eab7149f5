#include "core/base/logarithm.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scb {
namespace {

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
