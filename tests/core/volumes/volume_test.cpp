#include "scb/volume.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scb/fit.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

Scb random_scb_somewhere(Random& random, bool keeps_center) {
    const Vec3 normal = random_unit_vector(random);
    Scb s = random_centered_scb(random, normal);
    if (!keeps_center) s = with_center_left_out(random, s);
    s.c = random_point(random);
    return s;
}

// The share of a volume's bounding cube that is inside, times the cube: an estimate that shares
// nothing with the formula.
template <class V>
double monte_carlo_volume(const V& v, const Vec3& center, double reach, Random& random) {
    constexpr int samples = 400000;
    int inside = 0;
    for (int i = 0; i < samples; ++i)
        inside += contains(v, Vec3(center + reach * random_point(random)));
    return 8 * reach * reach * reach * inside / samples;
}

// Cauchy-Crofton: the area of a surface is proportional to the mean number of times that random
// lines cross it.
double crofton_area(const Scb& s, Random& random) {
    constexpr int samples = 400000;
    long crossings = 0;
    for (int i = 0; i < samples; ++i) {
        // Lines through two uniform points of a sphere have the invariant measure.
        const Vec3 a = s.c + s.r * random_unit_vector(random),
                   b = s.c + s.r * random_unit_vector(random);
        // The SCB is convex: a line crosses its boundary twice or not at all. Clip the chord by the
        // slab.
        const double ha = dot(s.n, Vec3(a - s.c)), hb = dot(s.n, Vec3(b - s.c));
        if (std::max(ha, hb) >= s.f && std::min(ha, hb) <= s.e) crossings += 2;
    }
    // The sphere itself has two crossings per line and area 4 pi r^2.
    return 4 * M_PI * s.r * s.r * static_cast<double>(crossings) / (2.0 * samples);
}

TEST(ScbVolume, MatchesMonteCarloWithAndWithoutItsCenter) {
    Random random(1);
    for (int i = 0; i < 12; ++i) {
        const Scb s = random_scb_somewhere(random, i % 2 == 0);
        const double cube = 8 * s.r * s.r * s.r;
        EXPECT_NEAR(volume(s), monte_carlo_volume(s, s.c, s.r, random), 0.005 * cube);
    }
}

TEST(ScbArea, MatchesLineCrossings) {
    Random random(2);
    for (int i = 0; i < 12; ++i) {
        const Scb s = random_scb_somewhere(random, i % 2 == 0);
        EXPECT_NEAR(surface_area(s), crofton_area(s, random), 0.005 * 4 * M_PI * s.r * s.r);
    }
}

TEST(ScbFormulas, AgreeWithTheBallWhereNothingIsCut) {
    const Scb s{Vec3(1, 2, 3), 1.5, Vec3::UnitX(), 1.5, -1.5};
    const Ball b{s.c, s.r};
    EXPECT_DOUBLE_EQ(surface_area(s), surface_area(b));
    EXPECT_DOUBLE_EQ(volume(s), volume(b));
}

TEST(BallVolume, MatchesMonteCarlo) {
    Random random(3);
    const Ball b{Vec3(1, -2, 0.5), 1.3};
    EXPECT_NEAR(volume(b), monte_carlo_volume(b, b.center, 1.3, random), 0.01 * volume(b));
}

TEST(ObbVolume, MatchesMonteCarlo) {
    Random random(4);
    const Obb box = fit_obb(random_points(random, 200, 0.4));
    EXPECT_NEAR(volume(box), monte_carlo_volume(box, box.center, box.half.norm(), random),
                0.02 * volume(box));
}

// The extent against the farthest of many points of the volume: inside samples never exceed it, and
// samples of the surface reach it.
template <class V>
void expect_extent_is_a_supremum(const V& v, const Vec3& center, double reach,
                                 const std::vector<Vec3>& surface, Random& random) {
    for (int k = 0; k < 40; ++k) {
        const Vec3 d = random_unit_vector(random);
        const double bound = support(v, d);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 p = center + reach * random_point(random);
            if (!contains(v, p)) continue;
            EXPECT_LE(dot(d, Vec3(p - center)), bound + 1e-12);
        }
        double farthest = -1e9;
        for (const Vec3& p : surface) farthest = std::max(farthest, dot(d, Vec3(p - center)));
        EXPECT_NEAR(farthest, bound, 2e-3 * reach);
    }
}

// Points all over the zone and the rims.
std::vector<Vec3> surface_of(const Scb& s) {
    const Vec3 u = cross(s.n, Vec3(std::abs(s.n[0]) < 0.5 ? Vec3::UnitX() : Vec3::UnitY()))
                       .normalized(),
               v = cross(s.n, u);
    std::vector<Vec3> points;
    for (int i = 0; i <= 200; ++i) {
        const double h = s.f + (s.e - s.f) * i / 200,
                     radius = std::sqrt(std::max(0.0, s.r * s.r - h * h));
        for (int k = 0; k < 200; ++k)
            points.push_back(s.c + h * s.n +
                             radius *
                                 (std::cos(k * M_PI / 100) * u + std::sin(k * M_PI / 100) * v));
    }
    return points;
}

TEST(Extent, IsReachedAndNeverExceeded) {
    Random random(5);
    for (int i = 0; i < 8; ++i) {
        const Scb s = random_scb_somewhere(random, i % 2 == 0);
        expect_extent_is_a_supremum(s, s.c, s.r, surface_of(s), random);
    }
    const Obb box = fit_obb(random_points(random, 50));
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(
            box.center +
            box.axes * box.half.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    expect_extent_is_a_supremum(box, box.center, box.half.norm(), corners, random);
    const Ball ball = fit_ball(random_points(random, 50));
    expect_extent_is_a_supremum(
        ball, ball.center, ball.radius,
        surface_of({ball.center, ball.radius, Vec3::UnitZ(), ball.radius, -ball.radius}), random);
}

TEST(ScbExtent, IsExactAlongTheNormalAndOnTheRim) {
    const Scb s{Vec3::Zero(), 5, Vec3::UnitZ(), 3, -4};
    EXPECT_DOUBLE_EQ(support(s, Vec3::UnitZ()), 3);
    EXPECT_DOUBLE_EQ(support(s, -Vec3::UnitZ()), 4);
    EXPECT_DOUBLE_EQ(support(s, Vec3::UnitX()), 5);
    // The rim of the upper cut is the circle of radius 4 at height 3.
    const Vec3 d = Vec3(1, 0, 2) / std::sqrt(5.0);
    EXPECT_NEAR(support(s, d), (4 + 2 * 3) / std::sqrt(5.0), 1e-14);
}

TEST(ScbExtent, DoesNotChangeWhenTheNormalIsFlipped) {
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const Scb s = random_scb_somewhere(random, i % 2 == 0);
        const Vec3 d = random_unit_vector(random);
        EXPECT_EQ(support(s, d), support(flipped(s), d));
        EXPECT_DOUBLE_EQ(volume(s), volume(flipped(s)));
        EXPECT_EQ(contains(s, d), contains(flipped(s), d));
    }
}

}  // namespace
}  // namespace scb
