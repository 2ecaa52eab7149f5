#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/collide/dual_traversal.h"
#include "scb/collide.h"
#include "tests/core/collide/brute_force.h"
#include "tests/core/hierarchy/built_mesh.h"

namespace scb {

template <class V>
double size_by(DescentRule rule, const V& v) {
    if (rule == DescentRule::radius) return descent_size(v);
    return rule == DescentRule::area ? descent_area(v) : descent_volume(v);
}

/// Traverses as the recorded steps say and expects them to be a dual traversal of both trees.
template <class V>
void expect_traversal(const Hierarchy<V>& a, const Hierarchy<V>& b, const Steps& steps,
                      const CollideOptions& options) {
    const std::vector<TopologyNode>&nodes_a = a.topology->nodes, &nodes_b = b.topology->nodes;
    const auto& tests = steps.volumes;
    std::size_t next = 0, next_triangle = 0;
    std::vector<std::uint32_t> pending;
    const auto at_end_a = [&](const Step& t) {
        return nodes_a[t.nodes.a].is_leaf() || t.depth_a == options.stop_level;
    };
    const auto at_end_b = [&](const Step& t) {
        return nodes_b[t.nodes.b].is_leaf() || t.depth_b == options.stop_level;
    };
    // Takes the next test, which must be this one.
    const auto take = [&](std::uint32_t i, std::uint32_t j, int depth_a, int depth_b,
                          std::uint32_t parent) {
        ASSERT_LT(next, tests.size());
        const Step& t = tests[next];
        ASSERT_EQ(t.nodes, (IndexPair{i, j})) << next;
        ASSERT_EQ(t.depth_a, depth_a);
        ASSERT_EQ(t.depth_b, depth_b);
        ASSERT_EQ(t.parent, parent);
        if (t.stage == Stage::overlapping) {
            if (!at_end_a(t) || !at_end_b(t)) {
                pending.push_back(static_cast<std::uint32_t>(next));
            } else if (options.stop_level < 0) {
                ASSERT_LT(next_triangle, steps.items.size());
                const ItemStep& triangles = steps.items[next_triangle++];
                ASSERT_EQ(triangles.step, next);
                ASSERT_EQ(triangles.items, (IndexPair{a.topology->order[nodes_a[i].first],
                                                      b.topology->order[nodes_b[j].first]}));
            }
        }
        ++next;
    };
    ASSERT_NO_FATAL_FAILURE(take(0, 0, 0, 0, no_step));
    while (!pending.empty()) {
        const std::uint32_t divided = pending.back();
        const Step& t = tests[divided];
        pending.pop_back();
        bool into_a = !at_end_a(t);
        if (into_a && !at_end_b(t))
            into_a = options.descent == DescentRule::alternating
                         ? (t.depth_a + t.depth_b) % 2 == 0
                         : size_by(options.descent, a.volumes[t.nodes.a]) >=
                               size_by(options.descent, b.volumes[t.nodes.b]);
        for (const std::uint32_t side : {0u, 1u}) {
            if (into_a)
                ASSERT_NO_FATAL_FAILURE(take(nodes_a[t.nodes.a].left + side, t.nodes.b,
                                             t.depth_a + 1, t.depth_b, divided));
            else
                ASSERT_NO_FATAL_FAILURE(take(t.nodes.a, nodes_b[t.nodes.b].left + side, t.depth_a,
                                             t.depth_b + 1, divided));
        }
    }
    EXPECT_EQ(next, tests.size());
    EXPECT_EQ(next_triangle, steps.items.size());
}

inline std::uint64_t transforms_of(const Step& t, const QueryVariant& variant) {
    if (variant.volume_kind() == VolumeKind::obb) return 4;
    if (variant.volume_kind() == VolumeKind::scb2) return t.stage == Stage::ball_ball ? 1 : 3;
    if (t.stage == Stage::center_line && variant.volume_kind() > VolumeKind::aabb_exact) return 3;
    if (variant.volume_kind() > VolumeKind::aabb_exact) return 5;
    if (variant.volume_kind() != VolumeKind::scb || t.stage == Stage::ball_ball) return 1;
    const bool extents = variant.options.overlap.test == OverlapTest::extents;
    return t.stage == Stage::slab_ball && !extents ? 1 : 2;
}

inline void expect_same(const Collision& a, const Collision& b) {
    EXPECT_EQ(a.pairs, b.pairs);
    EXPECT_EQ(a.n_v, b.n_v);
    EXPECT_EQ(a.n_p, b.n_p);
    EXPECT_EQ(a.n_u, b.n_u);
    EXPECT_EQ(a.stages, b.stages);
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(a.complete, b.complete);
}

/// Compares the counts and the pairs of an answer with its steps.
inline void expect_counts_of_steps(const Collision& found, const Steps& steps,
                                   const QueryVariant& variant) {
    StageCounts stages{};
    std::uint64_t transforms = 0, sum = 0;
    int depth = 0;
    std::set<IndexPair> nodes;
    for (const Step& t : steps.volumes) {
        ++stages[static_cast<std::size_t>(t.stage)];
        transforms += transforms_of(t, variant);
        depth = std::max(depth, t.depth_a + t.depth_b);
        nodes.insert(t.nodes);
    }
    for (const std::uint64_t count : found.stages) sum += count;
    EXPECT_EQ(nodes.size(), steps.volumes.size()) << "a pair was tested twice";
    EXPECT_EQ(found.stages, stages);
    EXPECT_EQ(found.n_v, sum);
    EXPECT_EQ(found.n_v, steps.volumes.size());
    EXPECT_EQ(found.n_p, steps.items.size());
    EXPECT_EQ(found.n_u, transforms);
    EXPECT_EQ(found.depth, depth);
    if (variant.options.stop_level >= 0) return;
    std::vector<IndexPair> pairs;
    for (const ItemStep& t : steps.items)
        if (t.hit) pairs.push_back(t.items);
    std::sort(pairs.begin(), pairs.end());
    EXPECT_EQ(found.pairs, pairs);
}

/// Compares an answer with its steps, and with the answer of the same query without an observer.
/// If the answer is complete, the steps must be a whole traversal.
inline void expect_consistent(const Collision& found, const Steps& steps, const BuiltMesh& a,
                              const BuiltMesh& b, const Pose& pose, const QueryVariant& variant) {
    expect_counts_of_steps(found, steps, variant);
    expect_same(query(a, b, pose, variant), found);
    if (!found.complete) return;
    std::visit(
        [&]<class V>(const Hierarchy<V>& hierarchy) {
            expect_traversal(hierarchy, std::get<Hierarchy<V>>(b.hierarchies[variant.kind]), steps,
                             variant.options);
        },
        a.hierarchies[variant.kind]);
}

/// Everything that must hold for one query, which must find `expected`.
inline void expect_query(const BuiltMesh& a, const BuiltMesh& b, const Pose& pose,
                         const QueryVariant& variant, const std::vector<IndexPair>& expected) {
    SCOPED_TRACE(variant.name());
    StepRecorder recorder;
    const Collision found = query(a, b, pose, variant, recorder);
    EXPECT_EQ(found.pairs, expected);
    EXPECT_TRUE(found.complete);
    expect_consistent(found, recorder.steps, a, b, pose, variant);
}

/// The same for every variant, against brute force.
inline void expect_queries(const BuiltMesh& a, const BuiltMesh& b, const Pose& pose) {
    const std::vector<IndexPair> expected = brute_force(a.mesh, b.mesh, pose);
    for (const QueryVariant& variant : all_query_variants()) {
        expect_query(a, b, pose, variant, expected);
        if (testing::Test::HasFailure()) return;
    }
}

}  // namespace scb
