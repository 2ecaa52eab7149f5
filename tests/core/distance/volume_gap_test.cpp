#include "core/distance/volume_gap.h"

#include <gtest/gtest.h>

#include "core/model/node_volume.h"
#include "core/volumes/shape.h"
#include "scb/triangle_distance.h"
#include "tests/core/collide/small_scenes.h"

namespace scb {
namespace {

/// What the test divides its counts by: sanitizers take some twenty times as long.
constexpr int effort_of_gaps = unless_sanitized(1, 20);

template <Volume V>
ConvexShape convex(const V& v) {
    if constexpr (requires { shape_of(v).support_point; })
        return shape_of(v);
    else
        return convex_shape(NodeVolume(shape_of(v)));
}

Vec3 farthest(const ConvexShape& shape, const Vec3& direction) {
    return shape.center + shape.support_point(direction) +
           shape.rounding * direction / std::sqrt(squared_norm(direction));
}

/// Its farthest point where a plane or both cut the ball, or else the ball's.
ConvexShape convex(const Scb2& scb) {
    const auto point = [scb](const Vec3& direction) -> Vec3 {
        Mat3 axes;
        axes << scb.slabs[0].n, scb.slabs[1].n, long_axis(scb);
        const Vec3 d = axes.transpose() * direction;
        const Vec3 k(d[0] < 0 ? scb.slabs[0].f : scb.slabs[0].e,
                     d[1] < 0 ? scb.slabs[1].f : scb.slabs[1].e, 0);
        const auto is_inside = [&](const Vec3& p) {
            return std::abs(p[0]) <= std::abs(k[0]) * (1 + 1e-15) &&
                   std::abs(p[1]) <= std::abs(k[1]) * (1 + 1e-15);
        };
        const Vec3 on_ball = scb.r / d.norm() * d;
        if (is_inside(on_ball)) return axes * on_ball;
        for (int i = 0; i < 2; ++i) {
            Vec3 rim = d;
            rim[i] = 0;
            const double length = rim.norm();
            if (length > 0) rim *= std::sqrt(scb.r * scb.r - k[i] * k[i]) / length;
            rim[i] = k[i];
            if (std::abs(on_ball[i]) > std::abs(k[i]) && is_inside(rim)) return axes * rim;
        }
        const double rest = std::sqrt(std::max(0.0, scb.r * scb.r - k[0] * k[0] - k[1] * k[1]));
        return axes * Vec3(k[0], k[1], d[2] < 0 ? -rest : rest);
    };
    return {scb.c, 0, Mat3::Identity(), point};
}

/// The distance of two points of the shapes, nearly the nearest: by the algorithm of Frank and
/// Wolfe. It is never below the distance of the shapes.
double distance_of_points(const ConvexShape& a, const ConvexShape& b) {
    Vec3 x = farthest(a, b.center - a.center), y = farthest(b, a.center - b.center);
    double least = std::sqrt(squared_norm(x - y));
    for (int k = 0; k < 60 && least > 0; ++k) {
        const Vec3 way = y - x;
        const TriangleCorners of_a = {x, farthest(a, way), x}, of_b = {y, farthest(b, -way), y};
        const TriangleDistance next = triangle_distance(of_a, of_b);
        if (next.distance >= least) break;
        least = next.distance;
        x = next.point_a;
        y = next.point_b;
    }
    return least;
}

// Pairs of nodes from touching to far apart.
TEST(VolumeGap, IsNeverAboveTheDistanceOfTwoPointsOfTheVolumes) {
    Random random(43);
    for (std::size_t kind = 0; kind < all_volume_kinds().size(); ++kind) {
        SCOPED_TRACE(volume_kind_name(all_volume_kinds()[kind]));
        const BuiltMesh a(random_soup(random.next(), 60, 0.4)),
            b(random_soup(random.next(), 60, 0.4));
        double bounds = 0, distances = 0;
        int positive = 0;
        std::visit(
            [&]<Volume V>(const Hierarchy<V>& of_a) {
                const Hierarchy<V>& of_b = std::get<Hierarchy<V>>(b.hierarchies[kind]);
                for (int i = 0; i < 4000 / effort_of_gaps; ++i) {
                    Pose pose = random_pose(random, 0.1);
                    pose.translation += Vec3(std::pow(10, random.uniform(-2, 2)), 0, 0);
                    const V &x = of_a.volumes[random.below(
                                static_cast<std::uint32_t>(of_a.volumes.size()))],
                            &y = of_b.volumes[random.below(
                                static_cast<std::uint32_t>(of_b.volumes.size()))];
                    const Placement placed = placement(pose, 4 * reach(x), 4 * reach(y));
                    const double bound = volume_gap(x, y, placed).bound,
                                 distance =
                                     distance_of_points(convex(x), scb::placed(convex(y), pose));
                    ASSERT_LE(bound, distance * (1 + 1e-14)) << i;
                    ASSERT_GE(bound, 0);
                    positive += bound > 0;
                    bounds += bound;
                    distances += distance;
                }
            },
            a.hierarchies[kind]);
        EXPECT_GT(positive, 2000 / effort_of_gaps);
        EXPECT_GT(bounds, 0.95 * distances) << "the bounds are weak";
    }
}

}  // namespace
}  // namespace scb
