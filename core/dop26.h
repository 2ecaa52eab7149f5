#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/points.h"
#include "core/vec.h"

namespace scb {

/// The discrete orientation polytope of Figure 3, line 1 (Klosowski et al. call it a k-DOP): the
/// extent of a point set along 13 fixed directions with coordinates in {0, 1, -1}, and the points
/// that span it.
struct Dop26 {
    static constexpr int directions = 13;

    std::array<double, directions>
        upper;  ///< max of direction.p; the direction is not a unit vector
    std::array<double, directions> lower;  ///< min of direction.p
    std::array<std::uint32_t, directions>
        upper_id;  ///< a point that attains it; the smallest id of several
    std::array<std::uint32_t, directions> lower_id;
};

/// The 13 directions, as they are: lengths 1 (first three), sqrt 2 (next six) and sqrt 3 (last
/// four).
const std::array<Vec3, Dop26::directions>& dop26_directions();

/// The reciprocal length of a direction.
double dop26_inverse_length(int direction);

/// The DOP of no points: adding to it gives the DOP of what was added.
Dop26 empty_dop26();

/// Adds a point with its id. Sums only: no rounding but that of at most two additions.
void add_point(Dop26& dop, double x, double y, double z, std::uint32_t id);

/// The DOP of the union of two sets, from their DOPs. The same, ties included, as adding all points
/// to one.
Dop26 merge(const Dop26& a, const Dop26& b);

/// The DOP of the points, with `id = first_id + index`.
Dop26 dop26_of(const PointsView& points, std::uint32_t first_id = 0);

}  // namespace scb
