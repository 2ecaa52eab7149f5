#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "scb/convex.h"
#include "scb/fit_points.h"

namespace scb {

/// The 13 directions of the 26-DOP, with coordinates 0, 1 and -1: three axes, six edges and four
/// corners of a cube.
inline constexpr std::array<std::array<double, 3>, 13> dop_directions = {{{1, 0, 0},
                                                                          {0, 1, 0},
                                                                          {0, 0, 1},
                                                                          {1, 1, 0},
                                                                          {1, -1, 0},
                                                                          {1, 0, 1},
                                                                          {1, 0, -1},
                                                                          {0, 1, 1},
                                                                          {0, 1, -1},
                                                                          {1, 1, 1},
                                                                          {1, 1, -1},
                                                                          {1, -1, 1},
                                                                          {1, -1, -1}}};

/// The slabs of a discrete orientation polytope: lower[i] <= dop_directions[which[i]].p <=
/// upper[i].
struct DopSlabs {
    /// `count` indices of `dop_directions`.
    const int* which;
    /// The least direction.p of each slab.
    const double* lower;
    /// The greatest direction.p of each slab.
    const double* upper;
    /// The number of slabs.
    int count;
};

/// A farthest corner of the polytope in the direction d, in its own frame, by the dual simplex
/// method, which starts at a corner of its box. If the method ends early, by rounding or because
/// the polytope is empty, the result is a point beyond the farthest corner, never short of it.
Vec3 farthest_corner(const DopSlabs& slabs, const Vec3& d);

/// Its faces' planes, from the center.
std::vector<FacePlane> faces(const DopSlabs& slabs, const Vec3& center);

/// A discrete orientation polytope with k faces, 14, 18 or 26, fixed in the body's frame
/// (Klosowski, Held, Mitchell, Sowizral and Zikan, "Efficient Collision Detection Using Bounding
/// Volume Hierarchies of k-DOPs", 1998): along the axes, and along the corners of a cube, the
/// edges, or both. Two of them are tested exactly, by their farthest points. The test of the
/// literature, with the k-DOP about the turned one, lets more pairs pass.
template <int k>
struct KDop {
    static_assert(k == 14 || k == 18 || k == 26);
    /// The number of its slabs.
    static constexpr int slabs = k / 2;
    /// Its name in pictures.
    static constexpr const char* title = k == 14 ? "14-DOP" : k == 18 ? "18-DOP" : "26-DOP";
    /// The search visits 2.3, 2.5 and 2.7 corners, the means over queries of horse, tr12j and
    /// boeing. A corner takes 50 operations and 7 per slab, the step to the next corner 27.
    static constexpr unsigned support_operations = k == 14 ? 260 : k == 18 ? 320 : 430;

    /// Its directions, as ascending indices of `dop_directions`.
    static constexpr std::array<int, slabs> which = [] {
        std::array<int, slabs> result{};
        int next = 0;
        for (int i = 0; i < 13; ++i)
            if (k == 26 || i < 3 || (k == 18) == (i < 9))
                result[static_cast<std::size_t>(next++)] = i;
        return result;
    }();

    std::array<double, slabs> lower{},  ///< the least direction.p of each slab
        upper{};                        ///< the greatest direction.p of each slab
};
/// Along the axes and the corners of a cube.
using KDop14 = KDop<14>;
/// Along the axes and the edges of a cube.
using KDop18 = KDop<18>;
/// Along the axes, the corners and the edges of a cube.
using KDop26 = KDop<26>;

/// Its slabs, which must not outlive it.
template <int k>
DopSlabs slabs_of(const KDop<k>& v) {
    return {v.which.data(), v.lower.data(), v.upper.data(), v.slabs};
}

/// The center of its box along the axes. It may be outside the k-DOP if faces cut off corners of
/// the box.
template <int k>
Vec3 center(const KDop<k>& v) {
    return 0.5 *
           (Vec3(v.lower[0], v.lower[1], v.lower[2]) + Vec3(v.upper[0], v.upper[1], v.upper[2]));
}
/// 0: its edges are sharp.
template <int k>
double rounding(const KDop<k>&) {
    return 0;
}
/// The corner, from the center, that is farthest along `d`.
template <int k>
Vec3 support_point(const KDop<k>& v, const Vec3& d) {
    return farthest_corner(slabs_of(v), d) - center(v);
}
/// Its faces' planes, from the center.
template <int k>
std::vector<FacePlane> faces(const KDop<k>& v) {
    return faces(slabs_of(v), center(v));
}
/// Whether all is finite and no slab is empty.
template <int k>
bool is_well_formed(const KDop<k>& v) {
    for (std::size_t i = 0; i < v.which.size(); ++i)
        if (!(std::isfinite(v.lower[i]) && std::isfinite(v.upper[i]) && v.lower[i] <= v.upper[i]))
            return false;
    return true;
}
/// Whether the point is inside or on the surface.
template <int k>
bool contains(const KDop<k>& v, const Vec3& p) {
    for (std::size_t i = 0; i < v.which.size(); ++i) {
        const auto& d = dop_directions[static_cast<std::size_t>(v.which[i])];
        const double along = d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
        if (!(v.lower[i] <= along && along <= v.upper[i])) return false;
    }
    return true;
}
/// The narrowest slabs that hold the points.
template <int k>
void fit(KDop<k>& result, const FitPoints& points) {
    for (std::size_t i = 0; i < result.which.size(); ++i) {
        const auto direction = static_cast<std::size_t>(result.which[i]);
        result.lower[i] = points.lower(direction);
        result.upper[i] = points.upper(direction);
    }
}

/// Half the sides of its box, which its first three slabs form.
template <int k>
Vec3 half_extents(const KDop<k>& v) {
    return 0.5 *
           (Vec3(v.upper[0], v.upper[1], v.upper[2]) - Vec3(v.lower[0], v.lower[1], v.lower[2]));
}

}  // namespace scb
