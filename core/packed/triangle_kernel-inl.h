// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_TRIANGLE_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_TRIANGLE_KERNEL_INL_H_
#undef SCB_CORE_TRIANGLE_KERNEL_INL_H_
#else
#define SCB_CORE_TRIANGLE_KERNEL_INL_H_
#endif

#include <array>

#include "core/base/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

// Pairs of triangles P and Q in floats, decided if the signs of all determinants that matter are
// certain. A triangle is its first corner and the two edges from there, so that a small triangle
// beside a large one keeps its own precision.
//
// Notation: p1 and p2 are the edges of P from its first corner, f1 and f2 the edges of Q, and w is
// the offset from the first corner of P to the first corner of Q. Each coordinate of an edge of P
// is off by at most e_p from the coordinates of the exact test, of an edge of Q by e_f, and of w by
// e_w. The largest magnitudes, plus these errors, are D_p, D_f and D_w. u is 2^-24, half a unit in
// the last place.
//
// A product of two numbers of magnitudes A and B is off by A b + B a, if these are off by a and b.
// This has no term of second order, since A and B bound both the computed and the exact numbers. A
// cross product of p1 and p2 has components of two products:
//   magnitude 2 D_p^2, error 4 D_p e_p + 4 u D_p^2 (three roundings of D_p^2, D_p^2 and 2 D_p^2).
// A dot product of such a component with a vector of magnitude D and error e has three products:
//   magnitude 6 D_p^2 D, error 3 (2 D_p^2 e + D (4 D_p e_p + 4 u D_p^2)) + 16 u D_p^2 D
//   = 6 D_p^2 e + 12 D_p D e_p + 28 u D_p^2 D,
// with 16 for the roundings of three products (2 each) and two sums (4 and 6). Terms in u^2 and the
// roundings of the bounds themselves are below 2^-16 of these; each constant is larger by 2 % or
// more.
//
// `kernel_underflow` bounds the error of products that lose digits to the least exponent. Products
// overflow only if the bodies are farther apart than some 1e12 times their largest size: leaves
// that are tested are near each other, unless both roots are leaves. Then all heights above a plane
// are infinite or not numbers at once, and no crossing is certain. The triangles are apart.

/// n pairs: edges and the offset, and the errors of their coordinates, e_p, e_f and e_w.
template <int n>
struct TrianglePairs {
    Lanes3<n> p1, p2, f1, f2, w;
    Lanes<n> error_p, error_f, error_w;
};

inline constexpr float rounding_unit = 0x1p-24f, kernel_underflow = 0x1p-100f;

/// D_p, D_f and D_w.
template <int n>
struct Magnitudes {
    Lanes<n> p, f, w;

    explicit HWY_INLINE Magnitudes(const TrianglePairs<n>& t)
        : p(max(largest(t.p1), largest(t.p2)) + t.error_p),
          f(max(largest(t.f1), largest(t.f2)) + t.error_f),
          w(largest(t.w) + t.error_w) {}
};

/// Which of n triples of numbers are certainly all above the bound, or all below minus the bound.
template <int n>
HWY_INLINE LaneMask<n> on_one_side(Lanes<n> x, Lanes<n> y, Lanes<n> z, Lanes<n> bound) {
    return (bound < min(min(x, y), z)) | (max(max(x, y), z) < -bound);
}

/// Heights of the corners of each triangle above the plane of the other, times twice the area of
/// the latter, and what edge_sides needs of them.
template <int n>
struct Heights {
    Lanes3<n> normal_p, normal_q;
    Lanes<n> along_p1, along_p2;  ///< p1 and p2 times normal_q
    Lanes<n> along_f1, along_f2;  ///< f1 and f2 times normal_p
    Lanes<n> of_q[3], of_p[3];

    explicit HWY_INLINE Heights(const TrianglePairs<n>& t)
        : Heights(t, cross(t.p1, t.p2), cross(t.f1, t.f2)) {}

  private:
    HWY_INLINE Heights(const TrianglePairs<n>& t, Lanes3<n> p, Lanes3<n> q)
        : Heights(p, q, dot(q, t.p1), dot(q, t.p2), dot(p, t.f1), dot(p, t.f2), dot(p, t.w),
                  -dot(q, t.w)) {}
    HWY_INLINE Heights(Lanes3<n> p, Lanes3<n> q, Lanes<n> p1, Lanes<n> p2, Lanes<n> f1, Lanes<n> f2,
                       Lanes<n> first_of_q, Lanes<n> first_of_p)
        : normal_p(p),
          normal_q(q),
          along_p1(p1),
          along_p2(p2),
          along_f1(f1),
          along_f2(f2),
          of_q{first_of_q, first_of_q + f1, first_of_q + f2},
          of_p{first_of_p, first_of_p + p1, first_of_p + p2} {}
};

/// A height above P is the sum of two dot products with its normal, of w and of an edge of Q. With
/// R = D_w + D_f and e = e_w + e_f it is off by 6 D_p^2 e + 12 D_p R e_p + 28 u D_p^2 R, and by
/// 6 u D_p^2 R for the rounding of the sum.
/// The factors of e_p, of e and of u:
inline constexpr float height_own = 12.3f, height_other = 6.2f, height_rounding = 35;

/// The error of heights above a triangle of magnitude `d`, whose edges are off by `own`. `reach`:
/// R; `other`: e.
template <int n>
HWY_INLINE Lanes<n> error_of_height(Lanes<n> d, Lanes<n> own, Lanes<n> reach, Lanes<n> other) {
    return d * (d * (Lanes<n>::all(height_other) * other +
                     Lanes<n>::all(height_rounding * rounding_unit) * reach) +
                Lanes<n>::all(height_own) * reach * own) +
           Lanes<n>::all(kernel_underflow);
}

/// The errors of Heights::of_q and Heights::of_p.
template <int n>
struct HeightErrors {
    Lanes<n> of_q, of_p;

    HWY_INLINE HeightErrors(const TrianglePairs<n>& t, const Magnitudes<n>& d)
        : of_q(error_of_height(d.p, t.error_p, d.w + d.f, t.error_w + t.error_f)),
          of_p(error_of_height(d.f, t.error_f, d.w + d.p, t.error_w + t.error_p)) {}
};

/// Lanes in which neither triangle is certainly on one side of the other's plane, by these bounds.
template <int n>
HWY_INLINE LaneMask<n> planes_meet(const Heights<n>& h, Lanes<n> q_bound, Lanes<n> p_bound) {
    return !(on_one_side(h.of_q[0], h.of_q[1], h.of_q[2], q_bound) |
             on_one_side(h.of_p[0], h.of_p[1], h.of_p[2], p_bound));
}
template <int n>
HWY_INLINE LaneMask<n> planes_meet(const TrianglePairs<n>& t) {
    const HeightErrors<n> errors(t, Magnitudes<n>(t));
    return planes_meet(Heights<n>(t), errors.of_q, errors.of_p);
}

/// The length of a normal is off by sqrt(3) times the error of its components, 4 D e + 4 u D^2:
/// less than 7 D e + 7 u D^2.
inline constexpr float normal_bound = 7.1f;

/// Lanes in which neither triangle is certainly on one side of the other's plane and farther away
/// than `skin`. Heights are times the normal's length, so `skin` is multiplied by it. Squares of it
/// may underflow.
template <int n>
HWY_INLINE LaneMask<n> planes_near(const TrianglePairs<n>& t, Lanes<n> skin) {
    const Magnitudes<n> d(t);
    const HeightErrors<n> errors(t, d);
    const Heights<n> heights(t);
    const auto length = [&](Lanes3<n> normal, Lanes<n> size, Lanes<n> error) HWY_ATTR {
        const Lanes<n> off =
            Lanes<n>::all(normal_bound) * size * (error + Lanes<n>::all(rounding_unit) * size) +
            Lanes<n>::all(0x1p-70f);
        return sqrt(dot(normal, normal)) * Lanes<n>::all(1 + 0x1p-16f) + off;
    };
    return planes_meet(heights, errors.of_q + skin * length(heights.normal_p, d.p, t.error_p),
                       errors.of_p + skin * length(heights.normal_q, d.f, t.error_f));
}

/// Lanes in which the triangles certainly have a point in common, and lanes that are not certain.
template <int n>
struct Certainty {
    LaneMask<n> intersect, open;
};

/// The sides on which the lines of P's edge i, from corner i to the next, and Q's edge j pass each
/// other, times lengths.
template <int n>
struct EdgeSides {
    Lanes<n> of[3][3];
};

/// The Plucker products of edges, as sums of triple products: with m1 = w x f1 and m2 = w x f2, the
/// moments of Q's edges about P's first corner are m1, m2 - m1 + normal_q and -m2. The moment of
/// P's middle edge is normal_p, of the others 0.
template <int n>
HWY_INLINE EdgeSides<n> edge_sides(const TrianglePairs<n>& t, const Heights<n>& h) {
    const Lanes3<n> m1 = cross(t.w, t.f1), m2 = cross(t.w, t.f2);
    const auto row = [&](Lanes3<n> p, Lanes<n> along) HWY_ATTR {
        const Lanes<n> first = dot(p, m1), last = dot(p, m2);
        return std::array<Lanes<n>, 3>{first, (last - first) + along, -last};
    };
    const std::array<Lanes<n>, 3> first = row(t.p1, h.along_p1), last = row(t.p2, h.along_p2);
    return {{{first[0], first[1], first[2]},
             {(last[0] - first[0]) + h.along_f1, (last[1] - first[1]) + (h.along_f2 - h.along_f1),
              (last[2] - first[2]) - h.along_f2},
             {-last[0], -last[1], -last[2]}}};
}

/// The error of edge_sides. With X = D_p D_f D_w, Y = D_p D_f^2 and Z = D_p^2 D_f, a triple product
/// of an edge of P and m1 or m2 is off by
///   6 (D_w D_f e_p + D_p D_w e_f + D_p D_f e_w) + 28 u X,
/// one with normal_q by 6 D_f^2 e_p + 12 D_p D_f e_f + 28 u Y, and one with normal_p by
/// 6 D_p^2 e_f + 12 D_p D_f e_p + 28 u Z. The side of the two middle edges, the longest sum, has 4,
/// 2 and 2 of these. The sums have magnitudes of at most 24 X, 12 Y and 12 Z, and are rounded by 96
/// X, 36 Y and 24 Z in all. With W = D_w + D_p + D_f, all this is at most
///   24 (W (D_f e_p + D_p e_f) + D_p D_f e_w) + 208 u W D_p D_f.
/// The factors of the errors of edges, of e_w and of u:
inline constexpr float side_edges = 24.6f, side_offset = 24.6f, side_rounding = 213;

template <int n>
HWY_INLINE Lanes<n> error_of_sides(const TrianglePairs<n>& t, const Magnitudes<n>& d) {
    const Lanes<n> all = d.w + d.p + d.f, area = d.p * d.f;
    return Lanes<n>::all(side_edges) * all * (d.f * t.error_p + d.p * t.error_f) +
           area * (Lanes<n>::all(side_offset) * t.error_w +
                   Lanes<n>::all(side_rounding * rounding_unit) * all) +
           Lanes<n>::all(kernel_underflow);
}

/// Two triangles in planes that cross intersect if an edge of one passes through the other: its
/// ends are on two sides of the plane, and the other's three edges pass it on the same side.
template <int n>
HWY_INLINE Certainty<n> intersection(const TrianglePairs<n>& t) {
    const Magnitudes<n> d(t);
    const HeightErrors<n> errors(t, d);
    const Lanes<n> bound = error_of_sides(t, d);
    const Heights<n> h(t);
    const EdgeSides<n> sides = edge_sides(t, h);
    const auto& side = sides.of;

    const LaneMask<n> none = bound < bound;
    Certainty<n> result{none, none};
    const auto pass = [&](Lanes<n> from, Lanes<n> to, Lanes<n> error, Lanes<n> x, Lanes<n> y,
                          Lanes<n> z) HWY_ATTR {
        const LaneMask<n> sure = (error < abs(from)) & (error < abs(to));
        const Lanes<n> zero = Lanes<n>::all(0);
        const LaneMask<n> crosses = sure & ((from < zero) ^ (to < zero));
        const LaneMask<n> stays = sure ^ crosses;
        const LaneMask<n> through = crosses & on_one_side(x, y, z, bound);
        const LaneMask<n> beside = (min(min(x, y), z) < -bound) & (bound < max(max(x, y), z));
        result.intersect = result.intersect | through;
        result.open = result.open | !(stays | through | beside);
    };
    for (int i = 0; i < 3; ++i)
        pass(h.of_p[i], h.of_p[(i + 1) % 3], errors.of_p, side[i][0], side[i][1], side[i][2]);
    for (int j = 0; j < 3; ++j)
        pass(h.of_q[j], h.of_q[(j + 1) % 3], errors.of_q, side[0][j], side[1][j], side[2][j]);
    return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
