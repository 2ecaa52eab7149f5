#pragma once

#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "scb/triangle_overlap.h"
#include "tests/core/geometry/triangle_reference.h"
#include "tests/unless_sanitized.h"

namespace scb {

/// What tests divide their counts by: sanitizers take some twenty times as long. (Prime to the
/// sizes of the sets that are walked through in such steps.)
inline constexpr int effort = unless_sanitized(1, 23);

struct TrianglePair {
    TriangleCorners a, b;
};

using GridTriangle = IntegerTriangle<std::int64_t>;

inline TriangleCorners as_doubles(const GridTriangle& t) {
    TriangleCorners result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = {static_cast<double>(t[i][0]), static_cast<double>(t[i][1]),
                     static_cast<double>(t[i][2])};
    return result;
}

/// Corners in {0, ..., size - 1}^3; in a small grid many are collinear, coplanar or shared. One in
/// four is flattened to a plane and one in eight has a corner repeated.
inline GridTriangle random_grid_triangle(Random& random, std::uint32_t size) {
    GridTriangle t;
    for (auto& p : t)
        for (auto& x : p) x = random.below(size);
    if (random.below(4) == 0) {
        const std::size_t axis = random.below(3);
        for (auto& p : t) p[axis] = size / 2;
    }
    if (random.below(8) == 0) t[1] = t[random.below(2) * 2];
    return t;
}

struct GridPair {
    GridTriangle a, b;
};

inline GridPair random_grid_pair(Random& random, std::uint32_t size) {
    return {random_grid_triangle(random, size), random_grid_triangle(random, size)};
}

inline TrianglePair as_doubles(const GridPair& pair) {
    return {as_doubles(pair.a), as_doubles(pair.b)};
}

/// The double that is `steps` representable ones above x.
inline double stepped(double x, int steps) {
    const double toward = steps < 0 ? -std::numeric_limits<double>::infinity()
                                    : std::numeric_limits<double>::infinity();
    for (int i = std::abs(steps); i > 0; --i) x = std::nextafter(x, toward);
    return x;
}

/// A pair of about unit size. The corners are in one plane, up to the rounding of their coordinates
/// and two further ulps. About half of the pairs share a point, which is rounded too.
inline TrianglePair nearly_coplanar_pair(Random& random) {
    const auto coordinate = [&] { return random.uniform(-1, 1); };
    const Vec3 u{coordinate(), coordinate(), coordinate()},
        v{coordinate(), coordinate(), coordinate()}, o{coordinate(), coordinate(), coordinate()};
    const bool touching = random.below(2) == 0;
    const auto in_plane = [&](double s, double t) {
        Vec3 p = o + s * u + t * v;
        for (int i = 0; i < 3; ++i) p[i] = stepped(p[i], static_cast<int>(random.below(5)) - 2);
        return p;
    };
    TrianglePair pair;
    for (Vec3& p : pair.a) p = in_plane(coordinate(), coordinate());
    for (Vec3& p : pair.b) p = in_plane(coordinate(), coordinate());
    if (touching) {
        // A corner of b in the middle of an edge of a, or in a.
        const Vec3 middle = (pair.a[0] + pair.a[1]) / 2;
        pair.b[0] = random.below(2) == 0 ? middle : Vec3((middle + pair.a[2]) / 2);
    }
    return pair;
}

}  // namespace scb
