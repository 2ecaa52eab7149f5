#include "scb/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/fit/dop26.h"
#include "core/fit/min_ball.h"
#include "scb/error.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

double width_along(const std::vector<Vec3>& points, const Vec3& n) {
    double lower = 1e300, upper = -1e300;
    for (const Vec3& p : points) {
        lower = std::min(lower, dot(n, p));
        upper = std::max(upper, dot(n, p));
    }
    return upper - lower;
}

// The width of a point set: the narrowest slab has a face of the hull in one plane, or an edge in
// each (Houle and Toussaint), so all planes through three points and all pairs of parallel planes
// through two edges are tried.
double minimum_width(const std::vector<Vec3>& points) {
    double best = 1e300;
    const auto consider = [&](const Vec3& normal) {
        const double length = normal.norm();
        if (length > 1e-12) best = std::min(best, width_along(points, normal / length));
    };
    const std::size_t n = points.size();
    std::vector<Vec3> edges;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j) edges.push_back(points[i] - points[j]);
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) consider(cross(edges[i], edges[j]));
    return best;
}

void expect_sound(const Scb& s, const std::vector<Vec3>& points) {
    for (const Vec3& p : points) ASSERT_TRUE(contains(s, p));
    EXPECT_NEAR(s.n.norm(), 1, 1e-15);
    EXPECT_LE(s.f, 0);
    EXPECT_GE(s.e, 0);
    EXPECT_LE(s.e, s.r);
    EXPECT_GE(s.f, -s.r);
}

TEST(FitScb, ContainsEveryPointExactly) {
    Random random(31);
    for (int i = 0; i < 2000; ++i) {
        const int count = 1 + static_cast<int>(random.below(200));
        const std::vector<Vec3> points =
            random_points(random, count, i % 4 == 0 ? 0 : random.uniform());
        expect_sound(fit_scb(points), points);
        expect_sound(fit_scb(points, {.growth = BallGrowth::radius}), points);
        const Ball ball = fit_ball(points);
        const Obb box = fit_obb(points);
        for (const Vec3& p : points) {
            ASSERT_TRUE(contains(ball, p));
            ASSERT_TRUE(contains(box, p));
        }
    }
}

// The tip of a pyramid that is half as high as it is wide is on the ball and on the slab's normal.
TEST(FitScb, ContainsATipThatTheSlabJustTouches) {
    Random random(36);
    for (int i = 0; i < 2000; ++i) {
        const double size = random.uniform(0.1, 1);
        const Vec3 c = random_point(random), tip = size * Vec3(1, 1, 1),
                   x = std::sqrt(1.5) * size * Vec3(1, -1, 0),
                   y = std::sqrt(0.5) * size * Vec3(1, 1, -2);
        const std::vector<Vec3> points = {c + x, c - x, c + y, c - y, c + tip};
        const Scb fitted = fit_scb(points);
        expect_sound(fitted, points);
        ASSERT_NEAR(fitted.e - fitted.f, fitted.r, 1e-14);
    }
}

TEST(FitScb, TakesEverySmallAndDegenerateSet) {
    Random random(32);
    for (const int count : {1, 2, 3, 7, 8, 9, 26, 27}) {
        const std::vector<Vec3> points = random_points(random, count);
        expect_sound(fit_scb(points), points);
        const std::vector<Vec3> same(static_cast<std::size_t>(count), Vec3(1, 2, 3));
        const Scb point = fit_scb(same);
        EXPECT_EQ(point.r, 0);
        EXPECT_EQ(point.c, Vec3(1, 2, 3));
        std::vector<Vec3> line;
        for (int i = 0; i < count; ++i) line.emplace_back(i, 2 * i, -i);
        const Scb segment = fit_scb(line);
        expect_sound(segment, line);
        EXPECT_NEAR(segment.e - segment.f, 0, 1e-14 * count);
        const Obb box = fit_obb(line);
        EXPECT_NEAR(box.half[1] + box.half[2], 0, 1e-13 * count);
    }
}

TEST(FitScb, IsFlatOnAPlanarPolygonAndATriangle) {
    Random random(33);
    for (int i = 0; i < 200; ++i) {
        const std::vector<Vec3> points = random_points(random, i % 2 == 0 ? 3 : 40, 0);
        const Scb s = fit_scb(points);
        expect_sound(s, points);
        EXPECT_LT(s.e - s.f, 1e-14);
    }
}

TEST(FitScb, HasTheSmallestBallUpTo26PointsAndIsCloseAbove) {
    Random random(34);
    double excess = 0;
    for (int i = 0; i < 300; ++i) {
        const int count = i < 100 ? 26 : 400;
        const std::vector<Vec3> points = random_points(random, count, random.uniform());
        const double ratio = fit_scb(points).r / min_ball(points).radius;
        if (count == 26)
            EXPECT_NEAR(ratio, 1, 1e-12);
        else
            excess += ratio - 1;
        EXPECT_LT(ratio, 1.15);
    }
    EXPECT_LT(excess / 200, 0.02);
}

TEST(FitScb, SlabIsCloseToTheMinimumWidth) {
    Random random(35);
    std::vector<double> ratios;
    for (int i = 0; i < 400; ++i) {
        const std::vector<Vec3> points =
            random_points(random, 4 + static_cast<int>(random.below(9)), random.uniform(0.02, 1));
        const Scb s = fit_scb(points);
        ratios.push_back((s.e - s.f) / minimum_width(points));
    }
    std::sort(ratios.begin(), ratios.end());
    const auto quantile = [&](double q) { return ratios[static_cast<std::size_t>(q * 399)]; };
    RecordProperty("slab_width_ratio_median", std::to_string(quantile(0.5)));
    RecordProperty("slab_width_ratio_90", std::to_string(quantile(0.9)));
    RecordProperty("slab_width_ratio_max", std::to_string(quantile(1)));
    std::printf("slab width / minimum width: median %.3f, 90 %% below %.3f, max %.3f\n",
                quantile(0.5), quantile(0.9), quantile(1));
    EXPECT_GE(ratios.front(), 1 - 1e-9);
    EXPECT_LT(quantile(0.5), 1.25);
    EXPECT_LT(quantile(1), 3);
}

TEST(FitScb, IsAtLeastAsNarrowAsEachSlabOfTheDop) {
    Random random(36);
    for (int i = 0; i < 200; ++i) {
        const std::vector<Vec3> points = random_points(random, 60);
        const Scb s = fit_scb(points);
        for (std::size_t d = 0; d < Dop26::directions; ++d) {
            const Vec3 n = dop26_directions[d] * dop26_directions.inverse_length[d];
            EXPECT_LE(s.e - s.f, width_along(points, n) + 1e-14);
        }
    }
}

TEST(FitScb, WorkGrowsLinearly) {
    Random random(37);
    for (const BallGrowth growth : {BallGrowth::radius, BallGrowth::ritter}) {
        double visits_per_point[2];
        for (int i = 0; i < 2; ++i) {
            const int count = i == 0 ? 2000 : 200000;
            FitCounts counts;
            fit_scb(random_points(random, count, 0.3), {.growth = growth, .counts = &counts});
            EXPECT_LE(counts.candidate_slabs, 13u);
            visits_per_point[i] = static_cast<double>(counts.point_visits) / count;
            // Some passes for the ball, at most one for each of 13 candidates and one for the slab
            // of the DOP.
            EXPECT_LE(visits_per_point[i], 18);
            EXPECT_GE(visits_per_point[i], 2);
        }
        EXPECT_LT(visits_per_point[1], 1.5 * visits_per_point[0]);
    }
}

TEST(FitScb, MarginWidensTheSlabWithinTheBall) {
    Random random(38);
    const std::vector<Vec3> points = random_points(random, 50, 0.1);
    const Scb exact = fit_scb(points), wide = fit_scb(points, {.margin = 0.01}),
              full = fit_scb(points, {.margin = 5});
    EXPECT_DOUBLE_EQ(wide.e, exact.e + 0.01 * exact.r);
    EXPECT_DOUBLE_EQ(wide.f, exact.f - 0.01 * exact.r);
    EXPECT_EQ(full.e, full.r);
    EXPECT_EQ(full.f, -full.r);
}

TEST(FitScb, FollowsAPermutationOfTheAxesAndAScale) {
    // Both keep the directions of the DOP; a general rotation keeps the ball alone.
    Random random(39);
    const std::vector<Vec3> points = random_points(random, 26, 0.2);
    const Scb s = fit_scb(points);
    const Vec3 axis = random_unit_vector(random);
    std::vector<Vec3> moved, turned;
    for (const Vec3& p : points) {
        moved.push_back(4 * Vec3(p[1], p[2], p[0]) + Vec3(1, -2, 3));
        turned.push_back(2 * dot(axis, p) * axis - p);  // half a turn
    }
    EXPECT_NEAR(fit_scb(moved).r, 4 * s.r, 1e-12);
    EXPECT_NEAR(thickness(fit_scb(moved)), 4 * thickness(s), 1e-12);
    EXPECT_NEAR(fit_scb(turned).r, s.r, 1e-12);
}

TEST(FitScb, IsWellFormedAtEveryScale) {
    Random random(43);
    for (const double scale : {1e-160, 1e-100, 1e-79, 1e-60, 1e-20, 1e20, 1e69}) {
        std::vector<Vec3> points;
        for (const Vec3& p : random_points(random, 40, 0.3)) points.push_back(scale * p);
        const Scb s = fit_scb(points);
        expect_sound(s, points);
        EXPECT_TRUE(is_well_formed(s)) << scale;
        EXPECT_TRUE(is_well_formed(fit_obb(points))) << scale;
    }
}

TEST(FitScb2, ContainsEveryPointExactly) {
    Random random(41);
    for (int i = 0; i < 2000; ++i) {
        const int count = 1 + static_cast<int>(random.below(200));
        const std::vector<Vec3> points =
            random_points(random, count, i % 4 == 0 ? 0 : random.uniform());
        for (const double margin : {0.0, 0.1}) {
            const Scb2 s = fit_scb2(points, {.margin = margin});
            EXPECT_TRUE(is_well_formed(s));
            for (const Vec3& p : points) ASSERT_TRUE(contains(s, p));
        }
    }
}

TEST(FitScb2, HasTheBallAndTheSlabOfAnScb) {
    Random random(42);
    for (int i = 0; i < 500; ++i) {
        const std::vector<Vec3> points = random_points(random, 2 + i, 0.3);
        const Scb one = fit_scb(points);
        const Scb2 two = fit_scb2(points);
        EXPECT_EQ(two.c, one.c);
        EXPECT_EQ(two.r, one.r);
        EXPECT_EQ(two.slabs[0].n, one.n);
        EXPECT_EQ(two.slabs[0].e, one.e);
        EXPECT_EQ(two.slabs[0].f, one.f);
        EXPECT_LE(surface_area(two), surface_area(one) * (1 + 1e-14));
    }
}

// Against all directions that an edge between two of the points, as the first normal sees it, has.
TEST(FitScb2, OfFewPointsHasTheNarrowestSecondSlab) {
    Random random(43);
    for (int i = 0; i < 300; ++i) {
        const std::vector<Vec3> points =
            random_points(random, 2 + static_cast<int>(random.below(25)), i % 3 == 0 ? 0 : 0.3);
        const Scb2 s = fit_scb2(points);
        const Vec3& n = s.slabs[0].n;
        double least = 1e300;
        for (const Vec3& p : points)
            for (const Vec3& q : points) {
                Vec3 edge = q - p;
                edge -= dot(n, edge) * n;
                if (!(edge.norm() > 1e-9)) continue;
                least = std::min(least, width_along(points, cross(n, edge).normalized()));
            }
        if (least == 1e300) continue;
        EXPECT_NEAR(width_along(points, s.slabs[1].n), least, 1e-12) << points.size();
    }
}

TEST(FitScb2, OfANeedleIsItsBoxButForTheEnds) {
    std::vector<Vec3> points;
    for (const double x : {-4.0, 4.0})
        for (const double y : {-0.2, 0.2})
            for (const double z : {-0.1, 0.1}) points.emplace_back(x, y, z);
    const Scb2 s = fit_scb2(points);
    EXPECT_NEAR(std::abs(long_axis(s)[0]), 1, 1e-15);
    EXPECT_NEAR(s.slabs[0].e, 0.1, 1e-15);
    EXPECT_NEAR(s.slabs[0].f, -0.1, 1e-15);
    EXPECT_NEAR(s.slabs[1].e, 0.2, 1e-15);
    EXPECT_NEAR(s.slabs[1].f, -0.2, 1e-15);
    EXPECT_LT(surface_area(s), surface_area(fit_scb(points)) / 8);
}

TEST(FitObb, FindsTheBoxOfABox) {
    Random random(40);
    Mat3 axes;
    axes.col(0) = random_unit_vector(random);
    axes.col(1) = cross(axes.col(0), random_unit_vector(random)).normalized();
    axes.col(2) = cross(axes.col(0), axes.col(1));
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(Vec3(1, 2, 3) +
                          axes * Vec3(i & 1 ? 3 : -3, i & 2 ? 2 : -2, i & 4 ? 1 : -1));
    const Obb box = fit_obb(corners);
    EXPECT_NEAR(volume(box), 8 * 6, 1e-9);
    EXPECT_NEAR((box.axes.transpose() * box.axes - Mat3::Identity()).norm(), 0, 1e-14);
    EXPECT_GT(box.axes.determinant(), 0);
}

TEST(Fit, RefusesNoPointsAndNamesTheOneThatIsNotFinite) {
    EXPECT_THROW(fit_scb({}), InputError);
    const std::vector<Vec3> points = {{0, 0, 0}, {0, std::nan(""), 0}};
    try {
        fit_ball(points);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("point 1 is not finite"), std::string::npos);
    }
}

}  // namespace
}  // namespace scb
