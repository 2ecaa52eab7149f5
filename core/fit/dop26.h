#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/geometry/points.h"
#include "scb/vec.h"

namespace scb {

/// The discrete orientation polytope of Figure 3, line 1 (Klosowski et al. call it a k-DOP): the
/// extent of a point set along 13 fixed directions with coordinates in {0, 1, -1}, and the points
/// that span it.
struct Dop26 {
    static constexpr std::size_t directions = 13;
    /// Fills whole vectors: the last direction is repeated.
    static constexpr std::size_t padded = 16;
    using Numbers = std::array<double, padded>;

    alignas(64) Numbers upper;  ///< max of direction.p; the direction is not a unit vector
    alignas(64) Numbers lower;  ///< min of direction.p
    /// A point that attains it, the smallest id of several. A double, so that the mask that selects
    /// the value also selects the id.
    alignas(64) Numbers upper_id;
    alignas(64) Numbers lower_id;
};

/// The 13 directions, not normalized: lengths 1 (first three), sqrt 2 (next six) and sqrt 3 (last
/// four); x, y and z of all directions.
struct Dop26Directions {
    alignas(64) Dop26::Numbers x = {1, 0, 0, 1, 1, 1, 1, 0, 0, 1, 1, 1, 1, 1, 1, 1};
    alignas(64) Dop26::Numbers y = {0, 1, 0, 1, -1, 0, 0, 1, 1, 1, 1, -1, -1, -1, -1, -1};
    alignas(64) Dop26::Numbers z = {0, 0, 1, 0, 0, 1, -1, 1, -1, 1, -1, 1, -1, -1, -1, -1};
    alignas(64) Dop26::Numbers inverse_length = {1,  1,  1,  s2, s2, s2, s2, s2,
                                                 s2, s3, s3, s3, s3, s3, s3, s3};

    Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }

  private:
    static constexpr double s2 = 0.70710678118654752440;
    static constexpr double s3 = 0.57735026918962576451;
};
inline constexpr Dop26Directions dop26_directions;

/// The DOP of the points, with `id = first_id + index`; at least one point.
Dop26 dop26_of(const PointsView& points, std::uint32_t first_id = 0);

/// The DOP of the union of two sets, from their DOPs. The result, ties included, is the same as the
/// DOP of all points.
Dop26 merge(const Dop26& a, const Dop26& b);

}  // namespace scb
