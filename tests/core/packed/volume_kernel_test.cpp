#include "core/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/packed/volume_kernel_test.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/packed/volume_kernel-inl.h"
#include "tests/core/packed/kernel_pairs.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Whether the kernel lets a pair overlap with a margin of so many units, which is distance_bound
/// where they are negative.
bool overlap_within(const NodePair& pair, const Placement& placement, float units) {
    constexpr int n = part_lanes(4);
    const FloatPlacement in_floats(placement);
    const Offset o = offset(in_floats, pair.origin_a, pair.reach_a, pair.origin_b, pair.reach_b);
    const LaneScbs<n> b = placed(LaneScbs<n>::all(pair.b), in_floats, Lanes3<n>::all(o.t));
    const float margin =
        (units < 0 ? distance_bound : units) * float_unit * o.length + in_floats.double_error;
    return overlap(LaneScbs<n>::all(pair.a), b, Lanes<n>::all(margin)).bits() % 2 != 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

HWY_EXPORT(overlap_within);

Vec3 wide(const float* x) {
    return {static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2])};
}

/// What the kernel computes, in doubles and without a margin.
bool overlap_in_doubles(const NodePair& pair, const Pose& b_to_a) {
    const Vec3 c = transform_point(b_to_a, Vec3(wide(pair.origin_b) + wide(pair.b.c))) -
                   (wide(pair.origin_a) + wide(pair.a.c)),
               normal_a = wide(pair.a.n), normal_b = rotate(b_to_a.rotation, wide(pair.b.n));
    const double r_a = static_cast<double>(pair.a.r), r_b = static_cast<double>(pair.b.r),
                 m_a = static_cast<double>(pair.a.m), m_b = static_cast<double>(pair.b.m),
                 h_a = static_cast<double>(pair.a.h), h_b = static_cast<double>(pair.b.h);
    const double d0 = dot(normal_a, c) - m_a, d1 = dot(normal_b, c) + m_b,
                 cosine = dot(normal_a, normal_b), tilt = std::abs(cosine),
                 sine = std::sqrt(squared_norm(Vec3(cross(normal_a, normal_b))));
    return squared_norm(c) <= (r_a + r_b) * (r_a + r_b) && std::abs(d0) - h_a <= r_b &&
           std::abs(d1) - h_b <= r_a &&
           std::abs(d0 + m_b * cosine) - h_a - h_b * tilt <= r_b * sine &&
           std::abs(d1 - m_a * cosine) - h_b - h_a * tilt <= r_a * sine;
}

/// Of any size, thickness and place in a node of size 1.
PackedScb random_volume(Random& random, const Vec3& normal) {
    PackedScb v;
    const double r = std::ldexp(random.uniform(0.5, 1), -static_cast<int>(random.below(14)));
    const double m = r * random.uniform(-0.9, 0.9);
    const Vec3 c = (1 - r) * random_point(random);
    for (int i = 0; i < 3; ++i) {
        v.c[i] = static_cast<float>(c[i]);
        v.n[i] = static_cast<float>(normal[i]);
    }
    v.r = static_cast<float>(r);
    v.m = static_cast<float>(m);
    v.h = static_cast<float>(std::ldexp(r - std::abs(m), -static_cast<int>(random.below(20))));
    return v;
}

// Pairs that just overlap in doubles do in floats, within the bound; within half a unit some do
// not. The bound adds up what is never all there: no pair needed more than one unit.
TEST(VolumeKernel, DistancesAreWithinTheirBound) {
#ifdef SCB_SANITIZED
    constexpr int pairs_tried = 10000;
#else
    constexpr int pairs_tried = 100000;
#endif
    Random random(91);
    int missed_within_half = 0;
    for (int i = 0; i < pairs_tried; ++i) {
        const double far = i % 4 == 0 ? 1e4 : 1;
        const Mat3 turn = random_rotation(random);
        const Vec3 normal = random_rotation(random).col(0);
        Vec3 other = random_rotation(random).col(0);
        // Nearly parallel slabs as well.
        if (i % 3 == 0)
            other = (normal + std::ldexp(1.0, -static_cast<int>(random.below(24))) * other)
                        .normalized();
        NodePair pair{random_volume(random, normal),
                      random_volume(random, turn.transpose() * other),
                      {},
                      {},
                      1,
                      1};
        for (int k = 0; k < 3; ++k) {
            pair.origin_a[k] = static_cast<float>(far * random.uniform(-1, 1));
            pair.origin_b[k] = static_cast<float>(far * random.uniform(-1, 1));
        }
        const Vec3 origin_a = wide(pair.origin_a), origin_b = wide(pair.origin_b);
        Pose pose{turn, Vec3(origin_a - turn * origin_b)};
        // The farthest in some direction where they still overlap.
        const Vec3 start = pose.translation, direction = random_rotation(random).col(0);
        double near = -4, apart = 4;
        const auto at = [&](double s) {
            pose.translation = start + s * direction;
            return overlap_in_doubles(pair, pose);
        };
        for (double s = -3; s <= 3; s += 1.0 / 32)
            if (at(s)) near = s;
        if (near == -4) continue;
        for (int k = 0; k < 60; ++k) (at((near + apart) / 2) ? near : apart) = (near + apart) / 2;
        ASSERT_TRUE(at(near));
        const Placement placed = placement(pose, 2 * far + 1, 2 * far + 1);
        for (const SimdLevel level : available_simd_levels()) {
            const auto within = [&](float units) {
                return SCB_AT_LEVEL(overlap_within, level)(pair, placed, units);
            };
            EXPECT_TRUE(within(-1)) << i << simd_level_name(level);
            if (!within(0.5f)) ++missed_within_half;
        }
    }
    EXPECT_GT(missed_within_half, 0);
}

}  // namespace
}  // namespace scb
#endif
