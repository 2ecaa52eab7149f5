#pragma once

#include <array>
#include <cstdint>

#include "core/dop26.h"
#include "core/points.h"

namespace scb {

/// The distinct extremal points of a 26-DOP (the set E of Figure 3) and, per direction, which of
/// them are its pair.
struct ExtremalPoints {
    static constexpr std::size_t capacity = 2 * Dop26::directions;

    std::array<double, capacity> x, y, z;
    std::size_t count = 0;
    std::array<std::uint8_t, Dop26::directions> upper, lower;  ///< indices into the above

    PointsView view() const { return {x.data(), y.data(), z.data(), count}; }
};

/// Looks up the points of the DOP by id, in the order of the directions, upper before lower.
ExtremalPoints extremal_points(const Dop26& dop, const double* x, const double* y, const double* z);

}  // namespace scb
