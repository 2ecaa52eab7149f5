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
// matter are certain.
//
// Notation: coordinates are differences from P's first corner, each off by at most e from the
// coordinates of the exact test. u is half a unit in the last place, 2^-24 or 2^-53. D is their
// largest magnitude, plus e: all corners, as computed and as they are, lie in a cube of side 2 D
// around the origin.
//
// Errors of the data: every determinant here is det(b - a, c - a, d - a) of four corners. Its
// derivative by a coordinate of one corner is twice the area of the triangle of the other three,
// projected along that axis. That is at most 4 D^2, since a triangle in a square has at most half
// of its area, and at most 2 D^2 if one of the three is the origin. By the mean value theorem the
// determinant is off by at most e times the sum over 12 coordinates, 48 D^2 e. For heights above P
// the sum has 9 coordinates and the factor 2 D^2: 18 D^2 e.
//
// Errors of rounding are a multiple of u D^3, derived at each function. Their terms in u^2 and the
// roundings of the bound itself are below 2^-16 of it; each constant is larger by 2 % or more.
//
// Below `underflow`, products may have lost digits to the least exponent. Products do not overflow:
// tested leaves are near each other, so D is a few times the size of a mesh that passes
// check_packable.

/// n pairs: the corners of both, relative to P's first corner.
template <int n, class T = float>
struct TrianglePairs {
    Lanes3<n, T> p1, p2, q0, q1, q2;
    Lanes<n, T> error;
};

template <class T>
inline constexpr T kernel_underflow = std::is_same_v<T, float> ? T(0x1p-100) : T(0x1p-700);

template <class T>
inline constexpr T rounding_unit = std::is_same_v<T, float> ? T(0x1p-24) : T(0x1p-53);

/// D, see above.
template <int n, class T>
HWY_INLINE Lanes<n, T> magnitude(const TrianglePairs<n, T>& t) {
    return max(max(max(largest(t.p1), largest(t.p2)), max(largest(t.q0), largest(t.q1))),
               largest(t.q2)) +
           t.error;
}

/// The two parts of an error bound: multiples of D^2 e and of u D^3 for determinants.
struct ErrorFactors {
    float data, rounding;
};

/// The error bound of determinants; `d` is D.
template <int n, class T>
HWY_INLINE Lanes<n, T> determinant_bound(const TrianglePairs<n, T>& t, Lanes<n, T> d,
                                         ErrorFactors factors) {
    return d * d *
               (Lanes<n, T>::all(T{factors.data}) * t.error +
                Lanes<n, T>::all(T{factors.rounding} * rounding_unit<T>) * d) +
           Lanes<n, T>::all(kernel_underflow<T>);
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

/// Heights of the corners of Q above the plane of P. Rounding: six terms of at most D^3, each with
/// three roundings of products and differences and two of sums: 30 u D^3.
template <int n, class T>
HWY_INLINE Heights<n, T> heights_of_q(const TrianglePairs<n, T>& t) {
    const Lanes3<n, T> normal = cross(t.p1, t.p2);
    return {{dot(normal, t.q0), dot(normal, t.q1), dot(normal, t.q2)}};
}
inline constexpr ErrorFactors q_height_bound = {19, 31};

/// Heights of the corners of P above the plane of Q. Rounding: each of nine differences of corners
/// is off by 2 u D, and has a derivative of at most 4 D^2: 72 u D^3. A component of the normal, at
/// most 4 D^2, is off by three roundings of 4 u D^2, and is multiplied by at most 2 D: 72 u D^3 for
/// three. Their products, at most 8 D^3, are rounded: 24 u D^3; the sums, at most 16 D^3 (a
/// tetrahedron in a cube has at most a third of its volume): 32 u D^3. Together 200 u D^3.
template <int n, class T>
HWY_INLINE Heights<n, T> heights_of_p(const TrianglePairs<n, T>& t) {
    const Lanes3<n, T> normal = cross(t.q1 - t.q0, t.q2 - t.q0);
    return {{dot(normal, -t.q0), dot(normal, t.p1 - t.q0), dot(normal, t.p2 - t.q0)}};
}
inline constexpr ErrorFactors p_height_bound = {49, 205};

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
    const Lanes<n> d = magnitude(t);
    return planes_meet(t, determinant_bound(t, d, q_height_bound),
                       determinant_bound(t, d, p_height_bound));
}

/// For the lengths of normals, multiples of D e and of u D^2. A component of Q's normal is twice
/// the area of a projected triangle: its derivative by one of six coordinates is at most 2 D, so it
/// is off by 12 D e. Rounding: four differences, each off by 2 u D, with the factor 2 D: 16 u D^2;
/// two products and their difference, each at most 4 D^2: 12 u D^2. The length has the factor
/// sqrt(3). The errors of P's normal are smaller.
inline constexpr ErrorFactors normal_bound = {22, 50};

/// Lanes in which neither triangle is certainly on one side of the other's plane and farther away
/// than `skin`. Heights are times the normal's length, so `skin` is multiplied by it. Squares of it
/// may underflow.
template <int n>
HWY_INLINE LaneMask<n> planes_near(const TrianglePairs<n>& t, Lanes<n> skin) {
    const Lanes<n> d = magnitude(t);
    const Lanes<n> off = d * (Lanes<n>::all(normal_bound.data) * t.error +
                              Lanes<n>::all(normal_bound.rounding * rounding_unit<float>) * d) +
                         Lanes<n>::all(0x1p-70f);
    const auto length = [&](Lanes3<n> normal) HWY_ATTR {
        return sqrt(dot(normal, normal)) * Lanes<n>::all(1 + 0x1p-16f) + off;
    };
    return planes_meet(
        t, determinant_bound(t, d, q_height_bound) + skin * length(cross(t.p1, t.p2)),
        determinant_bound(t, d, p_height_bound) + skin * length(cross(t.q1 - t.q0, t.q2 - t.q0)));
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

/// The Plucker products of edges: an edge times the moment of the other, twice; the determinant of
/// their four ends. Rounding: the moment of a rounded edge is off by three roundings of 2 u D^2,
/// its product with an edge by 3 (2 D 6 u D^2) = 36 u D^3, by 12 u D^3 for the products of
/// components, and by 20 u D^3 for sums, 68 u D^3; twice, and 16 u D^3 for the last sum. The
/// roundings of the edges, 2 u D for each component, change a product by 3 (2 u D 2 D^2) = 12 u D^3
/// and, by the moment, 3 (2 D 4 u D^2) = 24 u D^3; twice, 72 u D^3. Together 224 u D^3.
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
inline constexpr ErrorFactors edge_bound = {49, 229};

/// Two triangles in planes that cross intersect if an edge of one passes through the other: its
/// ends are on two sides of the plane, and the other's three edges pass it on the same side.
template <int n, class T>
HWY_INLINE Certainty<n, T> intersection(const TrianglePairs<n, T>& t) {
    const Lanes<n, T> bound = determinant_bound(t, magnitude(t), edge_bound);
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
