#include "core/base/portable_math.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace scb {

SinCos sin_cos_turns(double turns) {
    assert(std::isfinite(turns) && "an angle must be finite");
    // Both steps are exact: the nearest quarter, and the remainder, at most pi/4 in radians.
    const double quarters = std::nearbyint(4 * turns);
    const double x = (turns - quarters / 4) * (2 * std::numbers::pi);
    const double x2 = x * x;
    // Taylor sums; on |x| <= pi/4 the first term left out is below 1e-19.
    double sine = 0, cosine = 0;
    constexpr double s[] = {-1.0 / 6,
                            1.0 / 120,
                            -1.0 / 5040,
                            1.0 / 362880,
                            -1.0 / 39916800,
                            1.0 / 6227020800.0,
                            -1.0 / 1307674368000.0,
                            1.0 / 355687428096000.0};
    constexpr double c[] = {-1.0 / 2,
                            1.0 / 24,
                            -1.0 / 720,
                            1.0 / 40320,
                            -1.0 / 3628800,
                            1.0 / 479001600.0,
                            -1.0 / 87178291200.0,
                            1.0 / 20922789888000.0,
                            -1.0 / 6402373705728000.0};
    for (int i = 7; i >= 0; --i) sine = sine * x2 + s[i];
    for (int i = 8; i >= 0; --i) cosine = cosine * x2 + c[i];
    sine = x + x * (x2 * sine);
    cosine = 1 + x2 * cosine;
    switch (static_cast<int>(quarters - 4 * std::floor(quarters / 4))) {
        case 0:
            return {sine, cosine};
        case 1:
            return {cosine, -sine};
        case 2:
            return {-sine, -cosine};
        default:
            return {-cosine, sine};
    }
}

double arc_tangent(double y, double x) {
    assert(y >= 0 && x >= 0 && "an angle of the first quadrant");
    if (y > x) return std::numbers::pi / 2 - arc_tangent(x, y);
    if (!(y > 0)) return 0;
    // A quarter of the angle, at most pi/16; the first term left out of the series is below 1e-18.
    double t = y / x;
    for (int i = 0; i < 2; ++i) t /= 1 + std::sqrt(1 + t * t);
    double sum = 0;
    for (int i = 25; i >= 3; i -= 2) sum = (1.0 / i - sum) * (t * t);
    return 4 * (t - t * sum);
}

double binary_logarithm(double x) {
    int exponent = 0;
    double m = std::frexp(x, &exponent);  // exact, in [1/2, 1)
    if (m < 0.70710678118654752440) {
        m *= 2;
        --exponent;
    }
    // log2(m) = 2 / ln 2 * artanh(t), |t| < 0.172.
    const double t = (m - 1) / (m + 1), t2 = t * t;
    double sum = 0;
    for (int k = 21; k >= 1; k -= 2) sum = sum * t2 + 1.0 / k;
    return exponent + 2 * 1.44269504088896340736 * t * sum;
}

}  // namespace scb
