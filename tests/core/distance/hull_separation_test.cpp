#include "core/distance/hull_separation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/distance/precise_features.h"
#include "scb/triangle_distance.h"
#include "tests/core/geometry/triangle_pairs.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

TriangleCorners some_triangle(Random& random, const Vec3& from) {
    return {Vec3(from + random_point(random)), Vec3(from + random_point(random)),
            Vec3(from + random_point(random))};
}

TEST(HullSeparations, AreRightAboutTwoTriangles) {
    Random random(13);
    std::array<int, 3> counts{};
    for (int i = 0; i < 5'000 / effort; ++i) {
        const TriangleCorners a = some_triangle(random, Vec3::Zero()),
                              b = some_triangle(random, 2 * random_point(random));
        const double distance = triangle_distance(a, b).distance;
        for (const double share : {0.5, 0.99, 1 - 1e-9, 1 + 1e-9, 1.01, 2.0}) {
            const double enough = std::max(distance, 1e-6) * share;
            const HullSeparation found = separate_hulls(a, b, random_unit_vector(random), enough);
            ++counts[static_cast<std::size_t>(found.verdict)];
            EXPECT_EQ(found.verdict, distance >= enough ? HullVerdict::apart : HullVerdict::nearer)
                << i << " " << share << " " << distance;
            if (found.verdict != HullVerdict::apart) continue;
            double gap = HUGE_VAL;
            for (const Vec3& p : a)
                for (const Vec3& q : b) gap = std::min(gap, dot(found.direction, Vec3(q - p)));
            EXPECT_GE(gap / found.direction.norm(), enough * (1 - 1e-12));
        }
    }
    EXPECT_GT(counts[static_cast<std::size_t>(HullVerdict::apart)], 5'000 / effort);
    EXPECT_GT(counts[static_cast<std::size_t>(HullVerdict::nearer)], 5'000 / effort);
}

TEST(PreciseFeaturesOfTriangles, HaveTheDistanceOfTheTriangles) {
    Random random(19);
    for (int i = 0; i < 5'000 / effort; ++i) {
        const TriangleCorners a = some_triangle(random, Vec3::Zero()),
                              b = some_triangle(random, 2 * random_point(random));
        const double distance = triangle_distance(a, b).distance;
        if (distance == 0) continue;
        const PreciseFeatures found = precise_features(a, b).front();
        Vec3 p = Vec3::Zero(), q = Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            p += found.weights_a[k] * a[k];
            q += found.weights_b[k] * b[k];
        }
        EXPECT_NEAR((q - p).norm(), distance, 3e-15);
        EXPECT_NEAR(dot(found.direction, Vec3(q - p)) / found.direction.norm(), distance, 4e-15);
    }
}

}  // namespace
}  // namespace scb
