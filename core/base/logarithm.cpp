#include "core/base/logarithm.h"

#include <cmath>

namespace scb {

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
