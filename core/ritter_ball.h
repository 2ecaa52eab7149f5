#pragma once

#include <array>
#include <cstdint>

#include "core/ball.h"
#include "core/points.h"

namespace scb {

/// Ritter's update: the smallest ball that contains `ball` and the point; unchanged where the point
/// is inside.
void shift_to_enclose(Ball& ball, const Vec3& point);

/// `ball` grown by Ritter's update over the points, part after part in their order. Contains all of
/// them; not always the old ball to the last bit.
Ball grown_by_shifting(Ball ball, const std::array<PointsView, 2>& parts,
                       std::uint64_t* visits = nullptr);

/// Ritter's ball ("An efficient bounding sphere", Graphics Gems, 1990): starts from the most
/// distant of the pairs of extremal points along the three axes, then grows over all points. Some 5
/// to 20 % larger than the smallest ball. `axis_pairs`: for x, y, z the two extremal points.
Ball ritter_ball(const std::array<std::array<Vec3, 2>, 3>& axis_pairs,
                 const std::array<PointsView, 2>& parts);

}  // namespace scb
