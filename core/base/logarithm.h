#pragma once

namespace scb {

// Logarithms of positive finite numbers by operations that IEEE 754 fixes: the C library rounds
// them differently from CPU to CPU.

/// To base 2, within a few units in the last place; exact for powers of two.
double binary_logarithm(double x);

/// To base 10, within a few units in the last place.
inline double decimal_logarithm(double x) { return 0.30102999566398119521 * binary_logarithm(x); }

}  // namespace scb
