// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_FIT_BALL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_FIT_BALL_INL_H_
#undef SCB_CORE_FIT_BALL_INL_H_
#else
#define SCB_CORE_FIT_BALL_INL_H_
#endif

#include <cmath>

#include "core/fit/fit_input.h"
#include "core/fit/min_ball-inl.h"
#include "scb/fit.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Ritter's update: the smallest ball that contains `ball` and the point; unchanged if the point is
/// inside.
HWY_INLINE void shift_to_enclose(Ball& ball, const Vec3& point) {
    const Vec3 offset = point - ball.center;
    const double squared = squared_norm(offset);
    if (squared <= ball.radius * ball.radius) return;
    const double distance = std::sqrt(squared);
    const double radius = (ball.radius + distance) / 2;
    ball.center += (1 - radius / distance) * offset;
    ball.radius = radius;
}

/// The smallest ball about this center that contains all points.
HWY_INLINE Ball reaching(const Vec3& center, const FitInput& input, std::uint64_t& visits) {
    double reach = 0;
    for (const PointsView& part : input.parts)
        reach = std::max(reach, max_squared_distance(part, center));
    visits += input.size();
    return {center, radius_reaching(reach)};
}

/// `ball` grown by Ritter's update over the points, in their order. Contains all of them; not
/// always the old ball to the last bit.
HWY_INLINE Ball grown_by_shifting(Ball ball, const FitInput& input, std::uint64_t& visits) {
    constexpr std::size_t block = 64;
    for (const PointsView& part : input.parts)
        for (std::size_t first = 0; first < part.size; first += block) {
            const PointsView points = part.sub(first, std::min(block, part.size - first));
            visits += points.size;
            // Mostly all points are inside, which is quicker to see for a whole block.
            if (max_squared_distance(points, ball.center) <= ball.radius * ball.radius) continue;
            visits += points.size;
            for (std::size_t i = 0; i < points.size; ++i) shift_to_enclose(ball, points[i]);
        }
    // The center moved after the first points, so the radius is measured again.
    return reaching(ball.center, input, visits);
}

/// Lines 1 to 6 of Figure 3: the ball of an SCB, and of a ball hierarchy.
HWY_INLINE Ball enclosing_ball(const FitInput& input, BallGrowth growth, std::uint64_t& visits) {
    const Ball ball = min_ball_of(*input.few, input.few->count, visits);
    if (input.is_few()) return ball;
    return growth == BallGrowth::ritter ? grown_by_shifting(ball, input, visits)
                                        : reaching(ball.center, input, visits);
}

/// Ritter's ball ("An efficient bounding sphere", Graphics Gems, 1990): starts from the most
/// distant of the pairs of extremal points along the three axes, then grows over all points. Some 5
/// to 20 % larger than the smallest ball.
HWY_INLINE Ball ritter_ball(const FitInput& input, std::uint64_t& visits) {
    std::array<Vec3, 2> widest = {Vec3::Zero(), Vec3::Zero()};
    double largest = -1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Vec3 lower = (*input.few)[static_cast<std::size_t>(input.pairs->lower[axis])],
                   upper = (*input.few)[static_cast<std::size_t>(input.pairs->upper[axis])];
        const double squared = squared_norm(upper - lower);
        if (!(squared > largest)) continue;
        largest = squared;
        widest = {lower, upper};
    }
    const Vec3 half = 0.5 * (widest[1] - widest[0]);
    return grown_by_shifting({widest[0] + half, std::sqrt(squared_norm(half))}, input, visits);
}

HWY_INLINE void fit(Ball& result, const FitInput& input, const FitOptions& options,
                    FitCounts& counts) {
    result = options.ball_method == BallMethod::minimum
                 ? enclosing_ball(input, options.growth, counts.point_visits)
                 : ritter_ball(input, counts.point_visits);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
