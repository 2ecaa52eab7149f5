#include "core/ritter_ball.h"

#include <algorithm>
#include <cmath>

#include "core/point_passes.h"

namespace scb {

void shift_to_enclose(Ball& ball, const Vec3& point) {
    const Vec3 offset = point - ball.center;
    const double squared = squared_norm(offset);
    if (squared <= ball.radius * ball.radius) return;
    const double distance = std::sqrt(squared);
    const double radius = (ball.radius + distance) / 2;
    ball.center += (1 - radius / distance) * offset;
    ball.radius = radius;
}

Ball grown_by_shifting(Ball ball, const std::array<PointsView, 2>& parts, std::uint64_t* visits) {
    constexpr std::size_t block = 64;
    std::uint64_t looked_at = 0;
    for (const PointsView& part : parts)
        for (std::size_t first = 0; first < part.size; first += block) {
            const PointsView points = part.sub(first, std::min(block, part.size - first));
            looked_at += points.size;
            // Mostly all are inside, which is quicker to tell of a block.
            if (max_squared_distance(points, ball.center) <= ball.radius * ball.radius) continue;
            looked_at += points.size;
            for (std::size_t i = 0; i < points.size; ++i) shift_to_enclose(ball, points[i]);
        }
    // The center moved after the first points were met, so what they need is measured anew.
    double reach = 0;
    for (const PointsView& part : parts)
        reach = std::max(reach, max_squared_distance(part, ball.center));
    ball.radius = radius_reaching(reach);
    if (visits != nullptr) *visits += looked_at + parts[0].size + parts[1].size;
    return ball;
}

Ball ritter_ball(const std::array<std::array<Vec3, 2>, 3>& axis_pairs,
                 const std::array<PointsView, 2>& parts) {
    const auto* widest = &axis_pairs[0];
    for (const auto& pair : axis_pairs)
        if (squared_norm(pair[1] - pair[0]) > squared_norm((*widest)[1] - (*widest)[0]))
            widest = &pair;
    const Vec3 half = 0.5 * ((*widest)[1] - (*widest)[0]);
    return grown_by_shifting({(*widest)[0] + half, std::sqrt(squared_norm(half))}, parts);
}

}  // namespace scb
