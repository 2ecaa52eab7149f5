#pragma once

namespace scb {

struct SinCos {
    double sin = 0;
    double cos = 1;
};

/// Sine and cosine of an angle in turns (1 turn = 360 degrees), to about one unit in the last
/// place, and exact at multiples of a quarter. The C library's functions round differently from one
/// version and CPU to the next, so poses made with them would not give the same counts everywhere;
/// this uses only operations that IEEE 754 fixes.
SinCos sin_cos_turns(double turns);

inline SinCos sin_cos_degrees(double degrees) { return sin_cos_turns(degrees / 360); }

/// The angle in radians, from 0 to pi/2, whose tangent is y / x, to a few units in the last place.
/// Both must be at least 0; the result is 0 if both are 0. Like sin_cos_turns, it uses only
/// operations that IEEE 754 fixes.
double arc_tangent(double y, double x);

// Logarithms of positive finite numbers by operations that IEEE 754 fixes: the C library rounds
// them differently from CPU to CPU.

/// To base 2, within a few units in the last place; exact for powers of two.
double binary_logarithm(double x);

/// To base 10, within a few units in the last place.
inline double decimal_logarithm(double x) { return 0.30102999566398119521 * binary_logarithm(x); }

}  // namespace scb
