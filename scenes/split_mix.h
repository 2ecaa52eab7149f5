#pragma once

#include <cstdint>

namespace scb {

/// The generator SplitMix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number
/// Generators", 2014). The standard library's distributions differ between implementations; this
/// gives the same numbers everywhere.
struct SplitMix64 {
    std::uint64_t state = 0;

    std::uint64_t next() {
        state += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    /// Uniform in [0, 1): the upper 53 bits.
    double next_unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
};

}  // namespace scb
