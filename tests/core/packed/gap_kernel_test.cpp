#include "tests/core/packed/gap_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "scb/placement.h"
#include "tests/core/packed/random_scbs.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

/// Directions in which gaps are measured, and others, in the frame of the volume.
Vec3 some_direction(const Scb& v, Random& random) {
    return random.below(2) == 0 ? v.n : random_unit_vector(random);
}
Vec3 some_direction(const Scb2& v, Random& random) {
    const std::uint32_t kind = random.below(4);
    return kind < 2 ? v.slabs[kind].n : kind == 2 ? long_axis(v) : random_unit_vector(random);
}

/// Of some points of the volume the farthest.
template <class V>
Vec3 far_point(const V& v, const Vec3& direction, Random& random) {
    Vec3 farthest = point_of(v, random);
    for (int k = 0; k < 12; ++k) {
        const Vec3 other = point_of(v, random);
        if (dot(direction, other) > dot(direction, farthest)) farthest = other;
    }
    return farthest;
}

template <class Packed>
float reach_of(const Packed& v) {
    return static_cast<float>(1.001 * std::sqrt(squared_norm(center(v)))) + v.r;
}

// B is moved so that two points, most often of the surfaces that face each other, have a known
// distance, from a millionth of the size up to far away. The bound is never above it, is close to
// it on the whole, and would be above it without a margin.
template <class V>
void expect_bounds_below_distances(double most_lost) {
    constexpr int pairs_tried = unless_sanitized(40000, 4000);
    Random random(93);
    int positive = 0, too_large = 0;
    double bounds = 0, distances = 0;
    for (int i = 0; i < pairs_tried; ++i) {
        const V a = some_volume<V>(random, std::ldexp(1.0, -static_cast<int>(random.below(8))));
        const V b = some_volume<V>(random, std::ldexp(1.0, -static_cast<int>(random.below(8))));
        Pose pose;
        // Frames that are nearly the same leave slabs nearly as parallel as they are.
        if (i % 4 != 0) pose.rotation = random_rotation(random);
        const Mat3 back = pose.rotation.transpose();
        const Vec3 direction = random.below(2) == 0
                                   ? some_direction(a, random)
                                   : rotate(pose.rotation, some_direction(b, random));
        const double distance = std::pow(10, random.uniform(-6, 1.5));
        pose.translation =
            far_point(a, direction, random) + distance * direction -
            rotate(pose.rotation, far_point(b, Vec3(-rotate(back, direction)), random));
        const auto packed_a = packed(a, Vec3::Zero()), packed_b = packed(b, Vec3::Zero());
        const VolumesOfNodes<std::decay_t<decltype(packed_a)>> pair{
            packed_a, packed_b, {}, {}, reach_of(packed_a), reach_of(packed_b)};
        const Placement placed = placement(pose, 4 * scb::reach(a), 4 * scb::reach(b));
        const float best = gap_key(SimdLevel::best, pair, placed, -1);
        ASSERT_LE(static_cast<double>(best), distance) << i;
        for (const SimdLevel level : available_simd_levels())
            ASSERT_EQ(gap_key(level, pair, placed, -1), best) << i << simd_level_name(level);
        too_large += static_cast<double>(gap_key(SimdLevel::best, pair, placed, 0)) > distance;
        positive += best > 0;
        bounds += std::max(0.0, static_cast<double>(best));
        distances += distance;
    }
    EXPECT_GT(positive, pairs_tried / 3);
    // Few pairs need one.
    EXPECT_GE(too_large, unless_sanitized(1, 0)) << "is a margin needed?";
    EXPECT_GT(bounds, (1 - most_lost) * distances) << "the bounds are weak";
}

TEST(GapKernel, OneSlabIsNeverAboveTheDistanceOfTwoPoints) {
    expect_bounds_below_distances<Scb>(0.1);
}
TEST(GapKernel, TwoSlabsAreNeverAboveTheDistanceOfTwoPoints) {
    expect_bounds_below_distances<Scb2>(0.1);
}

// Balls that overlap more come first.
TEST(GapKernel, OrdersVolumesThatOverlap) {
    PackedScb v;
    v.r = v.h = 1;
    const VolumesOfNodes<PackedScb> pair{v, v, {}, {}, 1, 1};
    float before = -3;
    for (const double x : {0.0, 0.1, 1.0, 1.9, 2.1, 1e3}) {
        const Pose pose{Mat3::Identity(), Vec3(x, 0, 0)};
        const float key = gap_key(SimdLevel::best, pair, placement(pose, 4, 4), -1);
        EXPECT_GT(key, before);
        EXPECT_EQ(key > 0, x > 2);
        before = key;
    }
    // Lengths whose squares overflow count as no bound.
    const Pose far{Mat3::Identity(), Vec3(1e30, 0, 0)};
    EXPECT_EQ(gap_key(SimdLevel::best, pair, placement(far, 4, 4), -1), 0);
}

}  // namespace
}  // namespace scb
