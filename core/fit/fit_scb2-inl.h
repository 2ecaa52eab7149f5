// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_FIT_SCB2_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_FIT_SCB2_INL_H_
#undef SCB_CORE_FIT_SCB2_INL_H_
#else
#define SCB_CORE_FIT_SCB2_INL_H_
#endif

#include <algorithm>

#include "core/fit/extremal_points.h"
#include "core/fit/fit_scb-inl.h"
#include "scb/scb2.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// A unit vector at right angles to the unit vector n.
HWY_INLINE Vec3 unit_across(const Vec3& n, Vec3 v) {
    // Twice, since the rounding of the first difference remains if the vector is nearly along n.
    for (int i = 0; i < 2; ++i) {
        v -= dot(n, v) * n;
        v /= std::sqrt(squared_norm(v));
    }
    return v;
}

/// The normal of the narrowest slab at right angles to n that holds the few points. Projected along
/// n, an edge of the points' hull is in one of its planes, as for every narrowest strip (Houle and
/// Toussaint, "Computing the Width of a Set", 1988).
HWY_INLINE Vec3 narrowest_across(const Vec3& n, const FewPoints& points) {
    const Vec3 axis = std::abs(n[0]) < 0.5 ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 u = unit_across(n, axis), v = cross(n, u);
    const Vec3 origin = points[0];
    std::array<FlatPoint, FewPoints::capacity> seen;
    for (std::size_t i = 0; i < points.count; ++i) {
        const Vec3 q = points[i] - origin;
        seen[i] = {dot(u, q), dot(v, q)};
    }
    const FlatPoint direction = narrowest_direction({seen.data(), points.count});
    return unit_across(n, Vec3(direction[0] * u + direction[1] * v));
}

/// Figure 3, and a second slab: the narrowest of the few points at right angles to the first one.
HWY_INLINE void fit(Scb2& result, const FitInput& input, const FitOptions& options,
                    FitCounts& counts) {
    FitOptions tight = options;
    tight.margin = 0;
    Scb one;
    fit(one, input, tight, counts);

    const Vec3 n = narrowest_across(one.n, *input.few);
    Interval interval;
    if (input.is_few())
        interval = interval_of(*input.few, one.c, n);
    else
        for (const PointsView& part : input.parts) extend(interval, part, one.c, n);
    counts.point_visits += input.size();
    ++counts.candidate_slabs;

    result.c = one.c;
    result.slabs = {Slab{one.n, one.e, one.f},
                    Slab{n, std::max(interval.upper, 0.0), std::min(interval.lower, 0.0)}};
    result.r = std::max({one.r, result.slabs[1].e, -result.slabs[1].f});
    for (Slab& slab : result.slabs) {
        slab.e = std::min(slab.e + options.margin * result.r, result.r);
        slab.f = std::max(slab.f - options.margin * result.r, -result.r) + 0.0;  // 0 for -0
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
