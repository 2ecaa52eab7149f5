#include <gtest/gtest.h>

#include "core/analysis/trace_diff.h"
#include "tests/core/analysis/made_query.h"

namespace scb {
namespace {

/// One query in which the first child of the roots is rejected at the stage of this index.
Trace rejecting(std::size_t index, const std::vector<std::string>& stages) {
    MadeQuery query;
    for (const std::string& name : stages)
        query.header.engine->stages.push_back(query.header.stages.add(name));
    query.test(MadeQuery::none, {0, 0});
    query.test(0, {1, 0});
    query.test(0, {2, 0});
    query.triangles({4, 4}, true);
    query.frame.steps.volumes[1].stage = query.header.engine->stages.at(index);
    return {query.header, {query.frame}};
}

TEST(EngineTraceDiff, StagesAreTheSameWhereTheirNamesAre) {
    const Trace a = rejecting(0, {"axes", "edges"}), same = rejecting(1, {"edges", "axes"}),
                other = rejecting(0, {"edges", "axes"}), unknown = rejecting(0, {"corners"});
    EXPECT_TRUE(diff(a, same).equal());
    EXPECT_FALSE(diff(a, same).first);
    for (const Trace* b : {&other, &unknown}) {
        const TraceDiff d = diff(a, *b);
        EXPECT_FALSE(d.equal());
        ASSERT_TRUE(d.first && d.first->a && d.first->b);
        EXPECT_EQ(d.first->test, 1u);
        EXPECT_EQ(d.first->a->stage, "axes");
        EXPECT_NE(d.first->b->stage, "axes");
    }
}

TEST(EngineTraceDiff, NodesAreComparedWhereBothTreesAreAlike) {
    for (const std::size_t side : {0u, 1u}) {
        Trace a = rejecting(0, {"axes"}), b = a;
        a.header.engine->trees = {{0, {5, 6}}, {3, {7, 8}}, {4, {1, 1}}};
        b.header.engine->trees = {{0, {5, 6}}, {3, {7, 8}}, {5, {2, 2}}};
        EXPECT_TRUE(diff(a, b).equal()) << "no frame is in both where they differ";
        EXPECT_TRUE(diff(a, b).nodes_comparable);
        b.header.engine->trees[3][side] = 9;
        const TraceDiff d = diff(a, b);
        EXPECT_FALSE(d.nodes_comparable);
        EXPECT_TRUE(d.pairs_comparable);
        ASSERT_EQ(d.asked.size(), 1u);
        EXPECT_EQ(d.asked[0].name, side == 0 ? "tree of A" : "tree of B");
        EXPECT_TRUE(d.asked[0].b.ends_with(" at frame 3")) << d.asked[0].b;
    }
}

TEST(EngineTraceDiff, MeshesAreTheSameWhereTheirCountsAre) {
    Trace a = rejecting(0, {"axes"});
    a.header.bodies[0].mesh = a.header.bodies[1].mesh = {20, 12, 77};
    Trace b = a;
    b.header.bodies[0].mesh.hash = 78;  // 32 bits of the coordinates
    EXPECT_TRUE(same_meshes(a.header, b.header));
    b.header.engine.reset();
    EXPECT_TRUE(same_meshes(a.header, b.header)) << "one of an engine is enough";
    a.header.engine.reset();
    EXPECT_FALSE(same_meshes(a.header, b.header));
    for (const std::size_t side : {0u, 1u}) {
        Trace other = rejecting(0, {"axes"}), fewer = other;
        for (Trace* trace : {&other, &fewer})
            trace->header.bodies[0].mesh = trace->header.bodies[1].mesh = {20, 12, 77};
        --fewer.header.bodies[side].mesh.vertices;
        EXPECT_FALSE(same_meshes(other.header, fewer.header));
    }
}

TEST(TraceCounts, CompareTheTransformedPointsWhereBothTellThem) {
    TraceCounts a, b;
    a.n_u = 5;
    EXPECT_TRUE(a == b && b == a);
    b.n_u = 6;
    EXPECT_FALSE(a == b);
    b.n_u = 5;
    EXPECT_TRUE(a == b);
    b.stages["axes"] = 1;
    EXPECT_FALSE(a == b);
}

}  // namespace
}  // namespace scb
