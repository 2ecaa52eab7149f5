#include "core/logarithm.h"

#include <cmath>

namespace scb {

double decimal_logarithm(double x) {
    constexpr double log10_2 = 0.30102999566398119521, log10_e = 0.43429448190325182765;
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);  // exact, in [0.5, 1)
    if (mantissa < 0.70710678118654752440) {
        mantissa *= 2;
        --exponent;
    }
    // ln m = 2 artanh((m - 1) / (m + 1)) by its series; the argument is below 0.172.
    const double s = (mantissa - 1) / (mantissa + 1), square = s * s;
    double sum = 0;
    for (int k = 21; k >= 1; k -= 2) sum = sum * square + 1.0 / k;
    return exponent * log10_2 + 2 * s * sum * log10_e;
}

}  // namespace scb
