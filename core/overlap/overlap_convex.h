#pragma once

#include "core/overlap/gjk.h"
#include "scb/convex.h"
#include "scb/placement.h"
#include "scb/stage.h"

namespace scb {

/// The set of differences of the cores of A and placed B: it contains the origin if they meet.
template <ConvexVolume V>
struct CoreDifference {
    const V& a;
    const V& b;
    const Pose& b_to_a;
    Vec3 to_b;  ///< from A's center to B's

    CoreDifference(const V& of_a, const V& of_b, const Placement& placed)
        : a(of_a),
          b(of_b),
          b_to_a(placed.b_to_a),
          to_b(transform_point(placed.b_to_a, center(of_b)) - center(of_a)) {}

    Vec3 operator()(const Vec3& d) const {
        const Mat3& r = b_to_a.rotation;
        const Vec3 in_b(-dot(Vec3(r.col(0)), d), -dot(Vec3(r.col(1)), d), -dot(Vec3(r.col(2)), d));
        return support_point(a, d) - to_b - transform_direction(b_to_a, support_point(b, in_b));
    }
};

/// Two convex volumes, by their farthest points: first along the line through the centers, then
/// along the directions in which the search of Gilbert, Johnson and Keerthi closes in on the
/// closest points of the cores. A pair is rejected only along a direction that separates it by more
/// than the margin, so rounding in the search never makes the test reject touching volumes. Exact
/// up to rounding and the margin. `observe(stage, d, w)` receives each direction d, and the
/// farthest point w along d.
template <ConvexVolume V, class Observe>
Stage overlap_convex(const V& a, const V& b, const Placement& placed, const Observe& observe) {
    const CoreDifference<V> farthest(a, b, placed);
    const double rounded = rounding(a) + rounding(b) + placed.margin;
    Stage stage = Stage::center_line, result = Stage::overlapping;
    const auto is_done = [&](const Vec3& d, const Vec3& w) {
        observe(stage, d, w);
        const double along = -dot(d, w);
        if (along > 0 && along * along > rounded * rounded * squared_norm(d)) {
            result = stage;
            return true;
        }
        // From the second step on, -d is a difference of two points of the cores.
        const bool meet = stage == Stage::search && squared_norm(d) <= rounded * rounded;
        stage = Stage::search;
        return meet;
    };
    Vec3 first = farthest.to_b;
    if (!(squared_norm(first) > 0)) first = Vec3::UnitX();
    gjk(farthest, first, is_done);
    return result;
}

template <ConvexVolume V>
Stage overlap_convex(const V& a, const V& b, const Placement& placed) {
    return overlap_convex(a, b, placed, [](Stage, const Vec3&, const Vec3&) {});
}

}  // namespace scb
