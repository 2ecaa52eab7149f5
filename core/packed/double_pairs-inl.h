// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_DOUBLE_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_DOUBLE_PAIRS_INL_H_
#undef SCB_CORE_DOUBLE_PAIRS_INL_H_
#else
#define SCB_CORE_DOUBLE_PAIRS_INL_H_
#endif

#include "core/packed/lane_signs-inl.h"
#include "core/packed/packed_query.h"
#include "scb/triangle_overlap.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Pairs of triangles in double lanes, with the coordinates of the exact test. Signs of
/// determinants are certain beyond the error of their roundings, and where all their terms are 0.
/// That is usual where parts of an assembly lie on each other: planes and edges along the axes, and
/// corners beside each other along an axis.
class DoublePairs {
  public:
    DoubleMask intersect;  ///< the triangles certainly have a common point
    DoubleMask apart;      ///< the triangles certainly have no common point

    /// Corners of the triangles P and Q.
    HWY_INLINE DoublePairs(const Doubles3 (&first)[3], const Doubles3 (&second)[3]) {
        Doubles3 p[3], q[3];
        rotate_corners(first, p);
        rotate_corners(second, q);
        Ways ways;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            edge_p_[i] = p[next] - p[i];
            edge_q_[i] = q[next] - q[i];
            for (std::size_t j = 0; j < 3; ++j) ways.between[i][j] = q[j] - p[i];
            ways.to_q[i] = ways.between[0][i];
            ways.to_p[i] = p[i] - q[0];
        }
        const LanePlane plane_p(edge_p_[0], edge_p_[1]), plane_q(edge_q_[0], edge_q_[1]);
        intersect = apart = edge_p_[0].x < edge_p_[0].x;  // none
        in_one_plane_ = apart;
        for (int attempt = 0; attempt < 2 && some_open(); ++attempt) {
            if (attempt == 1) ways = along_axes(p, q, ways);
            decide_across(plane_p, plane_q, ways);
            if (some_open()) decide_in_projection(p, q, plane_p.normal);
        }

        Doubles least = Doubles::all(1);
        for (const auto* corners : {&p, &q})
            for (const Doubles3& corner : *corners) least = smallest_magnitude(least, corner);
        const DoubleMask sure = !underflows(least);
        intersect = intersect & sure;
        apart = apart & sure;
    }

  private:
    /// Differences of corners for determinants. A determinant of an edge or a plane and a corner is
    /// the same from each corner of the edge or plane.
    struct Ways {
        Doubles3 between[3][3];     ///< from edge i of P to edge j of Q
        Doubles3 to_p[3], to_q[3];  ///< from the other triangle to a corner
    };

    bool some_open() const { return (!(intersect | apart)).bits() != 0; }

    static HWY_INLINE DoubleMask parallel_to_axis(const Doubles3& a, const Doubles3& b) {
        const DoubleMask x = a.x == b.x, y = a.y == b.y, z = a.z == b.z;
        return (x & y) | (x & z) | (y & z);
    }
    static HWY_INLINE Doubles3 one_of(DoubleMask mask, const Doubles3& yes, const Doubles3& no) {
        return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
    }

    /// Rotates the corners so that the first edge is parallel to an axis, if there is such an edge.
    /// Then the terms of the height of a point on the line of that edge are all 0.
    static HWY_INLINE void rotate_corners(const Doubles3 (&from)[3], Doubles3 (&to)[3]) {
        const DoubleMask first = parallel_to_axis(from[0], from[1]),
                         second = parallel_to_axis(from[1], from[2]) & !first,
                         third = parallel_to_axis(from[2], from[0]) & !(first | second);
        for (std::size_t i = 0; i < 3; ++i)
            to[i] = one_of(second, from[(i + 1) % 3], one_of(third, from[(i + 2) % 3], from[i]));
    }

    /// The differences that are parallel to an axis, where there are some: then more terms are 0.
    static HWY_INLINE Ways along_axes(const Doubles3 (&p)[3], const Doubles3 (&q)[3],
                                      const Ways& from) {
        DoubleMask along[3][3];
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) along[i][j] = parallel_to_axis(p[i], q[j]);
        Ways to = from;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next_i = (i + 1) % 3;
            for (std::size_t j = 0; j < 3; ++j) {
                const std::size_t next_j = (j + 1) % 3;
                to.between[i][j] =
                    one_of(along[i][next_j], from.between[i][next_j], from.between[i][j]);
                to.between[i][j] = one_of(
                    along[next_i][j], from.between[next_i][j],
                    one_of(along[next_i][next_j], from.between[next_i][next_j], to.between[i][j]));
                to.between[i][j] = one_of(along[i][j], from.between[i][j], to.between[i][j]);
                to.to_q[i] = one_of(along[j][i], from.between[j][i], to.to_q[i]);
                to.to_p[i] = one_of(along[i][j], -from.between[i][j], to.to_p[i]);
            }
        }
        return to;
    }

    /// Decides by the planes and the edges. Two proper triangles in planes that cross intersect if
    /// and only if an edge of one meets the other: an end of the edge is not in the plane, the ends
    /// are not on one side of it, and its sides of the other's three edges do not have two signs.
    /// An edge in the plane is left out. If such an edge of P meets Q, then an end of it is in Q,
    /// and another edge of P has that end; or an edge of Q meets it and is not in P's plane; or an
    /// edge of Q on the same line has an end in P, and another edge of Q has that end.
    HWY_INLINE void decide_across(const LanePlane& plane_p, const LanePlane& plane_q,
                                  const Ways& ways) {
        LaneSigns of_p[3], of_q[3];  // the sides of corners, of the other's plane
        for (std::size_t i = 0; i < 3; ++i) {
            of_q[i] = plane_p.side(ways.to_q[i]);
            of_p[i] = plane_q.side(ways.to_p[i]);
        }
        const SignRange range_p(of_p[0], of_p[1], of_p[2]), range_q(of_q[0], of_q[1], of_q[2]);
        in_one_plane_ = in_one_plane_ | range_q.all_zero();
        apart = apart | range_p.one_sign() | range_q.one_sign();
        if ((!(apart | in_one_plane_)).bits() == 0) return;

        LaneSigns side[3][3];
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                side[i][j] = LanePlane(edge_p_[i], ways.between[i][j]).side(edge_q_[j]);
        // A corner off a plane shows that the triangle of the plane is proper.
        DoubleMask beside = range_p.some_sign() & range_q.some_sign();
        const auto edge = [&](const SignRange& ends, const SignRange& sides) HWY_ATTR {
            const DoubleMask in_plane = ends.all_zero();
            intersect =
                intersect | (sides.not_both() & !(in_plane | ends.one_sign() | ends.unsure));
            beside = beside & (in_plane | ends.one_sign() | sides.both());
        };
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            edge({of_p[i], of_p[next]}, {side[i][0], side[i][1], side[i][2]});
            edge({of_q[i], of_q[next]}, {side[0][i], side[1][i], side[2][i]});
        }
        apart = apart | beside;
    }

    /// Decides by the projections along the axis to which P's plane is closest to perpendicular. A
    /// line of an edge that separates these shows that the triangles are apart. Triangles in one
    /// plane intersect if no edge does, as in coplanar_overlap.
    HWY_INLINE void decide_in_projection(const Doubles3 (&p)[3], const Doubles3 (&q)[3],
                                         Doubles3 normal) {
        const Doubles x = abs(normal.x), y = abs(normal.y), z = abs(normal.z);
        const DoubleMask along_x = (y < x) & (z < x), along_y = (z < y) & !along_x;
        const auto projected = [&](Doubles3 c) HWY_ATTR {
            return Doubles2{select(along_x, c.y, select(along_y, c.z, c.x)),
                            select(along_x, c.z, select(along_y, c.x, c.y))};
        };
        Doubles2 flat_p[3], flat_q[3], edge_p[3], edge_q[3];
        for (std::size_t i = 0; i < 3; ++i) {
            flat_p[i] = projected(p[i]);
            flat_q[i] = projected(q[i]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            edge_p[i] = flat_p[(i + 1) % 3] - flat_p[i];
            edge_q[i] = flat_q[(i + 1) % 3] - flat_q[i];
        }
        const LaneSigns turn_p = turn(edge_p[0], edge_p[1]), turn_q = turn(edge_q[0], edge_q[1]);
        const Doubles zero = Doubles::all(0);
        DoubleMask separated = x < x, overlap = in_one_plane_;
        LaneSigns of_q[3][3], of_p[3][3];  // sides of corners, by edge
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                const Doubles2 between = flat_q[j] - flat_p[i];
                of_q[i][j] = turn(edge_p[i], between);
                of_p[j][i] = turn(between, edge_q[j]);
            }
        const auto edge = [&](const LaneSigns& own, const LaneSigns(&other)[3]) HWY_ATTR {
            const SignRange range(other[0], other[1], other[2]);
            const DoubleMask up = zero < own.value, down = own.value < zero;
            separated = separated | (up & (range.greatest < zero)) | (down & (zero < range.least));
            // A corner whose side is unsure may be the only one that is not beyond the edge.
            overlap =
                overlap & ((up & (zero < range.greatest)) | (down & (range.least < zero)) |
                           (((up & (zero <= range.greatest)) | (down & (range.least <= zero))) &
                            !range.unsure));
        };
        for (std::size_t i = 0; i < 3; ++i) {
            edge(turn_p, of_q[i]);
            edge(turn_q, of_p[i]);
        }
        apart = apart | separated;
        intersect = intersect | overlap;
    }

    Doubles3 edge_p_[3], edge_q_[3];
    DoubleMask in_one_plane_;  ///< all corners of Q are certainly in the plane of P
};

/// The rows of up to double_lanes triangles: x, y, z of each corner. Lanes behind the last have the
/// numbers of earlier triangles, or 0.
struct TriangleRows {
    double of[9][double_lanes] = {};

    HWY_INLINE void set(std::size_t lane, const Mesh& mesh, std::uint32_t triangle) {
        const Triangle& t = mesh.triangles[triangle];
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& v = mesh.vertices[t[i]];
            for (int axis = 0; axis < 3; ++axis)
                of[3 * i + static_cast<std::size_t>(axis)][lane] = v[axis];
        }
    }
    HWY_INLINE Doubles3 corner(std::size_t i) const {
        return {Doubles::load(of[3 * i]), Doubles::load(of[3 * i + 1]),
                Doubles::load(of[3 * i + 2])};
    }
};

/// transform_point, with the same roundings.
HWY_INLINE Doubles3 transformed(const Pose& pose, Doubles3 p) {
    const auto row = [&](int i) HWY_ATTR {
        return Doubles::all(pose.rotation(i, 0)) * p.x + Doubles::all(pose.rotation(i, 1)) * p.y +
               Doubles::all(pose.rotation(i, 2)) * p.z + Doubles::all(pose.translation[i]);
    };
    return {row(0), row(1), row(2)};
}

/// Decides the pairs that floats left undecided, in doubles. Pairs that intersect move to
/// `found.pairs`; pairs that only an exact test can decide stay undecided, in their order.
inline void decide_in_doubles(const Mesh& a, const Mesh& b, const Pose& b_to_a,
                              PackedFindings& found) {
    std::vector<IndexPair>& undecided = found.undecided;
    TriangleRows of_a, of_b;
    std::size_t left = 0;
    for (std::size_t first = 0; first < undecided.size(); first += double_lanes) {
        const std::size_t count = std::min(double_lanes, undecided.size() - first);
        for (std::size_t k = 0; k < count; ++k) {
            of_a.set(k, a, undecided[first + k].a);
            of_b.set(k, b, undecided[first + k].b);
        }
        const Doubles3 p[] = {of_a.corner(0), of_a.corner(1), of_a.corner(2)},
                       q[] = {transformed(b_to_a, of_b.corner(0)),
                              transformed(b_to_a, of_b.corner(1)),
                              transformed(b_to_a, of_b.corner(2))};
        const DoublePairs certain(p, q);
        const std::uint32_t all = low_bits(static_cast<std::uint32_t>(count)),
                            yes = certain.intersect.bits() & all, no = certain.apart.bits() & all;
        const auto for_each = [&](std::uint32_t bits, auto put) HWY_ATTR {
            for (; bits != 0; bits &= bits - 1)
                put(undecided[first + static_cast<std::size_t>(std::countr_zero(bits))]);
        };
        for_each(yes, [&](IndexPair pair) { found.pairs.push_back(pair); });
        for_each(all & ~(yes | no), [&](IndexPair pair) { undecided[left++] = pair; });
    }
    undecided.resize(left);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
