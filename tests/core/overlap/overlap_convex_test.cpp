#include "core/overlap/overlap_convex.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/overlap/overlap_obb.h"
#include "core/volumes/convex_shape.h"
#include "scb/volume.h"
#include "tests/core/overlap/convex_pairs.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

constexpr int many = unless_sanitized(20000, 1000);

template <class V>
class Convex : public testing::Test {};
using ConvexTypes = testing::Types<KDop14, KDop18, KDop26, Rss, Capsule>;
TYPED_TEST_SUITE(Convex, ConvexTypes);

/// The placement of two volumes for B at the pose.
template <class V>
Placement placed_pair(const V& a, const V& b, const Pose& b_to_a) {
    return placement(b_to_a, reach(a), reach(b));
}

/// A lower bound of the distance, by 218 directions; negative where none of them separates.
template <class V>
double sampled_gap(const V& a, const V& b, const Pose& b_to_a) {
    static const DirectionGrid grid = direction_grid(6);
    const Vec3 to_b = transform_point(b_to_a, center(b)) - center(a);
    const Mat3& r = b_to_a.rotation;
    double most = -HUGE_VAL;
    for (const Vec3& d : grid.directions) {
        const Vec3 in_b(-dot(Vec3(r.col(0)), d), -dot(Vec3(r.col(1)), d), -dot(Vec3(r.col(2)), d));
        most = std::max(most, dot(d, to_b) - support(a, d) - support(b, in_b));
    }
    return most;
}

TYPED_TEST(Convex, HoldsThePointsThatItIsFittedTo) {
    Random random(1);
    for (int i = 0; i < many / 10; ++i) {
        const std::vector<Vec3> points = random_cloud(random);
        const auto v = fitted<TypeParam>(points);
        EXPECT_TRUE(is_well_formed(v));
        for (const Vec3& p : points) ASSERT_TRUE(contains(v, p)) << i;
        EXPECT_GE(surface_area(v), 0);
        EXPECT_GE(volume(v), -1e-15);
    }
}

// What `contains` says and what the farthest points say are one set.
TYPED_TEST(Convex, EndsAtItsFarthestPoints) {
    Random random(2);
    for (int i = 0; i < many / 10; ++i) {
        const auto v = fitted<TypeParam>(random_cloud(random));
        // Also along its own axes, near which there is least to go by.
        Vec3 d = random_unit_vector(random);
        if (i % 3 == 1) d = Vec3::Unit(i / 3 % 3);
        if (i % 3 == 2) {
            const auto points = random_cloud(random);
            const Vec3 side = points.back() - center(v);
            if (squared_norm(side) > 0) d = side / std::sqrt(squared_norm(side));
        }
        const Vec3 end = center(v) + support_point(v, d) + rounding(v) * d;
        const double size = diameter(v);
        EXPECT_NEAR(dot(d, Vec3(end - center(v))), support(v, d), 1e-12 * (size + 1));
        EXPECT_FALSE(contains(v, Vec3(end + (1e-9 + 1e-9 * size) * d))) << i;
        // No point of it is farther.
        for (int k = 0; k < 20; ++k) {
            const Vec3 p = center(v) + size * random_point(random);
            if (!contains(v, p)) continue;
            EXPECT_LE(dot(d, Vec3(p - center(v))), support(v, d) + 1e-12 * (size + 1));
        }
        EXPECT_LE(std::sqrt(squared_norm(end)), reach(v) * (1 + 1e-12) + 1e-12);
    }
}

TYPED_TEST(Convex, IsSeparatedWhereADirectionSeparates) {
    Random random(3);
    int apart = 0, together = 0;
    for (int i = 0; i < many; ++i) {
        const std::vector<Vec3> of_a = random_cloud(random), of_b = random_cloud(random);
        const auto a = fitted<TypeParam>(of_a), b = fitted<TypeParam>(of_b);
        const Pose pose = random_pose(random);
        const Placement placed = placed_pair(a, b, pose);
        const bool rejected = overlap_convex(a, b, placed) != Stage::overlapping;
        if (sampled_gap(a, b, pose) > placed.margin) {
            ++apart;
            EXPECT_TRUE(rejected) << i;
        }
        // A common point: never rejected.
        for (const Vec3& p : of_b) {
            if (!contains(a, transform_point(pose, p))) continue;
            ++together;
            EXPECT_FALSE(rejected) << i;
            break;
        }
    }
    EXPECT_GT(apart, many / 10);
    EXPECT_GT(together, many / 100);
}

// Moved along a direction until the two touch: kept there, and rejected a little farther away.
TYPED_TEST(Convex, IsKeptWhereItTouches) {
    Random random(4);
    int rejected = 0;
    for (int i = 0; i < many; ++i) {
        const auto a = fitted<TypeParam>(random_cloud(random)),
                   b = fitted<TypeParam>(random_cloud(random));
        Pose pose = random_pose(random);
        const Vec3 d = random_unit_vector(random);
        const Vec3 in_b = rotate(Mat3(pose.rotation.transpose()), Vec3(-d));
        const Vec3 end_a = center(a) + support_point(a, d) + rounding(a) * d;
        const Vec3 end_b = center(b) + support_point(b, in_b) + rounding(b) * in_b;
        pose.translation += end_a - transform_point(pose, end_b);
        EXPECT_EQ(overlap_convex(a, b, placed_pair(a, b, pose)), Stage::overlapping) << i;
        pose.translation += 1e-7 * d;
        if (overlap_convex(a, b, placed_pair(a, b, pose)) != Stage::overlapping) ++rejected;
    }
    // Exact up to rounding: nearly all pairs are rejected.
    EXPECT_GE(rejected, many - many / 1000);
}

TEST(KDop, OfABoxIsTestedAsTheBoxIs) {
    Random random(5);
    int rejected = 0;
    for (int i = 0; i < many; ++i) {
        const auto box = [&] {
            std::vector<Vec3> corners;
            const Vec3 middle = random_point(random);
            const Vec3 half(random.uniform(0.01, 0.7), random.uniform(0.01, 0.7),
                            random.uniform(0.01, 0.7));
            for (int c = 0; c < 8; ++c)
                corners.push_back(middle + Vec3((c & 1 ? 1 : -1) * half[0],
                                                (c & 2 ? 1 : -1) * half[1],
                                                (c & 4 ? 1 : -1) * half[2]));
            return std::pair(fitted<KDop26>(corners), ExactAabb{middle, half});
        };
        const auto [dop_a, box_a] = box();
        const auto [dop_b, box_b] = box();
        const Placement placed = placed_pair(dop_a, dop_b, random_pose(random));
        const bool expected = overlap_aabb(box_a, box_b, placed) != Stage::overlapping;
        rejected += expected;
        EXPECT_EQ(overlap_convex(dop_a, dop_b, placed) != Stage::overlapping, expected) << i;
    }
    EXPECT_GT(rejected, many / 10);
}

TEST(KDop, HasTheFarthestOfAllItsCorners) {
    Random random(6);
    for (int i = 0; i < many / 20; ++i) {
        const auto v = fitted<KDop26>(random_cloud(random));
        // Each corner is where three faces meet, and beyond no other.
        std::vector<Vec3> normals;
        std::vector<double> offsets;
        for (std::size_t k = 0; k < v.which.size(); ++k) {
            const auto& d = dop_directions[static_cast<std::size_t>(v.which[k])];
            const Vec3 n(d[0], d[1], d[2]);
            normals.push_back(n);
            offsets.push_back(v.upper[k]);
            normals.push_back(-n);
            offsets.push_back(-v.lower[k]);
        }
        std::vector<Vec3> corners;
        for (std::size_t p = 0; p < normals.size(); ++p)
            for (std::size_t q = 0; q < p; ++q)
                for (std::size_t r = 0; r < q; ++r) {
                    Mat3 m;
                    m << normals[p].transpose(), normals[q].transpose(), normals[r].transpose();
                    if (std::abs(m.determinant()) < 0.5) continue;
                    const Vec3 x = m.inverse() * Vec3(offsets[p], offsets[q], offsets[r]);
                    bool inside = true;
                    for (std::size_t k = 0; k < normals.size() && inside; ++k)
                        inside = dot(normals[k], x) <= offsets[k] + 1e-12;
                    if (inside) corners.push_back(x);
                }
        ASSERT_FALSE(corners.empty());
        for (int k = 0; k < 10; ++k) {
            const Vec3 d = random_unit_vector(random);
            double most = -HUGE_VAL;
            for (const Vec3& x : corners) most = std::max(most, dot(d, Vec3(x - center(v))));
            EXPECT_NEAR(support(v, d), most, 1e-11) << i;
        }
    }
}

TEST(KDop, HasAreaAndVolumeOfKnownPolytopes) {
    std::vector<Vec3> corners;
    for (int c = 0; c < 8; ++c) corners.push_back({(c & 1) * 2.0, (c & 2) * 1.5, (c & 4) * 0.25});
    const auto box = fitted<KDop26>(corners);  // 2 x 3 x 1
    EXPECT_NEAR(surface_area(box), 22, 1e-12);
    EXPECT_NEAR(volume(box), 6, 1e-12);
    // An octahedron has the faces of the 14-DOP's corners.
    const auto octahedron = fitted<KDop14>({Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0),
                                            Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)});
    EXPECT_NEAR(surface_area(octahedron), 4 * std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(volume(octahedron), 4.0 / 3, 1e-12);
    // The 18-DOP of the same points holds more: the box is cut along its edges only.
    EXPECT_GT(volume(fitted<KDop18>({Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                                     Vec3(0, 0, 1), Vec3(0, 0, -1)})),
              4.0 / 3 + 0.1);
}

/// The distance of two segments with these ends, by Ericson's case analysis on the square of
/// parameters: the least over its inside and its four sides.
double segment_distance(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
    const auto at = [&](double s, double t) { return (p + s * u - q - t * v).norm(); };
    const auto on = [](double x) { return std::clamp(x, 0.0, 1.0); };
    const auto nearest = [&](const Vec3& from, const Vec3& origin, const Vec3& along) {
        const double length = along.squaredNorm();
        return length > 0 ? on((from - origin).dot(along) / length) : 0;
    };
    double least = HUGE_VAL;
    for (const double s : {0.0, 1.0}) least = std::min(least, at(s, nearest(p + s * u, q, v)));
    for (const double t : {0.0, 1.0}) least = std::min(least, at(nearest(q + t * v, p, u), t));
    const double a = u.dot(u), b = u.dot(v), c = v.dot(v), d = u.dot(p - q), e = v.dot(p - q);
    const double determinant = a * c - b * b;
    if (determinant > 1e-14 * a * c) {
        const double s = (b * e - c * d) / determinant, t = (a * e - b * d) / determinant;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) least = std::min(least, at(s, t));
    }
    return least;
}

TEST(Capsule, IsTestedByTheDistanceOfItsSegments) {
    Random random(7);
    for (int i = 0; i < many; ++i) {
        const auto a = fitted<Capsule>(random_cloud(random)),
                   b = fitted<Capsule>(random_cloud(random));
        const Pose pose = random_pose(random);
        const Vec3 along_b = rotate(pose.rotation, b.half_axis),
                   middle_b = transform_point(pose, b.center);
        const double gap = segment_distance(a.center - a.half_axis, 2 * a.half_axis,
                                            middle_b - along_b, 2 * along_b) -
                           a.radius - b.radius;
        if (std::abs(gap) < 1e-12) continue;
        EXPECT_EQ(overlap_convex(a, b, placed_pair(a, b, pose)) != Stage::overlapping, gap > 0)
            << i << ", gap " << gap;
    }
}

TEST(Rss, IsTestedByTheDistanceOfItsRectangles) {
    Random random(8);
    for (int i = 0; i < many / 4; ++i) {
        const auto a = fitted<Rss>(random_cloud(random)), b = fitted<Rss>(random_cloud(random));
        const Pose pose = random_pose(random);
        Rss placed_b = b;
        placed_b.center = transform_point(pose, b.center);
        for (Vec3& side : placed_b.half_sides) side = rotate(pose.rotation, side);
        // Two rectangles are closest at a corner of one, or where two edges are, or they cross.
        double least = HUGE_VAL;
        const auto edges = [](const Rss& v) {
            const auto& [s, t] = v.half_sides;
            return std::vector<std::pair<Vec3, Vec3>>{{v.center - s - t, 2 * s},
                                                      {v.center - s + t, 2 * s},
                                                      {v.center - s - t, 2 * t},
                                                      {v.center + s - t, 2 * t}};
        };
        for (const auto& [p, u] : edges(a))
            for (const auto& [q, v] : edges(placed_b))
                least = std::min(least, segment_distance(p, u, q, v));
        const auto corners_and_crossings = [&](const Rss& of, const Rss& to) {
            const Vec3 normal = to.half_sides[0].cross(to.half_sides[1]);
            for (const auto& [p, u] : edges(of)) {
                for (const Vec3& end : {p, Vec3(p + u)})
                    least = std::min(least, std::sqrt(squared_distance(to, end)));
                const double from = normal.dot(p - to.center), by = normal.dot(u);
                if (!(by != 0 && from / by <= 0 && from / by >= -1)) continue;
                least = std::min(least, std::sqrt(squared_distance(to, p - from / by * u)));
            }
        };
        corners_and_crossings(a, placed_b);
        corners_and_crossings(placed_b, a);
        const double gap = least - a.radius - b.radius;
        if (std::abs(gap) < 1e-11) continue;
        EXPECT_EQ(overlap_convex(a, b, placed_pair(a, b, pose)) != Stage::overlapping, gap > 0)
            << i << ", gap " << gap;
    }
}

TEST(Capsule, HasAreaAndVolume) {
    const Capsule capsule{Vec3::Zero(), Vec3(0, 0, 2), 0.5};
    EXPECT_NEAR(surface_area(capsule), M_PI * (4 + 1), 1e-12);
    EXPECT_NEAR(volume(capsule), M_PI * (1 + 1.0 / 6), 1e-12);
}

TEST(Rss, HasAreaAndVolume) {
    const Rss plate{Vec3::Zero(), {Vec3(2, 0, 0), Vec3(0, 1, 0)}, 0.5};
    EXPECT_NEAR(surface_area(plate), 2 * 8 + 12 * M_PI * 0.5 + 4 * M_PI * 0.25, 1e-12);
    EXPECT_NEAR(volume(plate), 8 + 12 * M_PI * 0.125 + M_PI / 6, 1e-12);
}

}  // namespace
}  // namespace scb
