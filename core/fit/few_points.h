#pragma once

#include <array>
#include <cstddef>

#include "core/geometry/points.h"

namespace scb {

/// Up to 26 points. Copies of the first point fill the last vector. They change no result, since
/// the first of several equal points counts.
struct FewPoints {
    static constexpr std::size_t capacity = 26;
    static constexpr std::size_t padded = 32;

    alignas(64) std::array<double, padded> x, y, z;
    std::size_t count = 0;

    Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    PointsView view() const { return {x.data(), y.data(), z.data(), count}; }

    void add(double px, double py, double pz) {
        x[count] = px;
        y[count] = py;
        z[count] = pz;
        ++count;
    }
    /// After the last point: writes the copies, up to the next multiple of 8.
    void pad() {
        for (std::size_t i = count; i % 8 != 0; ++i) {
            x[i] = x[0];
            y[i] = y[0];
            z[i] = z[0];
        }
    }
};

}  // namespace scb
