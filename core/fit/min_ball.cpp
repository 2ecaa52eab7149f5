#include "core/fit/min_ball.h"

#include "core/base/simd_targets.h"

// For the baseline target alone: fits compile their own.
#include "core/fit/min_ball-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

struct ManyPoints {
    PointsView view;
    Vec3 operator[](std::size_t i) const { return view[i]; }
};

Largest farthest_point(const ManyPoints& points, const Vec3& c) {
    Largest result{0, -1};
    for (std::size_t i = 0; i < points.view.size; ++i) {
        const double squared = squared_norm(points[i] - c);
        if (squared > result.value) result = {i, squared};
    }
    return result;
}

Ball min_ball_of_list(const PointsView& points) {
    std::uint64_t visits = 0;
    return min_ball_of(ManyPoints{points}, points.size, visits);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

namespace scb {

Ball min_ball(std::span<const Vec3> points) {
    if (points.empty()) return {};
    return HWY_NAMESPACE::min_ball_of_list(PointArrays(points).view());
}

}  // namespace scb
