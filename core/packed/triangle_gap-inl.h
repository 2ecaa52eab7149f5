// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_TRIANGLE_GAP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_TRIANGLE_GAP_INL_H_
#undef SCB_CORE_TRIANGLE_GAP_INL_H_
#else
#define SCB_CORE_TRIANGLE_GAP_INL_H_
#endif

#include <cmath>

#include "core/packed/triangle_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

// The distance of two triangles in floats, between two bounds. Two points of the triangles that
// are nearly the closest give both: their distance is an upper bound, and the gap along the vector
// between them is a lower bound. Both are valid for any two points, so how these are found needs
// no proof: where they are bad, the bounds are merely far apart.
//
// Errors, in the notation of triangle_kernel-inl.h. Along a vector v, an edge or the offset is off
// by |v| sqrt(3) e for its coordinates, and by |v| 3 sqrt(3) u D for the dot product; sums and the
// division by |v| add less than 6 sqrt(3) u D. The point s p1 + t p2, as computed, is off from one
// of the triangle by less than sqrt(3) (e_p + 6 u D_p): s, t and 1 - s - t are at least -2 u. The
// difference of the points, its length and the rest are below 6 sqrt(3) u D. With 12 for 9 or
// less, each bound is off by at most
//   sqrt(3) (e_p + e_f + e_w) + 12 sqrt(3) u (D_p + D_f + D_w).
// D_p + D_f + D_w is at most 3 times the length of the Offset of the leaves, and e_w at least 6.2 u
// times it, see `offset_error`. So the second term is at most 10.1 e_w.
inline constexpr float gap_edges = 1.8f, gap_offset = 12.2f;
/// Products of shorter vectors may lose digits to the least exponent of floats: these count as
/// vectors without a direction, and others as off by this. Squares of longer ones may overflow.
inline constexpr float shortest_gap = 0x1p-50f, longest_gap = 0x1p60f, gap_underflow = 0x1p-90f;

/// The shortest of some vectors.
template <int n>
struct ShortestVector {
    Lanes3<n> v;
    Lanes<n> squared;

    HWY_INLINE void take(const Lanes3<n>& other, Lanes<n> other_squared) {
        const LaneMask<n> shorter = other_squared < squared;
        v = {select(shorter, other.x, v.x), select(shorter, other.y, v.y),
             select(shorter, other.z, v.z)};
        squared = select(shorter, other_squared, squared);  // min may choose what is no number
    }
};

template <int n>
HWY_INLINE Lanes3<n> scaled(Lanes<n> share, const Lanes3<n>& v) {
    return {share * v.x, share * v.y, share * v.z};
}
template <int n>
HWY_INLINE Lanes<n> share_of_one(Lanes<n> x) {
    return min(max(x, Lanes<n>::all(0)), Lanes<n>::all(1));
}

/// An edge: its first end, the vector to the other, and 1 over the squared length.
template <int n>
struct LaneEdge {
    Lanes3<n> from, along;
    Lanes<n> squared, inverse;

    HWY_INLINE LaneEdge(const Lanes3<n>& first, const Lanes3<n>& vector)
        : from(first),
          along(vector),
          squared(dot(vector, vector)),
          inverse(Lanes<n>::all(1) / max(squared, Lanes<n>::all(0x1p-120f))) {}
};

/// A triangle for its distances from points: two edges from one corner, and 1 over the determinant
/// of their products.
template <int n>
struct LaneFace {
    const LaneEdge<n>&u, &v;
    Lanes<n> uv, inverse;

    HWY_INLINE LaneFace(const LaneEdge<n>& first, const LaneEdge<n>& second)
        : u(first),
          v(second),
          uv(dot(u.along, v.along)),
          inverse(Lanes<n>::all(1) /
                  max(u.squared * v.squared - uv * uv, Lanes<n>::all(0x1p-120f))) {}

    /// To a point, from the point of the face below it, if there is one. `sign`: 1, or -1 for the
    /// reverse.
    HWY_INLINE void take(const Lanes3<n>& point, float sign, ShortestVector<n>& shortest) const {
        const Lanes3<n> rest = point - u.from;
        const Lanes<n> along_u = dot(rest, u.along), along_v = dot(rest, v.along),
                       zero = Lanes<n>::all(0);
        const Lanes<n> s = (v.squared * along_u - uv * along_v) * inverse,
                       t = (u.squared * along_v - uv * along_u) * inverse;
        const Lanes3<n> way = rest - (scaled(s, u.along) + scaled(t, v.along));
        const LaneMask<n> inside = (zero <= s) & (zero <= t) & (s + t <= Lanes<n>::all(1));
        shortest.take(scaled(Lanes<n>::all(sign), way),
                      select(inside, dot(way, way), Lanes<n>::all(HUGE_VALF)));
    }
};

/// From the point of edge a to the point of edge b that are closest; from one of them if rounding
/// matters.
template <int n>
HWY_INLINE void take(const LaneEdge<n>& a, const LaneEdge<n>& b, ShortestVector<n>& shortest) {
    const Lanes3<n> between = b.from - a.from;
    const Lanes<n> ab = dot(a.along, b.along), on_a = dot(a.along, between),
                   on_b = dot(b.along, between);
    const Lanes<n> determinant = max(a.squared * b.squared - ab * ab, Lanes<n>::all(0x1p-120f));
    const Lanes<n> first = share_of_one((on_a * b.squared - ab * on_b) / determinant);
    const Lanes<n> of_b = share_of_one((ab * first - on_b) * b.inverse);
    const Lanes<n> of_a = share_of_one((ab * of_b + on_a) * a.inverse);
    const Lanes3<n> way = (between + scaled(of_b, b.along)) - scaled(of_a, a.along);
    shortest.take(way, dot(way, way));
}

/// The vector from P to Q between points that are nearly the closest. Without loops, which
/// compilers would run on copies of the edges in memory.
template <int n>
HWY_INLINE ShortestVector<n> shortest_vector(const TrianglePairs<n>& t) {
    const Lanes<n> zero = Lanes<n>::all(0);
    const Lanes3<n> origin = {zero, zero, zero}, q1 = t.w + t.f1, q2 = t.w + t.f2;
    const LaneEdge<n> p_first(origin, t.p1), p_second(origin, t.p2), p_third(t.p1, t.p2 - t.p1),
        q_first(t.w, t.f1), q_second(t.w, t.f2), q_third(q1, t.f2 - t.f1);
    ShortestVector<n> shortest{t.w, dot(t.w, t.w)};
    take(p_first, q_first, shortest);
    take(p_first, q_second, shortest);
    take(p_first, q_third, shortest);
    take(p_second, q_first, shortest);
    take(p_second, q_second, shortest);
    take(p_second, q_third, shortest);
    take(p_third, q_first, shortest);
    take(p_third, q_second, shortest);
    take(p_third, q_third, shortest);
    const LaneFace<n> of_p(p_first, p_second), of_q(q_first, q_second);
    of_p.take(t.w, 1, shortest);
    of_p.take(q1, 1, shortest);
    of_p.take(q2, 1, shortest);
    of_q.take(origin, -1, shortest);
    of_q.take(t.p1, -1, shortest);
    of_q.take(t.p2, -1, shortest);
    return shortest;
}

/// How far Q begins behind the end of P along v, times the length of v.
template <int n>
HWY_INLINE Lanes<n> gap_along(const TrianglePairs<n>& t, const Lanes3<n>& v) {
    const Lanes<n> zero = Lanes<n>::all(0);
    return dot(v, t.w) + min(zero, min(dot(v, t.f1), dot(v, t.f2))) -
           max(zero, max(dot(v, t.p1), dot(v, t.p2)));
}

/// Whether a vector of this length has a direction, see shortest_gap.
template <int n>
HWY_INLINE LaneMask<n> has_direction(Lanes<n> length) {
    return (Lanes<n>::all(shortest_gap) < length) & (length < Lanes<n>::all(longest_gap));
}

/// The error of both bounds.
template <int n>
HWY_INLINE Lanes<n> gap_error(const TrianglePairs<n>& t) {
    return Lanes<n>::all(gap_edges) * (t.error_p + t.error_f) +
           Lanes<n>::all(gap_offset) * t.error_w + Lanes<n>::all(gap_underflow);
}

/// Bounds of the distance of n pairs, and the vector that gave them; `least` may be below 0.
template <int n>
struct TriangleGap {
    Lanes<n> least, most;
    Lanes3<n> v;

    explicit HWY_INLINE TriangleGap(const TrianglePairs<n>& t)
        : TriangleGap(t, shortest_vector(t), gap_error(t)) {}

  private:
    HWY_INLINE TriangleGap(const TrianglePairs<n>& t, const ShortestVector<n>& shortest,
                           Lanes<n> error)
        : least(-error), most(sqrt(shortest.squared) + error), v(shortest.v) {
        const Lanes<n> length = sqrt(shortest.squared);
        least = select(has_direction(length), gap_along(t, v) / length - error, least);
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
