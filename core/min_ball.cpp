#include "core/min_ball.h"

#include "core/min_ball-inl.h"

namespace scb {
namespace {

struct ManyPoints {
    PointsView view;
    Vec3 operator[](std::size_t i) const { return view[i]; }
};

HWY_NAMESPACE::Largest farthest_point(const ManyPoints& points, const Vec3& c) {
    HWY_NAMESPACE::Largest result{0, -1};
    for (std::size_t i = 0; i < points.view.size; ++i) {
        const double squared = squared_norm(points[i] - c);
        if (squared > result.value) result = {i, squared};
    }
    return result;
}

}  // namespace

Ball min_ball(std::span<const Vec3> points) {
    if (points.empty()) return {};
    const PointArrays arrays(points);
    std::uint64_t visits = 0;
    return HWY_NAMESPACE::min_ball_of(ManyPoints{arrays.view()}, points.size(), visits);
}

}  // namespace scb
