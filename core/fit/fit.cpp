#include "scb/fit.h"

#include "core/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit/fit.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/fit/dop26-inl.h"
#include "core/fit/fit_obb-inl.h"
#include "core/fit/fit_scb2-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

template <class V>
V fit_list(std::span<const Vec3> points, const FitOptions& options) {
    const PointArrays arrays(points);
    const PointsView all = arrays.view();
    const Dop26 dop = dop26_of(all);
    FewPoints few;
    ExtremalPairs pairs;
    if (all.size <= FewPoints::capacity) {
        for (const Vec3& p : points) few.add(p[0], p[1], p[2]);
        few.pad();
        for (std::size_t i = 0; i < Dop26::directions; ++i) {
            pairs.upper[i] = static_cast<std::int32_t>(dop.upper_id[i]);
            pairs.lower[i] = static_cast<std::int32_t>(dop.lower_id[i]);
        }
    } else {
        extremal_points(dop, all, few, pairs);
    }
    V result;
    FitCounts counts;
    fit(result, {{all, {}}, &few, &pairs, &dop, nullptr}, options, counts);
    if (options.counts != nullptr) options.counts->add(counts);
    return result;
}

Scb fit_scb_list(std::span<const Vec3> points, const FitOptions& options) {
    return fit_list<Scb>(points, options);
}
Scb2 fit_scb2_list(std::span<const Vec3> points, const FitOptions& options) {
    return fit_list<Scb2>(points, options);
}
Ball fit_ball_list(std::span<const Vec3> points, const FitOptions& options) {
    return fit_list<Ball>(points, options);
}
Obb fit_obb_list(std::span<const Vec3> points, const FitOptions& options) {
    return fit_list<Obb>(points, options);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "core/base/enum_names.h"
#include "core/base/text_format.h"
#include "scb/error.h"
#include "scb/mesh.h"

namespace scb {

HWY_EXPORT(fit_scb_list);
HWY_EXPORT(fit_scb2_list);
HWY_EXPORT(fit_ball_list);
HWY_EXPORT(fit_obb_list);

std::string_view ball_growth_name(BallGrowth growth) {
    return EnumNames<BallGrowth, 2>{"radius", "ritter"}[growth];
}

namespace {

void check(std::span<const Vec3> points, const FitOptions& options) {
    if (points.empty()) throw InputError("no points to fit a volume to; give at least one.");
    if (!(options.margin >= 0))
        throw InputError("the margin is below 0 or not a number; give a share of the radius.");
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!(points[i].cwiseAbs().array() <= max_coordinate).all())
            throw InputError(sentence("point ", i, " is not finite, or beyond ", max_coordinate,
                                      "; a volume needs finite points."));
}

}  // namespace

Scb fit_scb(std::span<const Vec3> points, const FitOptions& options) {
    check(points, options);
    return SCB_AT_LEVEL(fit_scb_list, options.simd)(points, options);
}
Scb2 fit_scb2(std::span<const Vec3> points, const FitOptions& options) {
    check(points, options);
    return SCB_AT_LEVEL(fit_scb2_list, options.simd)(points, options);
}
Ball fit_ball(std::span<const Vec3> points, const FitOptions& options) {
    check(points, options);
    return SCB_AT_LEVEL(fit_ball_list, options.simd)(points, options);
}
Obb fit_obb(std::span<const Vec3> points, const FitOptions& options) {
    check(points, options);
    return SCB_AT_LEVEL(fit_obb_list, options.simd)(points, options);
}

}  // namespace scb
#endif
