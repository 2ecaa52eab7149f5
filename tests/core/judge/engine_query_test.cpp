#include "core/judge/engine_query.h"

#include <gtest/gtest.h>

namespace scb {
namespace {

TEST(EngineQuery, TheToleranceOfTwoNodesFollowsTheirOwnReach) {
    EngineNodes tree;
    EngineNode near, far;
    near.number = 0;
    near.reach = 1;
    far.number = 1;
    far.reach = 100;
    tree.add(near, "", {}, {});
    tree.add(far, "", {}, {});
    EngineQuery query;
    for (EngineSide& side : query.sides) {
        side.tree = &tree;
        side.reach = 100;
        side.mesh_reach = 2;
    }
    query.sides[1].stretch = 3;
    query.tolerance = 0.5;
    query.tolerance_slope = 1e-3;
    EXPECT_DOUBLE_EQ(tolerance_of(query, {1, 1}), 0.5);
    EXPECT_DOUBLE_EQ(tolerance_of(query, {0, 1}), 0.5 - 0.098) << "the mesh reaches to 2";
    EXPECT_DOUBLE_EQ(tolerance_of(query, {0, 0}), 0.5 - 0.098 - 3 * 0.098);
    // A tolerance that was recorded is the same for all.
    query.tolerance_slope = 0;
    EXPECT_EQ(tolerance_of(query, {0, 0}), 0.5);
}

}  // namespace
}  // namespace scb
