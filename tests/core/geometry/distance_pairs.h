#pragma once

#include <algorithm>
#include <cmath>

#include "tests/core/geometry/triangle_pairs.h"

// Pairs of triangles for distances, and the error that distances may have.
namespace scb {

inline double largest_coordinate(const TriangleCorners& t) {
    double most = 0;
    for (const Vec3& p : t) most = std::max(most, p.cwiseAbs().maxCoeff());
    return most;
}

/// The error that the header states.
inline double allowed_error(const TrianglePair& pair) {
    return 4 * 0x1p-52 * std::max(largest_coordinate(pair.a), largest_coordinate(pair.b));
}

/// Triangles of any shape, near each other and far away, on and off the origin.
inline TrianglePair random_shapes(Random& random) {
    TrianglePair pair;
    const double gap = std::pow(10, random.uniform(-6, 1)),
                 size = std::pow(10, random.uniform(-3, 1)),
                 far = random.below(3) == 0 ? std::pow(10, random.uniform(0, 3)) : 0;
    for (TriangleCorners* t : {&pair.a, &pair.b})
        for (Vec3& corner : *t)
            for (int axis = 0; axis < 3; ++axis)
                corner[axis] = random.uniform(-1, 1) * (t == &pair.a ? 1 : size);
    for (TriangleCorners* t : {&pair.a, &pair.b})
        if (random.below(3) == 0)  // a needle
            (*t)[2] = (*t)[0] + random.uniform(0, 1) * ((*t)[1] - (*t)[0]) +
                      std::pow(10, random.uniform(-8, -2)) * Vec3(0.3, -0.5, 0.7);
    Vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    for (Vec3& corner : pair.b) corner += way * gap;
    for (TriangleCorners* t : {&pair.a, &pair.b})
        for (Vec3& corner : *t) corner += Vec3::Constant(far);
    return pair;
}

/// Triangles with nearly parallel edges that cross each other nearby.
inline TrianglePair nearly_parallel(Random& random) {
    const auto vector = [&random] {
        return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    const Vec3 middle = vector(), along = vector();
    const auto triangle = [&](const Vec3& point, const Vec3& edge) {
        return TriangleCorners{Vec3(point - random.uniform(0.1, 1) * edge),
                               Vec3(point + random.uniform(0.1, 1) * edge),
                               Vec3(point + random.uniform(0, 1) * vector())};
    };
    const double tilt = std::pow(10, random.uniform(-9, 0)),
                 gap = std::pow(10, random.uniform(-12, 0)),
                 length = std::pow(10, random.uniform(-1, 1));
    return {triangle(middle, along),
            triangle(middle + gap * vector(), length * (along + tilt * vector()))};
}

/// Two needles or slivers, one behind the other: with sides down to 1e-9 of the others.
inline TrianglePair random_slivers(Random& random) {
    TrianglePair pair;
    const Vec3 along(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)),
        way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double gap = std::pow(10, random.uniform(-9, 1));
    for (TriangleCorners* t : {&pair.a, &pair.b}) {
        const double thin = std::pow(10, random.uniform(-9, -1)), turn = random.uniform(0, 1);
        const Vec3 any(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)),
            side = turn * turn * turn * any + along, origin = (t == &pair.a ? 0 : gap) * way;
        *t = {origin - random.uniform(0, 1) * side, origin + random.uniform(0, 1) * side,
              origin + random.uniform(-1, 1) * side + thin * any};
    }
    return pair;
}

/// A corner of B above a point inside A, or on an edge of A; at a height down to rounding.
inline TrianglePair corner_above(Random& random) {
    const auto any = [&random] {
        return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    TrianglePair pair;
    for (Vec3& corner : pair.a) corner = any();
    const Vec3 u = pair.a[1] - pair.a[0], v = pair.a[2] - pair.a[0];
    Vec3 normal = cross(u, v);
    normal /= std::max(1e-9, std::sqrt(squared_norm(normal)));
    const double s = random.uniform(0, 1), t = random.below(3) == 0 ? 0 : random.uniform(0, 1 - s);
    const double height = random.below(4) == 0 ? 0 : std::pow(10, random.uniform(-17, 0));
    pair.b[0] = pair.a[0] + s * u + t * v + height * normal;
    for (std::size_t k = 1; k < 3; ++k) {
        const Vec3 way = any();
        pair.b[k] = pair.b[0] + (dot(way, normal) < 0 ? Vec3(-way) : way);
    }
    if (random.below(2) == 0) std::swap(pair.a, pair.b);
    return pair;
}

/// Two in planes that are parallel, exactly or nearly, and near each other.
inline TrianglePair stacked(Random& random) {
    TrianglePair pair = nearly_coplanar_pair(random);
    const Vec3 lift = std::pow(10, random.uniform(-14, 0)) *
                      cross(Vec3(pair.a[1] - pair.a[0]), Vec3(pair.a[2] - pair.a[0]));
    for (Vec3& corner : pair.b) corner += lift;
    return pair;
}

}  // namespace scb
