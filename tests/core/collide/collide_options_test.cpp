#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/collide/small_scenes.h"

namespace scb {
namespace {

TEST(CollideOptions, PassTheThresholdOn) {
    Mesh plate = height_field(12);
    const BuiltMesh a(plate);
    // Turned a little, since the cosine of a normal to itself may round to more than 1.
    Mat3 turn;
    turn << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
    const Pose pose{turn, {0.3, 0.05, 0.02}};
    QueryVariant variant{0, {}};
    variant.options.overlap.test = OverlapTest::corrected;
    variant.options.overlap.threshold = 1;
    const Collision without = query(a, a, pose, variant);
    variant.options.overlap.threshold = 0;
    const Collision with = query(a, a, pose, variant);
    EXPECT_EQ(with.pairs, without.pairs);
    EXPECT_LT(with.n_v, without.n_v);
    const auto cylinder_tests = [](const Collision& c) {
        return c.stages[static_cast<std::size_t>(Stage::slab_cylinder)] +
               c.stages[static_cast<std::size_t>(Stage::cylinder_slab)];
    };
    EXPECT_EQ(cylinder_tests(without), 0u);
    EXPECT_GT(cylinder_tests(with), 0u);
}

TEST(CollideOptions, ChooseTheTestWhoseStagesAreCounted) {
    const SmallScene s = small_scene(3);
    for (const QueryVariant& variant : all_query_variants()) {
        const auto stages = stages_of(variant.volume_kind(), variant.options.overlap);
        const Collision found = query(s.a, s.b, s.pose, variant);
        for (std::size_t k = 1; k < stage_count; ++k) {
            if (std::find(stages.begin(), stages.end(), static_cast<Stage>(k)) != stages.end())
                continue;
            EXPECT_EQ(found.stages[k], 0u) << stage_name(static_cast<Stage>(k));
        }
    }
}

}  // namespace
}  // namespace scb
