#include <algorithm>
#include <cmath>

#include "core/extremal_points.h"
#include "core/fit.h"
#include "core/fit_ball.h"
#include "core/point_passes.h"

namespace scb {
namespace {

struct Slab {
    Vec3 n;
    double width;  // of the interval below, or of the DOP's, before the interval is known
    Interval interval;
    bool measured;
};

// Line 7: the narrowest of the 13 slabs of the DOP. The directions have lengths 1, sqrt 2 and
// sqrt 3.
Slab narrowest_dop_slab(const Dop26& dop) {
    Slab slab{};
    int narrowest = 0;
    for (int i = 0; i < Dop26::directions; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double width = (dop.upper[k] - dop.lower[k]) * dop26_inverse_length(i);
        if (i != 0 && !(width < slab.width)) continue;
        slab.width = width;
        narrowest = i;
    }
    slab.n =
        dop26_directions()[static_cast<std::size_t>(narrowest)] * dop26_inverse_length(narrowest);
    return slab;
}

// Line 9: the point farthest from the line through h and l, the first of several; line 10: the unit
// normal of the three. False where they are collinear.
bool normal_of_largest_triangle(const PointsView& points, const Vec3& h, const Vec3& l,
                                Vec3& normal) {
    const Vec3 d = l - h;
    std::array<double, ExtremalPoints::capacity> squared_area{};
    for (std::size_t i = 0; i < points.size; ++i) {
        const double x = points.x[i] - h[0], y = points.y[i] - h[1], z = points.z[i] - h[2];
        const double cx = d[1] * z - d[2] * y, cy = d[2] * x - d[0] * z, cz = d[0] * y - d[1] * x;
        squared_area[i] = cx * cx + cy * cy + cz * cz;
    }
    std::size_t far = 0;
    for (std::size_t i = 1; i < points.size; ++i)
        if (squared_area[i] > squared_area[far]) far = i;
    // Squares of tiny areas lose their digits to underflow, and then are no more than those of
    // collinear points.
    if (!(squared_area[far] > 1e-280)) return false;
    normal = cross(d, points[far] - h) / std::sqrt(squared_area[far]);
    return true;
}

// Lines 11 to 13, given up as soon as the slab is no narrower. The extremal points come first: they
// mostly decide. Returns how many points were looked at.
std::size_t keep_if_narrower(Slab& best, const Vec3& n, const Vec3& c, const PointsView& extremal,
                             const FitInput& input) {
    Interval interval;
    std::size_t visits = extend(interval, extremal, c, n, best.width);
    for (const PointsView& part : input.parts) {
        if (interval.width() >= best.width) return visits;
        visits += extend(interval, part, c, n, best.width);
    }
    if (interval.width() < best.width) best = {n, interval.width(), interval, true};
    return visits;
}

}  // namespace

void fit(Scb& result, const FitInput& input, const FitOptions& options) {
    const ExtremalPoints extremal = extremal_points(*input.dop, input.x, input.y, input.z);
    const Ball ball = enclosing_ball(input, extremal, options);

    // Few points stand for themselves, as they do for the ball: the third corner of a slender
    // triangle need not be extremal, and a slab through the other two alone is not flat.
    const PointsView points = extremal.view();
    const PointsView thirds = input.size() <= ExtremalPoints::capacity ? input.parts[0] : points;

    Slab slab = narrowest_dop_slab(*input.dop);
    std::array<std::uint16_t, Dop26::directions>
        met;  // pairs of extremal points, smaller index first
    std::size_t met_count = 0;
    std::uint64_t visits = 0, candidates = 0;
    for (std::size_t i = 0; i < Dop26::directions; ++i) {
        const std::uint8_t upper = extremal.upper[i], lower = extremal.lower[i];
        const auto pair =
            static_cast<std::uint16_t>(std::min(upper, lower) << 8 | std::max(upper, lower));
        const auto end = met.begin() + static_cast<std::ptrdiff_t>(met_count);
        if (upper == lower || std::find(met.begin(), end, pair) != end) continue;
        met[met_count++] = pair;
        Vec3 n;
        if (!normal_of_largest_triangle(thirds, points[upper], points[lower], n)) continue;
        visits += keep_if_narrower(slab, n, ball.center, points, input);
        ++candidates;
    }
    if (!slab.measured)
        for (const PointsView& part : input.parts)
            visits += extend(slab.interval, part, ball.center, slab.n);
    if (options.counts != nullptr) {
        options.counts->point_visits += visits;
        options.counts->candidate_slabs += candidates;
    }

    // The center is in the convex hull, so f <= 0 <= e but for rounding, which is repaired outward.
    result.c = ball.center;
    result.n = slab.n;
    result.e = std::max(slab.interval.upper, 0.0);
    result.f = std::min(slab.interval.lower, 0.0);
    result.r = std::max({ball.radius, result.e, -result.f});
    result.e = std::min(result.e + options.margin * result.r, result.r);
    result.f = std::max(result.f - options.margin * result.r, -result.r);
}

}  // namespace scb
