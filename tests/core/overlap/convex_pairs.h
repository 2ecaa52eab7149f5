#pragma once

#include <vector>

#include "core/fit/fit_input.h"
#include "scb/fit_points.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {

/// A convex volume fitted to a list of points.
template <class V>
V fitted(const std::vector<Vec3>& points) {
    const PointArrays arrays(points);
    const Dop26 dop = dop26_of(arrays.view());
    V result;
    fit(result, FitPoints(FitInput{{arrays.view(), {}}, nullptr, nullptr, &dop, nullptr}));
    return result;
}

/// A cloud of up to 40 points about a place, stretched, sometimes flat, a line or a point.
inline std::vector<Vec3> random_cloud(Random& random) {
    const Pose pose = random_pose(random);
    Vec3 size;
    for (int i = 0; i < 3; ++i) size[i] = random.below(6) == 0 ? 0 : random.uniform(0.05, 0.6);
    std::vector<Vec3> points;
    const std::size_t count = 1 + random.below(40);
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(transform_point(pose, Vec3(random_point(random).cwiseProduct(size))));
    return points;
}

}  // namespace scb
