#include "core/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/packed/volume_kernel_test.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/packed/two_slab_kernel-inl.h"
#include "core/packed/volume_kernel-inl.h"
#include "tests/core/packed/kernel_pairs.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Whether the kernel lets a pair overlap with a margin of so many units, which is distance_bound
/// where they are negative.
template <class Packed>
bool within(const VolumesOfNodes<Packed>& pair, const Placement& placement, float units) {
    using L = LaneVolumes<Packed, part_lanes(4)>;
    const FloatPlacement in_floats(placement);
    const Offset o = offset(in_floats, pair.origin_a, pair.reach_a, pair.origin_b, pair.reach_b);
    const L b = placed(L::all(pair.b), in_floats, Lanes3<L::n>::all(o.t));
    const float margin =
        (units < 0 ? LaneVolumes<Packed, 1>::distance_bound : units) * float_unit * o.length +
        in_floats.double_error;
    return overlap(L::all(pair.a), b, Lanes<L::n>::all(margin)).bits() % 2 != 0;
}
bool one_slab_within(const VolumesOfNodes<PackedScb>& pair, const Placement& placed, float units) {
    return within(pair, placed, units);
}
bool two_slabs_within(const VolumesOfNodes<PackedScb2>& pair, const Placement& placed,
                      float units) {
    return within(pair, placed, units);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "scb/placement.h"
#include "tests/core/packed/random_scbs.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

HWY_EXPORT(one_slab_within);
HWY_EXPORT(two_slabs_within);

bool overlap_within(SimdLevel level, const VolumesOfNodes<PackedScb>& pair, const Placement& placed,
                    float units) {
    return SCB_AT_LEVEL(one_slab_within, level)(pair, placed, units);
}
bool overlap_within(SimdLevel level, const VolumesOfNodes<PackedScb2>& pair,
                    const Placement& placed, float units) {
    return SCB_AT_LEVEL(two_slabs_within, level)(pair, placed, units);
}

Vec3 wide(const float* x) {
    return {static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2])};
}

/// What the kernel computes, in doubles and without a margin.
bool overlap_in_doubles(const VolumesOfNodes<PackedScb>& pair, const Pose& b_to_a) {
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

/// The same of two slabs.
bool overlap_in_doubles(const VolumesOfNodes<PackedScb2>& pair, const Pose& b_to_a) {
    struct Wide {
        std::array<Vec3, 3> axis;
        double r, m[2], h[2];

        explicit Wide(const PackedScb2& from) : r(static_cast<double>(from.r)) {
            const std::array<Vec3, 2> n = normals(from);
            axis = {n[0], n[1], cross(n[0], n[1])};
            for (int i = 0; i < 2; ++i) {
                m[i] = static_cast<double>(from.m[i]);
                h[i] = static_cast<double>(from.h[i]);
            }
        }
        /// How far it may reach along d to either side of `middle`, which is moved to its own.
        double reach(const Vec3& d, bool with_cylinder, double& middle) const {
            const double c0 = dot(axis[0], d), c1 = dot(axis[1], d), c2 = dot(axis[2], d);
            const double box = std::abs(middle + c0 * m[0] + c1 * m[1]) - std::abs(c0) * h[0] -
                               std::abs(c1) * h[1] - std::abs(c2) * r,
                         cylinder = std::abs(middle + c0 * m[0]) - std::abs(c0) * h[0] -
                                    r * std::hypot(c1, c2);
            return std::max({std::abs(middle) - r, box, with_cylinder ? cylinder : box});
        }
    };
    const Wide a(pair.a);
    Wide b(pair.b);
    for (Vec3& axis : b.axis) axis = rotate(b_to_a.rotation, axis);
    const Vec3 c = transform_point(b_to_a, Vec3(wide(pair.origin_b) + wide(pair.b.c))) -
                   (wide(pair.origin_a) + wide(pair.a.c));
    const auto is_apart = [](const Wide& one, const Wide& other, const Vec3& to_other) {
        for (std::size_t i = 0; i < 2; ++i) {
            double middle = dot(one.axis[i], to_other) - one.m[i];
            if (other.reach(one.axis[i], i == 0, middle) > one.h[i]) return true;
        }
        return false;
    };
    if (squared_norm(c) > (a.r + b.r) * (a.r + b.r) || is_apart(a, b, c) || is_apart(b, a, -c))
        return false;
    const Vec3 across = cross(a.axis[2], b.axis[2]);
    double apart = dot(across, c), reach = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const double of_a = dot(a.axis[i], across), of_b = dot(b.axis[i], across);
        apart += of_b * b.m[i] - of_a * a.m[i];
        reach += std::abs(of_a) * a.h[i] + std::abs(of_b) * b.h[i];
    }
    return std::abs(apart) <= reach;
}

/// Of any size, thickness and place in a node of size 1, its first normal as close to the given one
/// as floats have it.
void set_random(PackedScb& v, Random& random, const Vec3& normal) {
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
}
void set_random(PackedScb2& v, Random& random, const Vec3& normal) {
    const double r = std::ldexp(random.uniform(0.5, 1), -static_cast<int>(random.below(14)));
    Vec3 second = cross(normal, random_unit_vector(random));
    second /= std::sqrt(squared_norm(second));
    // The narrower one is the first.
    const double e = std::ldexp(r, -static_cast<int>(random.below(20)));
    const Scb2 scb{(1 - r) * random_point(random),
                   r,
                   {Slab{normal, e * random.uniform(), -e * random.uniform()},
                    Slab{second, r * random.uniform(0.5, 1), -r * random.uniform(0.5, 1)}}};
    v = packed(scb, Vec3::Zero());
}

// Pairs that just overlap in doubles do in floats, within the bound; within some units less some do
// not. The bound adds up what is never all there: no pair of one slab needed more than one unit.
template <class Packed>
void expect_distances_within_bound(float too_few) {
    constexpr int pairs_tried = unless_sanitized(100000, 10000);
    Random random(91);
    int missed_within_few = 0;
    for (int i = 0; i < pairs_tried; ++i) {
        const double far = i % 4 == 0 ? 1e4 : 1;
        const Mat3 turn = random_rotation(random);
        const Vec3 normal = random_rotation(random).col(0);
        Vec3 other = random_rotation(random).col(0);
        // Nearly parallel slabs as well.
        if (i % 3 == 0)
            other = (normal + std::ldexp(1.0, -static_cast<int>(random.below(24))) * other)
                        .normalized();
        VolumesOfNodes<Packed> pair{{}, {}, {}, {}, 1, 1};
        set_random(pair.a, random, normal);
        set_random(pair.b, random, turn.transpose() * other);
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
            EXPECT_TRUE(overlap_within(level, pair, placed, -1)) << i << simd_level_name(level);
            if (!overlap_within(level, pair, placed, too_few)) ++missed_within_few;
        }
    }
    EXPECT_GT(missed_within_few, 0);
}

// Volumes that share a point are never separated: B is moved so that a point of each, most often on
// the surface, are one.
template <class V>
void expect_shared_points_found() {
    constexpr int pairs_tried = unless_sanitized(200000, 20000);
    Random random(92);
    for (int i = 0; i < pairs_tried; ++i) {
        const V a = some_volume<V>(random, std::ldexp(1.0, -static_cast<int>(random.below(12))));
        const V b = some_volume<V>(random, std::ldexp(1.0, -static_cast<int>(random.below(12))));
        Pose pose;
        // Frames that are nearly the same leave slabs nearly as parallel as they are.
        if (i % 4 != 0) pose.rotation = random_rotation(random);
        pose.translation = point_of(a, random) - rotate(pose.rotation, point_of(b, random));
        const auto packed_a = packed(a, Vec3::Zero()), packed_b = packed(b, Vec3::Zero());
        const auto reach = [](const auto& v) {
            return static_cast<float>(1.001 * std::sqrt(squared_norm(center(v)))) + v.r;
        };
        const VolumesOfNodes<std::decay_t<decltype(packed_a)>> pair{
            packed_a, packed_b, {}, {}, reach(packed_a), reach(packed_b)};
        const Placement placed = placement(pose, 4 * scb::reach(a), 4 * scb::reach(b));
        for (const SimdLevel level : available_simd_levels())
            ASSERT_TRUE(overlap_within(level, pair, placed, -1)) << i << simd_level_name(level);
    }
}
TEST(VolumeKernel, FindsVolumesThatShareAPoint) {
    expect_shared_points_found<Scb>();
    expect_shared_points_found<Scb2>();
}

TEST(VolumeKernel, DistancesAreWithinTheirBound) { expect_distances_within_bound<PackedScb>(0.5f); }
TEST(VolumeKernel, DistancesOfTwoSlabsAreWithinTheirBound) {
    expect_distances_within_bound<PackedScb2>(0.5f);
}

}  // namespace
}  // namespace scb
#endif
