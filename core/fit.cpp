#include "core/fit.h"

#include <cmath>
#include <sstream>

#include "core/error.h"
#include "core/mesh.h"

namespace scb {

std::string_view ball_growth_name(BallGrowth growth) {
    return growth == BallGrowth::ritter ? "ritter" : "radius";
}

namespace {

template <class Volume>
Volume fit_points(std::span<const Vec3> points, const FitOptions& options) {
    if (points.empty()) throw InputError("no points to fit a volume to; give at least one.");
    if (!(options.margin >= 0))
        throw InputError("the margin is below 0 or not a number; give a share of the radius.");
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!(points[i].cwiseAbs().array() <= max_coordinate).all()) {
            std::ostringstream sentence;
            sentence << "point " << i << " is not finite, or beyond " << max_coordinate
                     << "; a volume needs finite points.";
            throw InputError(sentence.str());
        }
    const PointArrays arrays(points);
    const Dop26 dop = dop26_of(arrays.view());
    Volume result;
    fit(result,
        {{arrays.view(), {}}, arrays.x.data(), arrays.y.data(), arrays.z.data(), &dop, nullptr},
        options);
    return result;
}

}  // namespace

Scb fit_scb(std::span<const Vec3> points, const FitOptions& options) {
    return fit_points<Scb>(points, options);
}
Ball fit_ball(std::span<const Vec3> points, const FitOptions& options) {
    return fit_points<Ball>(points, options);
}
Obb fit_obb(std::span<const Vec3> points, const FitOptions& options) {
    return fit_points<Obb>(points, options);
}

}  // namespace scb
