// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_TRIANGLE_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_TRIANGLE_KERNEL_INL_H_
#undef SCB_CORE_TRIANGLE_KERNEL_INL_H_
#else
#define SCB_CORE_TRIANGLE_KERNEL_INL_H_
#endif

#include "core/base/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

// Pairs of triangles P and Q in floats or doubles, decided if the signs of all determinants that
// matter are certain. Coordinates are differences from P's first corner, each off by at most
// `error` from the coordinates of the exact test; D is their largest magnitude. With 2^24 error >
// 24 D, or 2^53 for doubles, roundings of products are small compared with the effect of `error`,
// and 1/8 more covers them. Below `underflow`, products may have lost digits to the least exponent.
// Products do not overflow: tested leaves are near each other, so D is a few times the size of a
// mesh that passes check_packable.

/// n pairs: the corners of both, relative to P's first corner.
template <int n, class T = float>
struct TrianglePairs {
    Lanes3<n, T> p1, p2, q0, q1, q2;
    Lanes<n, T> error;
};

template <class T>
inline constexpr T kernel_underflow = std::is_same_v<T, float> ? T(0x1p-100) : T(0x1p-700);

/// D.
template <int n, class T>
HWY_INLINE Lanes<n, T> magnitude(const TrianglePairs<n, T>& t) {
    return max(max(max(largest(t.p1), largest(t.p2)), max(largest(t.q0), largest(t.q1))),
               largest(t.q2));
}

/// A bound of the error of determinants, `factor` D^2 error.
template <int n, class T>
HWY_INLINE Lanes<n, T> determinant_bound(const TrianglePairs<n, T>& t, float factor) {
    const Lanes<n, T> d = magnitude(t);
    return d * d * t.error * Lanes<n, T>::all(T{factor}) + Lanes<n, T>::all(kernel_underflow<T>);
}

/// Which of n triples of numbers are certainly all above the bound, or all below minus the bound.
template <int n, class T>
HWY_INLINE LaneMask<n, T> on_one_side(Lanes<n, T> x, Lanes<n, T> y, Lanes<n, T> z,
                                      Lanes<n, T> bound) {
    return (bound < min(min(x, y), z)) | (max(max(x, y), z) < -bound);
}

/// Heights of points above the plane of a triangle, times twice its area.
template <int n, class T = float>
struct Heights {
    Lanes<n, T> h[3];
};

/// Heights of the corners of Q above the plane of P. The normal's components are off by at most 4 D
/// error, a third of the sum by 2 D^2 error + D 4 D error, the sum by 18 D^2 error: with 1/8 more,
/// below 21.
template <int n, class T>
HWY_INLINE Heights<n, T> heights_of_q(const TrianglePairs<n, T>& t) {
    const Lanes3<n, T> normal = cross(t.p1, t.p2);
    return {{dot(normal, t.q0), dot(normal, t.q1), dot(normal, t.q2)}};
}
inline constexpr float q_height_bound = 21;

/// Heights of the corners of P above the plane of Q, whose edges are up to 2 D and off by 2 error.
/// The normal's components are up to 8 D^2, off by 8 D error; corners relative to q0 up to 2 D, off
/// by 2 error: 3 (8 D^2 2 error + 2 D 8 D error) = 96 D^2 error, with 1/8 more 108.
template <int n, class T>
HWY_INLINE Heights<n, T> heights_of_p(const TrianglePairs<n, T>& t) {
    const Lanes3<n, T> normal = cross(t.q1 - t.q0, t.q2 - t.q0);
    return {{dot(normal, -t.q0), dot(normal, t.p1 - t.q0), dot(normal, t.p2 - t.q0)}};
}
inline constexpr float p_height_bound = 108;

/// Lanes in which neither triangle is certainly on one side of the other's plane, by these bounds.
template <int n>
HWY_INLINE LaneMask<n> planes_meet(const TrianglePairs<n>& t, Lanes<n> q_bound, Lanes<n> p_bound) {
    const Heights<n> q = heights_of_q(t), p = heights_of_p(t);
    // NaN after an overflow makes comparisons false: not certain.
    return !(on_one_side(q.h[0], q.h[1], q.h[2], q_bound) |
             on_one_side(p.h[0], p.h[1], p.h[2], p_bound));
}
template <int n>
HWY_INLINE LaneMask<n> planes_meet(const TrianglePairs<n>& t) {
    const Lanes<n> q_bound = determinant_bound(t, q_height_bound);
    return planes_meet(t, q_bound, q_bound * Lanes<n>::all(p_height_bound / q_height_bound + 1));
}

/// The length of P's normal is off by at most 7 D error, the length of Q's by 14 D error, see
/// above.
inline constexpr float normal_bound = 16;

/// Lanes in which neither triangle is certainly on one side of the other's plane and farther away
/// than `skin`. Heights are times the normal's length, so `skin` is multiplied by it. Squares of it
/// may underflow.
template <int n>
HWY_INLINE LaneMask<n> planes_near(const TrianglePairs<n>& t, Lanes<n> skin) {
    const Lanes<n> off =
        magnitude(t) * t.error * Lanes<n>::all(normal_bound) + Lanes<n>::all(0x1p-70f);
    const auto length = [&](Lanes3<n> normal) HWY_ATTR {
        return sqrt(dot(normal, normal)) * Lanes<n>::all(1 + 0x1p-16f) + off;
    };
    const Lanes<n> q_bound = determinant_bound(t, q_height_bound);
    return planes_meet(t, q_bound + skin * length(cross(t.p1, t.p2)),
                       q_bound * Lanes<n>::all(p_height_bound / q_height_bound + 1) +
                           skin * length(cross(t.q1 - t.q0, t.q2 - t.q0)));
}

/// Lanes in which the triangles certainly have a point in common, and lanes that are not certain.
template <int n, class T = float>
struct Certainty {
    LaneMask<n, T> intersect, open;
};

/// The sides on which the lines of P's edge i, from corner i to the next, and Q's edge j pass each
/// other, times lengths.
template <int n, class T = float>
struct EdgeSides {
    Lanes<n, T> of[3][3];
};

/// The Plucker products of edges: an edge (up to 2 D, off by 2 error) times the moment of another
/// (up to 4 D^2, off by 8 D error), twice: 2 * 3 (2 D 8 D error + 4 D^2 2 error) = 144 D^2 error,
/// with 1/8 more 162.
template <int n, class T>
HWY_INLINE EdgeSides<n, T> edge_sides(const TrianglePairs<n, T>& t) {
    const Lanes3<n, T> edge_p[3] = {t.p1, t.p2 - t.p1, -t.p2};
    const Lanes3<n, T> edge_q[3] = {t.q1 - t.q0, t.q2 - t.q1, t.q0 - t.q2};
    // The first corner of P is the origin: two of its edges have no moment.
    const Lanes3<n, T> moment_p = cross(t.p1, edge_p[1]);
    const Lanes3<n, T> moment_q[3] = {cross(t.q0, edge_q[0]), cross(t.q1, edge_q[1]),
                                      cross(t.q2, edge_q[2])};
    const auto product = [&](int i, int j) HWY_ATTR {
        const Lanes<n, T> of_p = dot(edge_p[i], moment_q[j]);
        return i == 1 ? of_p + dot(edge_q[j], moment_p) : of_p;
    };
    return {{{product(0, 0), product(0, 1), product(0, 2)},
             {product(1, 0), product(1, 1), product(1, 2)},
             {product(2, 0), product(2, 1), product(2, 2)}}};
}
inline constexpr float edge_bound = 162;

/// Two triangles in planes that cross intersect if an edge of one passes through the other: its
/// ends are on two sides of the plane, and the other's three edges pass it on the same side.
template <int n, class T>
HWY_INLINE Certainty<n, T> intersection(const TrianglePairs<n, T>& t) {
    const Lanes<n, T> bound = determinant_bound(t, edge_bound);
    const Heights<n, T> q = heights_of_q(t), p = heights_of_p(t);
    const EdgeSides<n, T> sides = edge_sides(t);
    const auto& side = sides.of;

    const LaneMask<n, T> none = t.error < t.error;
    Certainty<n, T> result{none, none};
    const auto pass = [&](Lanes<n, T> from, Lanes<n, T> to, Lanes<n, T> x, Lanes<n, T> y,
                          Lanes<n, T> z) HWY_ATTR {
        const LaneMask<n, T> sure = (bound < abs(from)) & (bound < abs(to));
        const Lanes<n, T> zero = Lanes<n, T>::all(0);
        const LaneMask<n, T> crosses = sure & ((from < zero) ^ (to < zero));
        const LaneMask<n, T> stays = sure ^ crosses;
        const LaneMask<n, T> through = crosses & on_one_side(x, y, z, bound);
        const LaneMask<n, T> beside = (min(min(x, y), z) < -bound) & (bound < max(max(x, y), z));
        result.intersect = result.intersect | through;
        result.open = result.open | !(stays | through | beside);
    };
    for (int i = 0; i < 3; ++i) pass(p.h[i], p.h[(i + 1) % 3], side[i][0], side[i][1], side[i][2]);
    for (int j = 0; j < 3; ++j) pass(q.h[j], q.h[(j + 1) % 3], side[0][j], side[1][j], side[2][j]);
    return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
