#include "core/model/cut_ball_shape.h"

#include <array>
#include <cmath>

namespace scb {
namespace {

/// The farthest point of a ball cut by two slabs, from its center. `frame`: both normals and their
/// product, as columns. The point is on no plane, on one or on two: of these points, it is the
/// farthest one that is in both slabs.
Vec3 farthest_point(const Scb2& scb, const Mat3& frame, const Vec3& direction) {
    constexpr int beside = -1;  // on neither plane of the slab
    const Vec3 d(dot(frame.col(0), direction), dot(frame.col(1), direction),
                 dot(frame.col(2), direction));
    const std::array<std::array<double, 2>, 2> planes = {
        {{scb.slabs[0].f, scb.slabs[0].e}, {scb.slabs[1].f, scb.slabs[1].e}}};
    Vec3 best = Vec3::Zero();
    double most = -HUGE_VAL;
    const auto try_planes = [&](const std::array<int, 2>& chosen) {
        Vec3 point = Vec3::Zero(), along = d;
        for (int i = 0; i < 2; ++i) {
            if (chosen[static_cast<std::size_t>(i)] == beside) continue;
            along[i] = 0;
            point[i] = planes[static_cast<std::size_t>(i)]
                             [static_cast<std::size_t>(chosen[static_cast<std::size_t>(i)])];
        }
        const double squared = scb.r * scb.r - squared_norm(point);
        if (squared < 0) return;
        const double length = std::sqrt(squared_norm(along));
        if (length > 0) point += along * (std::sqrt(squared) / length);
        for (int i = 0; i < 2; ++i) {
            const auto& [lower, upper] = planes[static_cast<std::size_t>(i)];
            if (point[i] < lower || point[i] > upper) return;
        }
        if (const double reached = dot(point, d); reached > most) {
            most = reached;
            best = point;
        }
    };
    for (const int first : {beside, 0, 1})
        for (const int second : {beside, 0, 1}) try_planes({first, second});
    return frame * best;
}

}  // namespace

ConvexShape cut_ball_shape(const Scb2& scb) {
    Mat3 frame;
    frame.col(0) = scb.slabs[0].n;
    frame.col(1) = scb.slabs[1].n - dot(scb.slabs[0].n, scb.slabs[1].n) * scb.slabs[0].n;
    for (int i = 0; i < 2; ++i) frame.col(i) /= std::sqrt(squared_norm(Vec3(frame.col(i))));
    frame.col(2) = cross(Vec3(frame.col(0)), Vec3(frame.col(1)));
    return {
        scb.c, 0, frame, [scb, frame](const Vec3& d) { return farthest_point(scb, frame, d); }, {}};
}

}  // namespace scb
