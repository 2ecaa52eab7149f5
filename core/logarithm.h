#pragma once

namespace scb {

/// The logarithm of a positive finite number to base 10, within a few units in the last place; the
/// same bits on every machine, which those of the C library are not.
double decimal_logarithm(double x);

}  // namespace scb
