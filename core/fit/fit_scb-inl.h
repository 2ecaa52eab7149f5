// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_FIT_SCB_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_FIT_SCB_INL_H_
#undef SCB_CORE_FIT_SCB_INL_H_
#else
#define SCB_CORE_FIT_SCB_INL_H_
#endif

#include <array>
#include <limits>

#include "core/fit/fit_ball-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

struct CandidateSlab {
    Vec3 n;
    double width;  // of `interval`, or of the DOP's slab until `interval` is measured
    Interval interval;
    bool measured;
};

// Line 7: the narrowest of the 13 slabs of the DOP, the first of several.
HWY_INLINE CandidateSlab narrowest_dop_slab(const Dop26& dop) {
    alignas(64) Dop26::Numbers widths;
    Doubles narrowest = Doubles::all(std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < Dop26::padded; i += double_lanes) {
        const Doubles width = (Doubles::load(&dop.upper[i]) - Doubles::load(&dop.lower[i])) *
                              Doubles::load(&dop26_directions.inverse_length[i]);
        width.store(&widths[i]);
        narrowest = min(narrowest, width);
    }
    const double width = narrowest.smallest();
    const std::size_t first = first_equal(widths.data(), widths.size(), width);
    return {dop26_directions[first] * dop26_directions.inverse_length[first], width, {}, false};
}

// Line 9: the point farthest from the line through h and l, the first of several. Line 10: the unit
// normal of the three. False if they are collinear.
HWY_INLINE bool normal_of_largest_triangle(const FewPoints& points, const Vec3& h, const Vec3& l,
                                           Vec3& normal) {
    const Vec3 d = l - h;
    const Doubles3 start = Doubles3::all(h), along = Doubles3::all(d);
    const Largest squared_area = first_largest(points, [&](Doubles3 p) HWY_ATTR {
        const Doubles3 c = cross(along, p - start);
        return dot(c, c);
    });
    // Squares of tiny areas lose their digits to underflow, and cannot be distinguished from
    // collinear points.
    if (!(squared_area.value > 1e-280)) return false;
    normal = cross(d, points[squared_area.index] - h) / std::sqrt(squared_area.value);
    return true;
}

// Lines 11 to 13, which end as soon as the slab is no narrower. The extremal points come first,
// since they mostly decide. Returns the number of visited points.
HWY_INLINE std::size_t keep_if_narrower(CandidateSlab& best, const Vec3& n, const Vec3& c,
                                        const FitInput& input) {
    Interval interval = interval_of(*input.few, c, n);
    std::size_t visits = input.few->count;
    if (!input.is_few())
        for (const PointsView& part : input.parts) {
            if (interval.width() >= best.width) return visits;
            visits += extend(interval, part, c, n, best.width);
        }
    if (interval.width() < best.width) best = {n, interval.width(), interval, true};
    return visits;
}

HWY_INLINE void fit(Scb& result, const FitInput& input, const FitOptions& options,
                    FitCounts& counts) {
    const Ball ball = enclosing_ball(input, options.growth, counts.point_visits);

    // If there are few points, all of them count, as for the ball: the third corner of a slender
    // triangle need not be extremal, and a slab through the other two alone is not flat.
    const FewPoints& points = *input.few;
    CandidateSlab slab = narrowest_dop_slab(*input.dop);
    std::array<std::uint32_t, FewPoints::capacity> met{};  // bit j of element i: the pair i < j
    for (std::size_t i = 0; i < Dop26::directions; ++i) {
        const auto upper = static_cast<std::size_t>(input.pairs->upper[i]),
                   lower = static_cast<std::size_t>(input.pairs->lower[i]);
        std::uint32_t& row = met[std::min(upper, lower)];
        const std::uint32_t bit = std::uint32_t{1} << std::max(upper, lower);
        if (upper == lower || (row & bit) != 0) continue;
        row |= bit;
        Vec3 n;
        if (!normal_of_largest_triangle(points, points[upper], points[lower], n)) continue;
        counts.point_visits += keep_if_narrower(slab, n, ball.center, input);
        ++counts.candidate_slabs;
    }
    if (!slab.measured) {
        if (input.is_few())
            slab.interval = interval_of(points, ball.center, slab.n);
        else
            for (const PointsView& part : input.parts)
                extend(slab.interval, part, ball.center, slab.n);
        counts.point_visits += input.size();
    }

    // The center is in the convex hull, so f <= 0 <= e up to rounding, which is corrected outward.
    result.c = ball.center;
    result.n = slab.n;
    result.e = std::max(slab.interval.upper, 0.0);
    result.f = std::min(slab.interval.lower, 0.0);
    result.r = std::max({ball.radius, result.e, -result.f});
    result.e = std::min(result.e + options.margin * result.r, result.r);
    result.f = std::max(result.f - options.margin * result.r, -result.r) + 0.0;  // 0 for -0
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
