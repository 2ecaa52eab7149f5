#include "core/geometry/orientation.h"

#include <gtest/gtest.h>

#include "tests/core/fit/point_sets.h"
#include "tests/core/geometry/triangle_pairs.h"

namespace scb {
namespace {

using Point = IntegerPoint<BigInteger>;

Point operator-(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

int reference_orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
    const auto p = as_integer_points({a, b, c});
    const auto x = static_cast<std::size_t>((axis + 1) % 3),
               y = static_cast<std::size_t>((axis + 2) % 3);
    const Point u = p[1] - p[0], v = p[2] - p[0];
    return (u[x] * v[y] - u[y] * v[x]).sign();
}

int reference_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto p = as_integer_points({a, b, c, d});
    const Point u = p[1] - p[0], v = p[2] - p[0], w = p[3] - p[0];
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
            u[2] * (v[0] * w[1] - v[1] * w[0]))
        .sign();
}

std::string shown(const std::array<Vec3, 4>& points) {
    std::ostringstream out;
    out << std::hexfloat;
    for (const Vec3& p : points) out << "(" << p[0] << ", " << p[1] << ", " << p[2] << ") ";
    return out.str();
}

// Checks all that is said about four points, and counts the signs in 3D.
void expect_reference(const std::array<Vec3, 4>& points, std::array<int, 3>& signs) {
    const auto& [a, b, c, d] = points;
    const int expected = reference_orient3d(a, b, c, d);
    ++signs[static_cast<std::size_t>(expected + 1)];
    ASSERT_EQ(orient3d(a, b, c, d), expected) << shown(points);
    ASSERT_EQ(orient3d_exact(a, b, c, d), expected) << shown(points);
    ASSERT_EQ(orient3d_exact(b, a, c, d), -expected) << shown(points);
    const int filtered = PlaneFilter(a, b, c).side(d);
    ASSERT_TRUE(filtered == 0 || filtered == expected) << shown(points);
    const double value = orient3d_value(a, b, c, d).significand;
    ASSERT_EQ((value > 0) - (value < 0), expected) << shown(points);
    for (int axis = 0; axis < 3; ++axis) {
        const int turn = reference_orient2d(a, b, c, axis);
        ASSERT_EQ(orient2d(a, b, c, axis), turn) << shown(points);
        ASSERT_EQ(orient2d_exact(a, b, c, axis), turn) << shown(points);
        const double area = orient2d_value(a, b, c, axis).significand;
        ASSERT_EQ((area > 0) - (area < 0), turn) << shown(points);
    }
}

TEST(Orient3d, IsPositiveOnTheSideOfTheNormal) {
    const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    EXPECT_EQ(orient3d(o, x, y, z), 1);
    EXPECT_EQ(orient3d(o, y, x, z), -1);
    EXPECT_EQ(orient3d(o, x, y, x + y), 0);
    EXPECT_EQ(orient3d(o, x, x, z), 0);
}

TEST(Orient2d, IsPositiveForACounterclockwiseTurnSeenFromTheTipOfTheAxis) {
    const Vec3 o(0, 0, 0), x(1, 0, 5), y(0, 1, -3);
    EXPECT_EQ(orient2d(o, x, y, 2), 1);
    EXPECT_EQ(orient2d(o, y, x, 2), -1);
    EXPECT_EQ(orient2d(o, x, 2 * x, 2), 0);
    EXPECT_EQ(orient2d(o, Vec3(0, 1, 0), Vec3(0, 0, 1), 0), 1);
    EXPECT_EQ(orient2d(o, Vec3(0, 0, 1), Vec3(1, 0, 0), 1), 1);
}

TEST(Orientation, IsExactNearDegeneracy) {
    Random random(11);
    std::array<int, 3> signs{};
    for (int i = 0; i < 30000 / effort; ++i) {
        const TrianglePair pair = nearly_coplanar_pair(random);
        expect_reference({pair.a[0], pair.a[1], pair.a[2], pair.b[0]}, signs);
        if (HasFatalFailure()) return;
    }
    for (const std::size_t sign : {0u, 2u}) EXPECT_GT(signs[sign], 10000 / effort);
}

TEST(Orientation, IsExactNearCollinearity) {
    Random random(15);
    std::array<int, 3> signs{};
    for (int i = 0; i < 30000 / effort; ++i) {
        std::array<Vec3, 4> points{
            random_point(random), random_point(random), {}, random_point(random)};
        for (int axis = 0; axis < 3; ++axis)
            points[1][axis] *= std::ldexp(1, static_cast<int>(random.below(4)));
        points[2] = points[0] + random.uniform() * (points[1] - points[0]);
        for (int axis = 0; axis < 3; ++axis)
            points[2][axis] = stepped(points[2][axis], static_cast<int>(random.below(3)) - 1);
        std::swap(points[2], points[random.below(3)]);
        expect_reference(points, signs);
        if (HasFatalFailure()) return;
    }
}

// A grid of doubles around a line on which all is collinear: the classical picture of failures.
TEST(Orientation, IsExactOnTheLatticeOfDoublesAroundALine) {
    std::array<int, 3> signs{};
    for (int i = -12; i <= 12; ++i)
        for (int j = -12; j <= 12; ++j) {
            const Vec3 p(stepped(0.5, i), stepped(0.5, j), stepped(0.5, i - j));
            expect_reference({p, Vec3(12, 12, 12), Vec3(24, 24, 24), Vec3(-1, 2, 5)}, signs);
            expect_reference({p, Vec3(12, 12, 3), Vec3(24, 24, 7), Vec3(5, 5, 5)}, signs);
            if (HasFatalFailure()) return;
        }
    for (const int count : signs) EXPECT_GT(count, 20);
}

TEST(Orientation, IsExactForEveryMagnitude) {
    Random random(12);
    std::array<int, 3> signs{};
    for (int i = 0; i < 20000 / effort; ++i) {
        // Exponents of one axis, or of all values, close together or anywhere.
        std::array<Vec3, 4> points;
        const int range = std::array<int, 4>{2, 60, 700, 1073}[random.below(4)];
        const int base = static_cast<int>(random.below(2000)) - 1000;
        const bool integers = random.below(2) == 0;
        for (Vec3& p : points)
            for (int axis = 0; axis < 3; ++axis) {
                const double mantissa =
                    integers ? static_cast<double>(random.below(7)) - 3 : random.uniform(-1, 1);
                const int exponent =
                    base + static_cast<int>(random.below(static_cast<std::uint32_t>(range)));
                p[axis] = std::ldexp(mantissa, std::clamp(exponent, -1074, 1020));
            }
        if (random.below(3) == 0) points[3] = points[0] / 2 + points[1] / 2;
        expect_reference(points, signs);
        if (HasFatalFailure()) return;
    }
    for (const int count : signs) EXPECT_GT(count, 2000 / effort);
}

// Axes scaled so that products of two or of three differences are about the smallest denormal; the
// third factor may be as large as it likes.
TEST(Orientation, IsExactWhereProductsUnderflow) {
    Random random(14);
    std::array<int, 3> signs{};
    for (int i = 0; i < 40000 / effort; ++i) {
        std::array<int, 3> exponents;
        const int sum = -1080 + static_cast<int>(random.below(20));
        exponents[0] = -200 - static_cast<int>(random.below(400));
        if (random.below(2) == 0) {
            exponents[1] = -100 - static_cast<int>(random.below(300));
            exponents[2] = sum - exponents[0] - exponents[1];
        } else {
            exponents[1] = sum - exponents[0];
            exponents[2] = static_cast<int>(random.below(900));
        }
        const std::size_t first = random.below(3);
        std::array<Vec3, 4> points;
        for (Vec3& p : points)
            for (std::size_t j = 0; j < 3; ++j)
                p[static_cast<int>((first + j) % 3)] =
                    std::ldexp(static_cast<double>(random.below(9)) - 4, exponents[j]);
        expect_reference(points, signs);
        if (HasFatalFailure()) return;
    }
    for (const int count : signs) EXPECT_GT(count, 500 / effort);
}

TEST(Orientation, IsExactAroundTheSmallestNormalNumber) {
    Random random(16);
    std::array<int, 3> signs{};
    for (int i = 0; i < 5000 / effort; ++i) {
        std::array<Vec3, 4> points;
        for (Vec3& p : points)
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = std::ldexp(static_cast<double>(random.below(9)) - 4, -1024);
        expect_reference(points, signs);
        if (HasFatalFailure()) return;
    }
    for (const int count : signs) EXPECT_GT(count, 50 / effort);
}

TEST(Orientation, IsExactAtTheEndsOfTheRangeOfDoubles) {
    std::array<int, 3> signs{};
    constexpr double most = std::numeric_limits<double>::max(), least = 0x1p-1074;
    Random random(13);
    for (int i = 0; i < 5000 / effort; ++i) {
        std::array<Vec3, 4> points;
        for (Vec3& p : points)
            for (int axis = 0; axis < 3; ++axis)
                p[axis] =
                    std::array<double, 7>{-most, -1, -least, 0, least, 1, most}[random.below(7)];
        expect_reference(points, signs);
        if (HasFatalFailure()) return;
    }
    for (const int count : signs) EXPECT_GT(count, 50 / effort);
}

TEST(OrientationValue, IsTheDeterminant) {
    const Vec3 o(1, 1, 1), x(4, 1, 1), y(1, 3, 1), z(1, 1, -6);
    const ScaledDouble volume = orient3d_value(o, x, y, z);
    EXPECT_EQ(std::ldexp(volume.significand, volume.exponent), -42);
    const ScaledDouble area = orient2d_value(o, x, y, 2);
    EXPECT_EQ(std::ldexp(area.significand, area.exponent), 6);
    // Differences that no double holds: 1 - 2^-70 at the third power.
    const double tiny = 0x1p-70;
    const ScaledDouble sum =
        orient3d_value({tiny, tiny, tiny}, {1, tiny, tiny}, {tiny, 1, tiny}, {tiny, tiny, 1});
    EXPECT_NEAR(std::ldexp(sum.significand, sum.exponent), 1, 0x1p-50);
    const Vec3 huge = 1e300 * Vec3(1, 1, 1);
    const ScaledDouble cube =
        orient3d_value({0, 0, 0}, {huge[0], 0, 0}, {0, huge[1], 0}, {0, 0, huge[2]});
    EXPECT_NEAR(std::log2(cube.significand) + cube.exponent, 3 * std::log2(1e300), 1e-9);
}

TEST(ExactSum, CancelsWithoutARest) {
    const Dyadic most(std::numeric_limits<double>::max()), least(-0x1p-1074), one(1),
        third(1.0 / 3);
    ExactSum sum(3 * -1074, 3 * 971);
    EXPECT_EQ(sum.sign(), 0);
    EXPECT_EQ(sum.value().significand, 0);
    sum.add(most, most, most);
    sum.add(least, least, least);
    EXPECT_EQ(sum.sign(), 1);
    sum.subtract(most, most, most);
    EXPECT_EQ(sum.sign(), -1);
    EXPECT_EQ(sum.value().significand * std::ldexp(1, sum.value().exponent + 3 * 1074), -1);
    sum.add(third, third, one);
    sum.subtract(least, least, least);
    EXPECT_EQ(sum.sign(), 1);
    EXPECT_NEAR(std::ldexp(sum.value().significand, sum.value().exponent), 1.0 / 9, 1e-16);
    sum.subtract(one, third, third);
    EXPECT_EQ(sum.sign(), 0);
}

}  // namespace
}  // namespace scb
