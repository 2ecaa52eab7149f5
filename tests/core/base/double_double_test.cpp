#include "core/base/double_double.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/geometry/exact_sum.h"

namespace scb {
namespace {

double some_double(Random& random) {
    return random.uniform(-1, 1) * std::pow(10, random.uniform(-12, 12));
}

/// Such sums keep some 106 bits.
DoubleDouble some_double_double(Random& random) {
    const double high = some_double(random);
    return DoubleDouble::sum(high, high * random.uniform(-1, 1) * 0x1p-54);
}

/// x y - z, exactly, over z.
double relative_error(const DoubleDouble& x, const DoubleDouble& y, const DoubleDouble& z) {
    ExactSum rest(-1000, 1000);
    const Dyadic one(1);
    for (const double p : {x.high, x.low})
        for (const double q : {y.high, y.low}) rest.add(Dyadic(p), Dyadic(q), one);
    for (const double r : {z.high, z.low}) rest.subtract(Dyadic(r), one, one);
    const ScaledDouble value = rest.value();
    return std::abs(std::ldexp(value.significand, value.exponent) / z.high);
}

TEST(DoubleDoubles, AreExactForDoublesAndCloseForTheirResults) {
    Random random(3);
    for (int i = 0; i < 20'000; ++i) {
        const double p = some_double(random), q = some_double(random);
        EXPECT_EQ(relative_error(p, q, DoubleDouble::product(p, q)), 0);
        const DoubleDouble x = some_double_double(random), y = some_double_double(random);
        EXPECT_LE(relative_error(x, y, x * y), 0x1p-100);
        EXPECT_LE(relative_error(x / y, y, x), 0x1p-98);
        // (x + y) - y, where x is not lost.
        if (std::abs(x.high) < std::abs(y.high)) continue;
        EXPECT_LE(relative_error((x + y) - y, 1, x), 0x1p-99);
        EXPECT_LE(relative_error(x - (x - y), 1, y),
                  0x1p-100 * std::abs(x.high / y.high) + 0x1p-99);
    }
    EXPECT_EQ(DoubleDouble::sum(1, 0x1p-80).low, 0x1p-80);
    EXPECT_TRUE(DoubleDouble(1) < DoubleDouble::sum(1, 0x1p-80));
    EXPECT_FALSE(DoubleDouble::sum(1, 0x1p-80) < DoubleDouble(1));
}

}  // namespace
}  // namespace scb
