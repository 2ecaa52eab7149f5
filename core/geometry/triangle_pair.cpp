#include "core/geometry/triangle_pair.h"

#include <algorithm>

#include "core/geometry/orientation.h"

namespace scb {
namespace {

bool all_zero(const Sides& s) { return s[0] == 0 && s[1] == 0 && s[2] == 0; }

void complete(Sides& sides, const TriangleCorners& plane, const TriangleCorners& corners) {
    for (std::size_t i = 0; i < 3; ++i)
        if (sides[i] == 0) sides[i] = orient3d_exact(plane[0], plane[1], plane[2], corners[i]);
}

constexpr std::size_t code(int s0, int s1, int s2) {
    return static_cast<std::size_t>(9 * s0 + 3 * s1 + s2 + 13);
}

// Let i be the point on the edge from the apex v to w1, and j the point on the edge to w2, with v,
// w1, w2 in cyclic order. Then j - i = -(positive) side n x n', where n is the triangle's normal
// and n' the normal of the other plane: write i = v + t1 e1 and j = v + t2 e2, with t1 e1 . n' = t2
// e2 . n' = h, and expand (e1 x e2) x n' = e2 (e1 . n') - e1 (e2 . n') = h (j - i) / (t1 t2); h has
// the sign of -side.
constexpr std::array<LinePoints, 27> line_points(int swapped_side) {
    std::array<LinePoints, 27> table{};
    for (int s0 = -1; s0 <= 1; ++s0)
        for (int s1 = -1; s1 <= 1; ++s1)
            for (int s2 = -1; s2 <= 1; ++s2) {
                const std::array<int, 3> s{s0, s1, s2};
                // With one corner on each side and one in the plane, the apex may be either of the
                // first two, but not the third: its edges would not be on one side.
                const std::uint8_t apex = s0 == s1   ? std::uint8_t{2}
                                          : s0 == s2 ? std::uint8_t{1}
                                          : s1 == s2 ? std::uint8_t{0}
                                          : s0 == 1  ? std::uint8_t{0}
                                          : s1 == 1  ? std::uint8_t{1}
                                                     : std::uint8_t{2};
                const auto w1 = static_cast<std::uint8_t>((apex + 1) % 3),
                           w2 = static_cast<std::uint8_t>((apex + 2) % 3);
                const int side = s[apex] != 0 ? s[apex] : -s[w1];
                table[code(s0, s1, s2)] = {apex, side == swapped_side ? w2 : w1,
                                           side == swapped_side ? w1 : w2,
                                           static_cast<std::int8_t>(side)};
            }
    return table;
}

// Seen from b, n_b x n_a is -L.
constexpr std::array<LinePoints, 27> points_of_a = line_points(1);
constexpr std::array<LinePoints, 27> points_of_b = line_points(-1);

}  // namespace

Arrangement arrange(const TriangleCorners& a, const TriangleCorners& b, PairSides& sides) {
    complete(sides.of_b, a, b);
    if (strictly_on_one_side(sides.of_b)) return Arrangement::apart;
    const bool b_in_plane = all_zero(sides.of_b);
    // All corners are in the plane of a; of_a, three exact sums, would have the same result.
    if (b_in_plane && !is_degenerate(a)) return Arrangement::one_plane;
    complete(sides.of_a, b, a);
    if (strictly_on_one_side(sides.of_a)) return Arrangement::apart;
    const bool a_in_plane = all_zero(sides.of_a);
    if (!a_in_plane) return b_in_plane ? Arrangement::segment_a : Arrangement::crossing;
    if (!b_in_plane) return Arrangement::segment_b;
    // In one plane, unless they are two skew segments.
    const std::array<Vec3, 2> end_a = ends(a), end_b = ends(b);
    return orient3d(end_a[0], end_a[1], end_b[0], end_b[1]) == 0 ? Arrangement::one_plane
                                                                 : Arrangement::apart;
}

bool is_degenerate(const TriangleCorners& t) {
    for (int axis = 0; axis < 3; ++axis)
        if (orient2d(t[0], t[1], t[2], axis) != 0) return false;
    return true;
}

std::array<Vec3, 2> ends(const TriangleCorners& t) {
    const auto [first, last] = std::minmax_element(t.begin(), t.end(), precedes);
    return {*first, *last};
}

bool segment_meets_triangle(const Vec3& p, const Vec3& q, const TriangleCorners& t) {
    const int s0 = orient3d(p, q, t[0], t[1]), s1 = orient3d(p, q, t[1], t[2]);
    if (s0 * s1 < 0) return false;
    const int s2 = orient3d(p, q, t[2], t[0]);
    return s0 * s2 >= 0 && s1 * s2 >= 0;
}

LinePoints line_points_of_a(const Sides& s) { return points_of_a[code(s[0], s[1], s[2])]; }

LinePoints line_points_of_b(const Sides& s) { return points_of_b[code(s[0], s[1], s[2])]; }

// With x = v + t e on a, y = v' + t' e' on b and y - x = m L: det(e, v' - v, v' + e' - v) =
// m det(e, n_a x n_b, e') = m (e . n_b) (n_a . e'), and the edges leave the sides of their apices.
int order_on_line(const TriangleCorners& a, const LinePoints& on_a, std::uint8_t to_a,
                  const TriangleCorners& b, const LinePoints& on_b, std::uint8_t to_b) {
    return orient3d(a[on_a.apex], a[to_a], b[on_b.apex], b[to_b]) * on_a.side * on_b.side;
}

}  // namespace scb
