// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_MIN_BALL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_MIN_BALL_INL_H_
#undef SCB_CORE_MIN_BALL_INL_H_
#else
#define SCB_CORE_MIN_BALL_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/fit/point_passes-inl.h"
#include "scb/ball.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

// Squared radii within this share of each other are the same: cospherical points must not chase
// rounding errors.
inline constexpr double equal_squares = 1 + 1e-15;

// At most four points on the surface of the ball, and the next point to join them.
using Support = std::array<Vec3, 5>;

struct Candidate {
    Vec3 center;
    bool inside_hull;  // the center is in the convex hull of the defining points, so this is their
                       // smallest ball
};

HWY_INLINE Candidate ball_of_two(const Vec3& a, const Vec3& b) { return {a + 0.5 * (b - a), true}; }

// The circumcenter of a triangle; false if the three points are collinear.
HWY_INLINE bool ball_of_three(const Vec3& a, const Vec3& b, const Vec3& c, Candidate& result) {
    const Vec3 u = b - a, v = c - a;
    const double uu = squared_norm(u), vv = squared_norm(v), uv = dot(u, v);
    const double det = squared_norm(cross(u, v));
    if (!(det > 0)) return false;
    const double s = vv * (uu - uv) / (2 * det), t = uu * (vv - uv) / (2 * det);
    result = {a + s * u + t * v, s >= 0 && t >= 0 && s + t <= 1};
    return true;
}

// The circumcenter of a tetrahedron; false if the four points are coplanar.
HWY_INLINE bool ball_of_four(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                             Candidate& result) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const Vec3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
    const double det = dot(u, vw);
    if (det == 0) return false;
    const Vec3 center =
        (squared_norm(u) * vw + squared_norm(v) * wu + squared_norm(w) * uv) / (2 * det);
    const double s = dot(center, vw) / det, t = dot(center, wu) / det, q = dot(center, uv) / det;
    result = {a + center, s >= 0 && t >= 0 && q >= 0 && s + t + q <= 1};
    return true;
}

// The smallest ball of the first `count` points; the last point lies on its surface. `count`
// becomes the number of points that define the ball; these move to the front.
struct SupportSolver {
    Support& points;
    int& count;
    Vec3 center = Vec3::Zero();
    double squared_radius = std::numeric_limits<double>::infinity();
    unsigned chosen = 0;  // bit i: points[i] defines the ball
    bool optimal = false;

    // A candidate counts with the radius at which it contains all points, so a badly conditioned
    // one can only lose.
    void consider(const Candidate& candidate, unsigned members) {
        // Quotients may overflow if points are nearly collinear.
        optimal = false;
        if (!std::isfinite(candidate.center[0] + candidate.center[1] + candidate.center[2])) return;
        double reach = 0, own = 0;
        for (int i = 0; i < count; ++i) {
            const double d = squared_norm(points[static_cast<std::size_t>(i)] - candidate.center);
            reach = std::max(reach, d);
            if (members >> i & 1) own = std::max(own, d);
        }
        if (reach < squared_radius) {
            squared_radius = reach;
            center = candidate.center;
            chosen = members;
        }
        optimal = candidate.inside_hull && reach <= own * equal_squares;
    }

    void enumerate() {
        const int last = count - 1;
        const unsigned last_bit = 1u << last;
        const auto& p = points;
        const Vec3& q = p[static_cast<std::size_t>(last)];
        Candidate candidate;
        for (unsigned i = 0; static_cast<int>(i) < last; ++i) {
            consider(ball_of_two(q, p[i]), last_bit | 1u << i);
            if (optimal) return;
        }
        for (unsigned i = 0; static_cast<int>(i) < last; ++i)
            for (unsigned j = i + 1; static_cast<int>(j) < last; ++j) {
                if (!ball_of_three(q, p[i], p[j], candidate)) continue;
                consider(candidate, last_bit | 1u << i | 1u << j);
                if (optimal) return;
            }
        for (unsigned i = 0; static_cast<int>(i) < last; ++i)
            for (unsigned j = i + 1; static_cast<int>(j) < last; ++j)
                for (unsigned k = j + 1; static_cast<int>(k) < last; ++k) {
                    if (!ball_of_four(q, p[i], p[j], p[k], candidate)) continue;
                    consider(candidate, last_bit | 1u << i | 1u << j | 1u << k);
                    if (optimal) return;
                }
    }

    void keep_chosen() {
        int kept = 0;
        for (unsigned i = 0; static_cast<int>(i) < count; ++i)
            if (chosen >> i & 1) points[static_cast<std::size_t>(kept++)] = points[i];
        count = kept;
    }
};

/// The smallest ball that contains the points, see min_ball.h; at least one. `Points` has
/// `farthest_point(points, center)`. Adds the number of visited points to `visits`.
template <class Points>
HWY_INLINE Ball min_ball_of(const Points& points, std::size_t size, std::uint64_t& visits) {
    // Begins with a long diagonal: from the point farthest from the first point to its own farthest
    // point.
    Support support;
    int count = 2;
    support[0] = points[farthest_point(points, points[0]).index];
    support[1] = points[farthest_point(points, support[0]).index];
    Vec3 center = ball_of_two(support[0], support[1]).center;
    double squared_radius = squared_norm(support[0] - center);

    // Each pivot enlarges the smallest ball of the support, so no support returns. The bound is for
    // rounding errors only.
    Largest far = farthest_point(points, center);
    std::uint64_t passes = 3;
    for (int pivot = 0; pivot < 256 && far.value > squared_radius * equal_squares; ++pivot) {
        support[static_cast<std::size_t>(count++)] = points[far.index];
        SupportSolver solver{support, count};
        solver.enumerate();
        const Largest next = farthest_point(points, solver.center);
        ++passes;
        // Even if the gain in radius is lost in rounding, the new center may be better: with the
        // third corner of a nearly right-angled triangle.
        if (solver.squared_radius <= squared_radius && next.value >= far.value) break;
        solver.keep_chosen();
        center = solver.center;
        squared_radius = solver.squared_radius;
        far = next;
    }
    visits += passes * size;
    return {center, radius_reaching(far.value)};
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
