#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/random.h"
#include "scb/vec.h"

namespace scb {

/// Corners of two triangles P and Q, exact, relative to the first of P, which is left out.
using TrueCorners = std::array<double, 15>;

inline Vec3 corner(const TrueCorners& c, std::size_t i) {
    return i == 0 ? Vec3(0, 0, 0) : Vec3(c[3 * i - 3], c[3 * i - 2], c[3 * i - 1]);
}
inline Vec3 corner_p(const TrueCorners& c, std::size_t i) { return corner(c, i % 3); }
inline Vec3 corner_q(const TrueCorners& c, std::size_t j) { return corner(c, 3 + j % 3); }

inline Vec3 grid_point(Random& random) {
    const auto x = [&random] { return static_cast<double>(random.below(17)) - 8; };
    const double a = x(), b = x(), c = x();
    return {a, b, c};
}

/// Two triangles that just touch, or that are a little apart or into each other.
inline TrueCorners touching(Random& random) {
    std::array<Vec3, 3> p, q;
    for (Vec3& x : p) x = grid_point(random);
    for (Vec3& x : q) x = grid_point(random);
    const Vec3 u = p[1] - p[0], v = p[2] - p[0];
    switch (random.below(5)) {
        case 0: {  // an edge across an edge
            const Vec3 middle = (p[0] + p[1]) / 2, way = q[1] - q[0];
            q[0] = middle - way / 2;
            q[1] = middle + way / 4;
            if (random.below(2) == 0) q[2] = 2 * middle - p[2];
            break;
        }
        case 1:  // a corner in the face
            q[0] = p[0] + u / 4 + v / 2;
            break;
        case 2:  // one plane
            for (Vec3& x : q)
                x = p[0] + (static_cast<double>(random.below(9)) - 4) / 4 * u +
                    (static_cast<double>(random.below(9)) - 4) / 4 * v;
            break;
        case 3:  // needles that cross
            p[2] = p[1] + Vec3(0, 0, 0x1p-10);
            q[2] = q[1] + Vec3(0x1p-10, 0, 0);
            q[0] = p[0] + u / 2 - (q[1] - p[0] - u / 2);
            break;
        default:  // a corner in common
            q[0] = p[random.below(3)];
    }
    // To the side by a little: all are multiples of 2^-30.
    const Vec3 side = std::ldexp(1.0, -4 - static_cast<int>(random.below(20))) * grid_point(random);
    if (random.below(3) != 0)
        for (Vec3& x : q) x += side / 16;
    const std::uint32_t turn_p = random.below(3), turn_q = random.below(3);
    std::rotate(p.begin(), p.begin() + turn_p, p.end());
    std::rotate(q.begin(), q.begin() + turn_q, q.end());
    TrueCorners truth;
    for (std::size_t i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            if (i > 0) truth[3 * i - 3 + static_cast<std::size_t>(axis)] = p[i][axis] - p[0][axis];
            truth[6 + 3 * i + static_cast<std::size_t>(axis)] = q[i][axis] - p[0][axis];
        }
    return truth;
}

}  // namespace scb
