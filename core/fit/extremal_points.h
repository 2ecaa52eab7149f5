#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/fit/dop26.h"
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

/// Per direction of a DOP, the indices of its pair of extremal points.
struct ExtremalPairs {
    alignas(64) std::array<std::int32_t, Dop26::padded> upper, lower;
};

/// The distinct extremal points of a DOP (the set E of Figure 3), looked up by id, in the order of
/// the directions, upper before lower; and the pairs among them.
void extremal_points(const Dop26& dop, const PointsView& by_id, FewPoints& points,
                     ExtremalPairs& pairs);

using FlatPoint = std::array<double, 2>;

/// A unit vector across which points of a plane are least wide: the direction of an edge of their
/// convex hull, the first of several. (1, 0) if all points coincide, or there are none. At most
/// FewPoints::capacity points; they are sorted in place.
FlatPoint narrowest_direction(std::span<FlatPoint> points);

}  // namespace scb
