#pragma once

#include <gtest/gtest.h>

#include <array>

#include "scb/overlap.h"
#include "scb/placement.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {

inline const Vec3 unit_x = Vec3::UnitX(), unit_z = Vec3::UnitZ();

/// The tests that never reject volumes that overlap. Below: the tests among them that measure slabs
/// by cylinders.
inline constexpr std::array sound_tests = {OverlapTest::line8, OverlapTest::corrected,
                                           OverlapTest::symmetric, OverlapTest::extents};
inline constexpr std::array slab_cylinder_tests = {OverlapTest::line8, OverlapTest::corrected,
                                                   OverlapTest::symmetric};

inline Stage stage_of_pair(const VolumePair<Scb>& pair, OverlapTest test, double threshold = 0.7) {
    return overlap(pair.a, pair.b, pair.b_to_a, {test, threshold});
}

inline bool rejected(const VolumePair<Scb>& pair, OverlapTest test, double threshold = 0.7) {
    return stage_of_pair(pair, test, threshold) != Stage::overlapping;
}

/// Expects that the test ends there, with both in one frame and with each in a frame of its own.
template <class V>
void expect_stage(const V& a, const V& b, Stage stage, OverlapTest test = OverlapTest::corrected,
                  double threshold = 0.7) {
    Random random(11);
    const OverlapOptions options{test, threshold};
    EXPECT_EQ(stage_name(overlap(a, b, Pose{}, options)), stage_name(stage))
        << overlap_test_name(test);
    for (int i = 0; i < 10; ++i) {
        const Pose world_a = random_pose(random), world_b = random_pose(random);
        EXPECT_EQ(stage_name(overlap(placed(a, inverse(world_a)), placed(b, inverse(world_b)),
                                     relative_pose(world_a, world_b), options)),
                  stage_name(stage))
            << overlap_test_name(test) << ", moved";
    }
}

inline Scb slab_at(const Vec3& c, double r, const Vec3& n, double e, double f) {
    return {c, r, n, e, f};
}
inline Scb whole_ball_at(const Vec3& c, double r) { return {c, r, Vec3::UnitZ(), r, -r}; }

/// How many random pairs a test of verdicts draws.
inline constexpr int pairs_tried = 40000;

/// Whether rounding cannot turn the verdict.
inline bool is_decided(const VolumePair<Scb>& p, OverlapTest test, double threshold = 0.7) {
    constexpr double tiny = 1e-9;
    return rejected({enlarged(p.a, tiny), enlarged(p.b, tiny), p.b_to_a}, test, threshold) ==
           rejected({enlarged(p.a, -tiny), enlarged(p.b, -tiny), p.b_to_a}, test, threshold);
}

inline VolumePair<Scb> exchanged(const VolumePair<Scb>& p) { return {p.b, p.a, inverse(p.b_to_a)}; }

}  // namespace scb
