#include "core/fit_ball.h"

#include <algorithm>
#include <cassert>

#include "core/min_ball.h"
#include "core/point_passes.h"
#include "core/ritter_ball.h"

namespace scb {
Ball enclosing_ball(const FitInput& input, const ExtremalPoints& extremal,
                    const FitOptions& options) {
    std::uint64_t* visits = options.counts != nullptr ? &options.counts->point_visits : nullptr;
    if (input.size() <= ExtremalPoints::capacity) {
        assert(input.parts[1].size == 0 && "few points come in one part");
        return min_ball(input.parts[0], visits);
    }
    Ball ball = min_ball(extremal.view(), visits);
    if (options.growth == BallGrowth::ritter) return grown_by_shifting(ball, input.parts, visits);
    double reach = 0;
    for (const PointsView& part : input.parts)
        reach = std::max(reach, max_squared_distance(part, ball.center));
    ball.radius = radius_reaching(reach);
    if (visits != nullptr) *visits += input.size();
    return ball;
}

void fit(Ball& result, const FitInput& input, const FitOptions& options) {
    const ExtremalPoints extremal = extremal_points(*input.dop, input.x, input.y, input.z);
    if (options.ball_method == BallMethod::minimum) {
        result = enclosing_ball(input, extremal, options);
        return;
    }
    const PointsView points = extremal.view();
    std::array<std::array<Vec3, 2>, 3> axis_pairs;
    for (std::size_t i = 0; i < 3; ++i)
        axis_pairs[i] = {points[extremal.lower[i]], points[extremal.upper[i]]};
    result = ritter_ball(axis_pairs, input.parts);
}

}  // namespace scb
