#include "core/fit/min_ball.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "scb/fit.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

double reach(const std::vector<Vec3>& points, const Vec3& center) {
    double r = 0;
    for (const Vec3& p : points) r = std::max(r, (p - center).norm());
    return r;
}

// The center equidistant from two to four points, in their affine hull, by a linear system; long
// double, no shortcuts.
Vec3 circumcenter(const std::vector<Vec3>& p) {
    using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    const auto k = static_cast<Eigen::Index>(p.size() - 1);
    Matrix u(3, k);
    for (Eigen::Index i = 0; i < k; ++i)
        u.col(i) = (p[std::size_t(i) + 1] - p[0]).cast<long double>();
    const Matrix gram = 2 * u.transpose() * u;
    const Matrix rhs = u.colwise().squaredNorm().transpose();
    const Matrix offset = u * gram.fullPivLu().solve(rhs);
    return p[0] + Vec3(offset.col(0).cast<double>());
}

// The smallest over all balls through two, three or four of the points that contain all: O(n^5).
double brute_force_radius(const std::vector<Vec3>& points) {
    double best = points.size() == 1 ? 0 : 1e300;
    const std::size_t n = points.size();
    const auto consider = [&](const std::vector<Vec3>& subset) {
        const Vec3 center = circumcenter(subset);
        if (center.allFinite()) best = std::min(best, reach(points, center));
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            consider({points[i], points[j]});
            for (std::size_t k = 0; k < j; ++k) {
                consider({points[i], points[j], points[k]});
                for (std::size_t l = 0; l < k; ++l)
                    consider({points[i], points[j], points[k], points[l]});
            }
        }
    return best;
}

void expect_minimal(const std::vector<Vec3>& points, double tolerance = 1e-12) {
    const Ball ball = min_ball(points);
    for (const Vec3& p : points) EXPECT_TRUE(contains(ball, p));
    const double best = brute_force_radius(points);
    EXPECT_NEAR(ball.radius, best, tolerance * std::max(best, 1e-300));
}

TEST(MinBall, MatchesBruteForceOnRandomPoints) {
    Random random(11);
    for (int i = 0; i < 300; ++i)
        expect_minimal(random_points(random, 1 + i % 13, i % 3 == 0 ? 1 : i % 3 == 1 ? 0.05 : 0));
}

TEST(MinBall, MatchesBruteForceOnDuplicates) {
    Random random(12);
    for (int i = 0; i < 60; ++i) {
        std::vector<Vec3> points = random_points(random, 4);
        points.insert(points.end(), points.begin(), points.end());
        points.push_back(points[1]);
        expect_minimal(points);
    }
    expect_minimal(std::vector<Vec3>(9, Vec3(0.1, 0.2, 0.3)));
}

TEST(MinBall, MatchesBruteForceOnCollinearPoints) {
    Random random(13);
    for (int i = 0; i < 60; ++i) {
        const Vec3 origin = random_point(random), along = random_unit_vector(random);
        std::vector<Vec3> points;
        for (int k = 0; k < 9; ++k) points.push_back(origin + random.uniform(-1, 1) * along);
        expect_minimal(points);
    }
}

TEST(MinBall, MatchesTheSphereOnCosphericalPoints) {
    Random random(14);
    for (const int count : {8, 26, 200, 3000}) {
        const Vec3 center = 10 * random_point(random);
        std::vector<Vec3> points;
        for (int k = 0; k < count / 2; ++k) {
            const Vec3 d = random_unit_vector(random);
            points.push_back(center + 3 * d);
            points.push_back(center - 3 * d);
        }
        const Ball ball = min_ball(points);
        EXPECT_NEAR(ball.radius, 3, 3e-12);
        EXPECT_LT((ball.center - center).norm(), 1e-6);
        for (const Vec3& p : points) EXPECT_TRUE(contains(ball, p));
    }
}

TEST(MinBall, IsExactOnTheCornersOfACube) {
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i) points.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    const Ball ball = min_ball(points);
    EXPECT_NEAR(ball.radius, std::sqrt(3.0) / 2, 1e-15);
}

TEST(MinBall, MatchesBruteForceOnACircleAndOnANearlyFlatOne) {
    for (const double height : {0.0, 1e-15, 1e-9, 1e-4}) {
        std::vector<Vec3> points;
        for (int k = 0; k < 12; ++k)
            points.emplace_back(std::cos(k * M_PI / 6), std::sin(k * M_PI / 6),
                                k % 2 == 0 ? height : 0);
        expect_minimal(points);
    }
}

TEST(MinBall, MatchesBruteForceOnNearlyRightAngledTriangles) {
    // The third corner is off the ball of the other two by less than its square root can tell.
    for (const double off : {1e-7, 1e-8, 1e-9, 1e-10, -1e-8}) {
        std::vector<Vec3> points = {{1, 0, 0}, {-1, 0, 0}, {0, 1 + off, 0}};
        const double exact = off < 0 ? 1 : ((1 + off) * (1 + off) + 1) / (2 * (1 + off));
        std::sort(points.begin(), points.end(),
                  [](const Vec3& a, const Vec3& b) { return a[0] < b[0]; });
        for (int order = 0; order < 6; ++order) {
            EXPECT_NEAR(min_ball(points).radius, exact, 1e-12) << off;
            std::next_permutation(points.begin(), points.end(),
                                  [](const Vec3& a, const Vec3& b) { return a[0] < b[0]; });
        }
    }
}

TEST(MinBall, ScalesFromTinyToHuge) {
    Random random(15);
    const std::vector<Vec3> points = random_points(random, 10);
    const double radius = min_ball(points).radius;
    for (const double scale : {1e-60, 1e-20, 1e20, 1e60}) {
        std::vector<Vec3> scaled;
        for (const Vec3& p : points) scaled.push_back(scale * p);
        EXPECT_NEAR(min_ball(scaled).radius / scale, radius, 1e-12 * radius);
    }
}

TEST(MinBall, OfNothingIsAPoint) { EXPECT_EQ(min_ball(std::vector<Vec3>{}).radius, 0); }

TEST(RitterBall, ContainsAllAndIsSeldomSmallest) {
    Random random(16);
    double excess = 0;
    for (int i = 0; i < 200; ++i) {
        const std::vector<Vec3> points = random_points(random, 100);
        const Ball ritter = fit_ball(points, {.ball_method = BallMethod::ritter});
        for (const Vec3& p : points) EXPECT_TRUE(contains(ritter, p));
        const double ratio = ritter.radius / min_ball(points).radius;
        EXPECT_GE(ratio, 1 - 1e-12);
        EXPECT_LE(ratio, 1.3);
        excess += ratio - 1;
    }
    EXPECT_GT(excess / 200, 0.005);
}

}  // namespace
}  // namespace scb
