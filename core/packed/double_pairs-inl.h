// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_DOUBLE_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_DOUBLE_PAIRS_INL_H_
#undef SCB_CORE_DOUBLE_PAIRS_INL_H_
#else
#define SCB_CORE_DOUBLE_PAIRS_INL_H_
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/lane_parts-inl.h"
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
    using Corners = std::array<Doubles3, 3>;

    DoubleMask intersect;  ///< the triangles certainly have a common point
    DoubleMask apart;      ///< the triangles certainly have no common point

    /// Of the triangles P and Q.
    HWY_INLINE DoublePairs(const Corners& p, const Corners& q)
        : DoublePairs(Rotated{rotated(p)}, Rotated{rotated(q)}) {
        Doubles least = Doubles::all(1);
        for (const Corners* corners : {&p, &q})
            for (const Doubles3& corner : *corners) least = smallest_magnitude(least, corner);
        const DoubleMask sure = !underflows(least);
        intersect = intersect & sure;
        apart = apart & sure;
    }

  private:
    using Signs = std::array<LaneSigns, 3>;

    /// Corners in an order in which the first edge is parallel to an axis, if there is such an
    /// edge.
    struct Rotated {
        Corners corners;
    };

    /// Differences of corners for determinants. A determinant of an edge or a plane and a corner is
    /// the same from each corner of the edge or plane.
    struct Ways {
        std::array<Corners, 3> between;  ///< from edge i of P to edge j of Q
        Corners to_p, to_q;              ///< from the other triangle to a corner
    };

    HWY_INLINE DoublePairs(const Rotated& first, const Rotated& second)
        : intersect(none(first)),
          apart(none(first)),
          in_one_plane_(none(first)),
          p_(first.corners),
          q_(second.corners),
          edge_p_(edges(first.corners)),
          edge_q_(edges(second.corners)) {
        const LanePlane plane_p(edge_p_[0], edge_p_[1]), plane_q(edge_q_[0], edge_q_[1]);
        Ways ways = from_first_corners();
        for (int attempt = 0; attempt < 2 && some_open(); ++attempt) {
            if (attempt == 1) ways = along_axes(ways);
            decide_across(plane_p, plane_q, ways);
            if (some_open()) decide_in_projection(plane_p.normal);
        }
    }

    static HWY_INLINE DoubleMask none(const Rotated& t) { return t.corners[0].x < t.corners[0].x; }
    bool some_open() const { return (!(intersect | apart)).bits() != 0; }

    static HWY_INLINE DoubleMask parallel_to_axis(const Doubles3& a, const Doubles3& b) {
        const DoubleMask x = a.x == b.x, y = a.y == b.y, z = a.z == b.z;
        return (x & y) | (x & z) | (y & z);
    }
    static HWY_INLINE Doubles3 one_of(DoubleMask mask, const Doubles3& yes, const Doubles3& no) {
        return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
    }

    /// With the first edge parallel to an axis, the terms of the height of a point on the line of
    /// that edge are all 0.
    static HWY_INLINE Corners rotated(const Corners& from) {
        const DoubleMask first = parallel_to_axis(from[0], from[1]),
                         second = parallel_to_axis(from[1], from[2]) & !first,
                         third = parallel_to_axis(from[2], from[0]) & !(first | second);
        return lane_parts<3>([&](std::size_t i) HWY_ATTR {
            return one_of(second, from[(i + 1) % 3], one_of(third, from[(i + 2) % 3], from[i]));
        });
    }
    static HWY_INLINE Corners edges(const Corners& t) {
        return {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    }

    HWY_INLINE Ways from_first_corners() const {
        const auto between = [this](std::size_t i) HWY_ATTR {
            return Corners{q_[0] - p_[i], q_[1] - p_[i], q_[2] - p_[i]};
        };
        return {lane_parts<3>(between), {p_[0] - q_[0], p_[1] - q_[0], p_[2] - q_[0]}, between(0)};
    }

    /// The differences that are parallel to an axis, where there are some: then more terms are 0.
    HWY_INLINE Ways along_axes(const Ways& from) const {
        const auto along = [this](std::size_t i, std::size_t j)
                               HWY_ATTR { return parallel_to_axis(p_[i], q_[j]); };
        const auto best = [&](std::size_t i, std::size_t j) HWY_ATTR {
            const std::size_t next_i = (i + 1) % 3, next_j = (j + 1) % 3;
            const auto& d = from.between;
            return one_of(along(i, j), d[i][j],
                          one_of(along(next_i, j), d[next_i][j],
                                 one_of(along(next_i, next_j), d[next_i][next_j],
                                        one_of(along(i, next_j), d[i][next_j], d[i][j]))));
        };
        return {lane_parts<3>([&](std::size_t i) HWY_ATTR {
                    return Corners{best(i, 0), best(i, 1), best(i, 2)};
                }),
                lane_parts<3>([&](std::size_t i) HWY_ATTR {
                    return one_of(along(i, 1), -from.between[i][1],
                                  one_of(along(i, 2), -from.between[i][2], from.to_p[i]));
                }),
                lane_parts<3>([&](std::size_t j) HWY_ATTR {
                    return one_of(along(1, j), from.between[1][j],
                                  one_of(along(2, j), from.between[2][j], from.to_q[j]));
                })};
    }

    /// Decides by the planes and the edges. Two proper triangles in planes that cross intersect if
    /// and only if an edge of one meets the other: an end of the edge is not in the plane, the ends
    /// are not on one side of it, and its sides of the other's three edges do not have two signs.
    /// An edge in the plane is left out. If such an edge of P meets Q, then an end of it is in Q,
    /// and another edge of P has that end; or an edge of Q meets it and is not in P's plane; or an
    /// edge of Q on the same line has an end in P, and another edge of Q has that end.
    HWY_INLINE void decide_across(const LanePlane& plane_p, const LanePlane& plane_q,
                                  const Ways& ways) {
        // The sides of corners, of the other's plane.
        const Signs of_p = lane_parts<3>([&](std::size_t i)
                                             HWY_ATTR { return plane_q.side(ways.to_p[i]); }),
                    of_q = lane_parts<3>([&](std::size_t j)
                                             HWY_ATTR { return plane_p.side(ways.to_q[j]); });
        const SignRange range_p(of_p[0], of_p[1], of_p[2]), range_q(of_q[0], of_q[1], of_q[2]);
        in_one_plane_ = in_one_plane_ | range_q.all_zero();
        apart = apart | range_p.one_sign() | range_q.one_sign();
        if ((!(apart | in_one_plane_)).bits() == 0) return;

        const auto side = lane_parts<3>([&](std::size_t i) HWY_ATTR {
            return lane_parts<3>([&](std::size_t j) HWY_ATTR {
                return LanePlane(edge_p_[i], ways.between[i][j]).side(edge_q_[j]);
            });
        });
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
    HWY_INLINE void decide_in_projection(Doubles3 normal) {
        const Doubles x = abs(normal.x), y = abs(normal.y), z = abs(normal.z);
        const DoubleMask along_x = (y < x) & (z < x), along_y = (z < y) & !along_x;
        const auto projected = [&](const Doubles3& c) HWY_ATTR {
            return Doubles2{select(along_x, c.y, select(along_y, c.z, c.x)),
                            select(along_x, c.z, select(along_y, c.x, c.y))};
        };
        using Flat = std::array<Doubles2, 3>;
        const Flat p = {projected(p_[0]), projected(p_[1]), projected(p_[2])},
                   q = {projected(q_[0]), projected(q_[1]), projected(q_[2])},
                   edge_p = {p[1] - p[0], p[2] - p[1], p[0] - p[2]},
                   edge_q = {q[1] - q[0], q[2] - q[1], q[0] - q[2]};
        const LaneSigns turn_p = turn(edge_p[0], edge_p[1]), turn_q = turn(edge_q[0], edge_q[1]);
        const Doubles zero = Doubles::all(0);
        DoubleMask separated = x < x, overlap = in_one_plane_;
        const auto edge = [&](const LaneSigns& own, const SignRange& range) HWY_ATTR {
            const DoubleMask up = zero < own.value, down = own.value < zero;
            separated = separated | (up & (range.greatest < zero)) | (down & (zero < range.least));
            // A corner whose side is unsure may be the only one that is not beyond the edge.
            overlap =
                overlap & ((up & (zero < range.greatest)) | (down & (range.least < zero)) |
                           (((up & (zero <= range.greatest)) | (down & (range.least <= zero))) &
                            !range.unsure));
        };
        const auto between = lane_parts<3>([&](std::size_t i) HWY_ATTR {
            return Flat{q[0] - p[i], q[1] - p[i], q[2] - p[i]};
        });
        for (std::size_t i = 0; i < 3; ++i) {
            edge(turn_p, {turn(edge_p[i], between[i][0]), turn(edge_p[i], between[i][1]),
                          turn(edge_p[i], between[i][2])});
            edge(turn_q, {turn(between[0][i], edge_q[i]), turn(between[1][i], edge_q[i]),
                          turn(between[2][i], edge_q[i])});
        }
        apart = apart | separated;
        intersect = intersect | overlap;
    }

    DoubleMask in_one_plane_;  ///< all corners of Q are certainly in the plane of P
    Corners p_, q_, edge_p_, edge_q_;
};

/// The rows of double_lanes triangles: x, y, z of each corner.
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
        for (std::size_t k = 0; k < double_lanes; ++k) {
            const IndexPair& pair = undecided[first + std::min(k, count - 1)];
            of_a.set(k, a, pair.a);
            of_b.set(k, b, pair.b);
        }
        const DoublePairs::Corners p = {of_a.corner(0), of_a.corner(1), of_a.corner(2)},
                                   q = {transformed(b_to_a, of_b.corner(0)),
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
