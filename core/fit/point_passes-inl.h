// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_POINT_PASSES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_POINT_PASSES_INL_H_
#undef SCB_CORE_POINT_PASSES_INL_H_
#else
#define SCB_CORE_POINT_PASSES_INL_H_
#endif

#include <algorithm>
#include <limits>

#include "core/base/double_lanes-inl.h"
#include "core/fit/extremal_points.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

// Passes over points, a vector at a time. Minimum and maximum do not depend on the order, so the
// result is the same as in a plain loop. Each lane rounds as `contains` does, so the points within
// a pass's bound are contained exactly.

HWY_INLINE Doubles3 load_points(const FewPoints& points, std::size_t i) {
    return {Doubles::load(&points.x[i]), Doubles::load(&points.y[i]), Doubles::load(&points.z[i])};
}
HWY_INLINE Doubles3 load_points(const PointsView& points, std::size_t i) {
    return {Doubles::load(points.x + i), Doubles::load(points.y + i), Doubles::load(points.z + i)};
}

/// Calls `pass` with vectors that hold all points, some perhaps twice. If the points do not fill a
/// vector, calls it with each point, in all lanes.
template <class Pass>
HWY_INLINE void in_vectors(const PointsView& points, Pass pass) {
    if (points.size < double_lanes) {
        for (std::size_t i = 0; i < points.size; ++i) pass(Doubles3::all(points[i]));
        return;
    }
    const std::size_t last = points.size - double_lanes;
    for (std::size_t i = 0; i < last; i += double_lanes) pass(load_points(points, i));
    pass(load_points(points, last));
}

/// The largest |p - c|^2; 0 for no points.
HWY_INLINE double max_squared_distance(const PointsView& points, const Vec3& c) {
    const Doubles3 center = Doubles3::all(c);
    Doubles best = Doubles::all(0);
    in_vectors(points, [&](Doubles3 p) HWY_ATTR {
        const Doubles3 d = p - center;
        best = max(best, dot(d, d));
    });
    return best.largest();
}

/// An interval of signed distances; empty until extended.
struct Interval {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();

    double width() const { return upper - lower; }
};

/// Extends the interval by n.(p - c) of every point; ends early once the interval is at least
/// `enough` wide. Returns the number of visited points.
inline HWY_ATTR std::size_t extend(Interval& interval, const PointsView& points, const Vec3& c,
                                   const Vec3& n,
                                   double enough = std::numeric_limits<double>::infinity()) {
    constexpr std::size_t block = 128;
    const Doubles3 center = Doubles3::all(c), normal = Doubles3::all(n);
    for (std::size_t i = 0; i < points.size; i += block) {
        if (interval.width() >= enough) return i;
        Doubles lower = Doubles::all(interval.lower), upper = Doubles::all(interval.upper);
        in_vectors(points.sub(i, std::min(block, points.size - i)), [&](Doubles3 p) HWY_ATTR {
            const Doubles h = dot(normal, p - center);
            lower = min(lower, h);
            upper = max(upper, h);
        });
        interval.lower = lower.smallest();
        interval.upper = upper.largest();
    }
    return points.size;
}

/// The interval of n.(p - c) over all of the points.
HWY_INLINE Interval interval_of(const FewPoints& points, const Vec3& c, const Vec3& n) {
    const Doubles3 center = Doubles3::all(c), normal = Doubles3::all(n);
    Doubles lower = dot(normal, load_points(points, 0) - center), upper = lower;
    for (std::size_t i = double_lanes; i < points.count; i += double_lanes) {
        const Doubles h = dot(normal, load_points(points, i) - center);
        lower = min(lower, h);
        upper = max(upper, h);
    }
    return {lower.smallest(), upper.largest()};
}

/// The index of the largest number, the first of several, and the number.
struct Largest {
    std::size_t index;
    double value;
};
template <class Number>
HWY_INLINE Largest first_largest(const FewPoints& points, Number number) {
    alignas(64) double numbers[FewPoints::padded];
    Doubles best = number(load_points(points, 0));
    best.store(numbers);
    for (std::size_t i = double_lanes; i < points.count; i += double_lanes) {
        const Doubles some = number(load_points(points, i));
        some.store(numbers + i);
        best = max(best, some);
    }
    const double value = best.largest();
    return {first_equal(numbers, points.count, value), value};
}

/// The first of the points that are farthest from c, and its squared distance.
HWY_INLINE Largest farthest_point(const FewPoints& points, const Vec3& c) {
    const Doubles3 center = Doubles3::all(c);
    return first_largest(points, [&](Doubles3 p) HWY_ATTR {
        const Doubles3 d = p - center;
        return dot(d, d);
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
