#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "scb/triangle_overlap.h"
#include "tests/core/geometry/big_integer.h"

namespace scb {

template <class Integer>
using IntegerPoint = std::array<Integer, 3>;

template <class Integer>
using IntegerTriangle = std::array<IntegerPoint<Integer>, 3>;

/// Whether two triangles overlap, without any geometry: is there u1, u2, v1, v2 with
/// a0 + u1 (a1 - a0) + u2 (a2 - a0) = b0 + v1 (b1 - b0) + v2 (b2 - b0), none negative, u1 + u2 <= 1
/// and v1 + v2 <= 1? The variables are eliminated one by one: by an equation while one has them
/// (Gauss), else by pairs of inequalities (Fourier and Motzkin). Integers grow to some 16 times the
/// digits of the coordinates; those up to 6 leave room in 64 bits. `inner`: whether interiors have
/// a common point, so that all of these are more than 0.
template <class Integer>
bool reference_overlap(const IntegerTriangle<Integer>& a, const IntegerTriangle<Integer>& b,
                       bool inner = false) {
    using Row = std::array<Integer, 5>;  // coefficients of u1, u2, v1, v2, and the constant
    std::vector<Row> equations, inequalities{{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {-1, -1, 0, 0, 1},
                                             {0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {0, 0, -1, -1, 1}};
    for (std::size_t i = 0; i < 3; ++i)
        equations.push_back({a[1][i] - a[0][i], a[2][i] - a[0][i], b[0][i] - b[1][i],
                             b[0][i] - b[2][i], a[0][i] - b[0][i]});

    const auto combined = [](const Row& r, const Integer& p, const Row& s, const Integer& q) {
        Row result;
        for (std::size_t i = 0; i < 5; ++i) result[i] = r[i] * p + s[i] * q;
        return result;
    };
    for (std::size_t x = 0; x < 4; ++x) {
        std::size_t pivot = 0;
        while (pivot < equations.size() && sign_of(equations[pivot][x]) == 0) ++pivot;
        if (pivot < equations.size()) {
            Row row = equations[pivot];
            equations.erase(equations.begin() + static_cast<std::ptrdiff_t>(pivot));
            if (sign_of(row[x]) < 0)
                for (Integer& value : row) value = -value;
            for (Row& r : equations) r = combined(r, row[x], row, -r[x]);
            for (Row& r : inequalities) r = combined(r, row[x], row, -r[x]);
            continue;
        }
        std::vector<Row> next;
        for (const Row& r : inequalities)
            if (sign_of(r[x]) == 0) next.push_back(r);
        for (const Row& r : inequalities)
            for (const Row& s : inequalities)
                if (sign_of(r[x]) > 0 && sign_of(s[x]) < 0)
                    next.push_back(combined(r, -s[x], s, r[x]));
        inequalities = std::move(next);
    }
    for (const Row& r : equations)
        if (sign_of(r[4]) != 0) return false;
    for (const Row& r : inequalities)
        if (sign_of(r[4]) < 0 || (inner && sign_of(r[4]) == 0)) return false;
    return true;
}

/// Doubles as integers, all multiplied by the same power of two.
inline std::vector<BigInteger> as_integers(const std::vector<double>& values) {
    int lowest = 2000;
    for (const double value : values)
        if (value != 0) {
            int exponent;
            std::frexp(value, &exponent);
            lowest = std::min(lowest, std::max(exponent - 53, -1074));
        }
    std::vector<BigInteger> result;
    for (const double value : values) {
        int exponent;
        const double fraction = std::frexp(value, &exponent);
        BigInteger integer(static_cast<std::int64_t>(std::ldexp(fraction, 53)));
        int shift = value == 0 ? 0 : exponent - 53 - lowest;
        // Denormals: trailing zeros, which the shift would take below `lowest`.
        if (shift < 0) {
            integer = BigInteger(static_cast<std::int64_t>(std::ldexp(fraction, 53 + shift)));
            shift = 0;
        }
        for (; shift > 0; shift -= 32)
            integer = integer * BigInteger(std::int64_t{1} << std::min(shift, 32));
        result.push_back(integer);
    }
    return result;
}

/// The points with each axis multiplied by a power of two of its own, which changes neither
/// whether triangles overlap nor the sign of a determinant.
inline std::vector<IntegerPoint<BigInteger>> as_integer_points(const std::vector<Vec3>& points) {
    std::vector<IntegerPoint<BigInteger>> result(points.size());
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const Vec3& p : points) values.push_back(p[axis]);
        const std::vector<BigInteger> integers = as_integers(values);
        for (std::size_t i = 0; i < points.size(); ++i)
            result[i][static_cast<std::size_t>(axis)] = integers[i];
    }
    return result;
}

/// The same for any finite doubles.
inline bool reference_overlap(const TriangleCorners& a, const TriangleCorners& b) {
    const auto p = as_integer_points({a[0], a[1], a[2], b[0], b[1], b[2]});
    return reference_overlap<BigInteger>({p[0], p[1], p[2]}, {p[3], p[4], p[5]});
}

}  // namespace scb
