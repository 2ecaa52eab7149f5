#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "scb/any_packed.h"
#include "scb/error.h"
#include "tests/core/collide/brute_force.h"
#include "tests/core/collide/small_scenes.h"
#include "tests/core/packed/packed_variants.h"

namespace scb {
namespace {

/// The answer and the counts of two calls are equal.
void expect_same(const PackedTouch& a, const PackedTouch& b) {
    EXPECT_EQ(a.pair, b.pair);
    EXPECT_EQ(a.n_v, b.n_v);
    EXPECT_EQ(a.n_p, b.n_p);
    EXPECT_EQ(a.n_exact, b.n_exact);
}

/// Every layout and level has the answer of brute force, with one of its pairs. Returns the answer.
bool expect_touches(const BuiltMesh& a, const BuiltMesh& b, const Pose& pose) {
    const std::vector<IndexPair> all = brute_force(a.mesh, b.mesh, pose);
    for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
        SCOPED_TRACE(name);
        for (const LeafCorners corners : {LeafCorners::stored, LeafCorners::in_mesh}) {
            const auto packed_a = pack<Codec>(scb_of<typename Codec::Volume>(a), a.mesh,
                                              most_leaf_triangles, corners),
                       packed_b = pack<Codec>(scb_of<typename Codec::Volume>(b), b.mesh,
                                              most_leaf_triangles, corners);
            PackedWorkspace workspace;  // of the call before, which must not matter
            const auto found = [&](SimdLevel level) {
                return touches<Codec>({packed_a, a.mesh}, {packed_b, b.mesh}, pose, {level},
                                      &workspace);
            };
            const PackedTouch best = touches<Codec>({packed_a, a.mesh}, {packed_b, b.mesh}, pose);
            EXPECT_EQ(static_cast<bool>(best), !all.empty());
            if (best.pair) {
                EXPECT_TRUE(std::binary_search(all.begin(), all.end(), *best.pair));
            }
            for (const SimdLevel level : available_simd_levels()) {
                SCOPED_TRACE(simd_level_name(level));
                expect_same(found(level), best);
            }
        }
    });
    return !all.empty();
}

TEST(Touches, AnswersAsBruteForceDoes) {
    int apart = 0, touch = 0;
    for (int i = 0; i < scenes_tried / 4; ++i) {
        SCOPED_TRACE(i);
        const SmallScene scene = small_scene(8000 + static_cast<std::uint64_t>(i));
        ++(expect_touches(scene.a, scene.b, scene.pose) ? touch : apart);
        if (HasFailure()) return;
    }
    EXPECT_GT(apart, 0);
    EXPECT_GT(touch, 0);
}

// Meshes meet at corners, along edges or on faces. Floats cannot decide such pairs of triangles.
TEST(Touches, AnswersAsBruteForceDoesWhereMeshesOnlyTouch) {
    Random random(81);
    for (int i = 0; i < scenes_tried / 50; ++i) {
        SCOPED_TRACE(i);
        Mesh plate = height_field(4);
        for (Vec3& v : plate.vertices) v[2] = 0;
        for (const Vec3& shift : {Vec3(0.5, 0.125, 0), Vec3(1, 0.25, 0), Vec3(1, 1, 0),
                                  Vec3(1 + 0x1p-30, 0.25, 0), Vec3(0.5, 0.125, 0x1p-30)}) {
            const Pose pose = exact_pose(random);
            Mesh b = plate;
            for (Vec3& v : b.vertices) v = transform_point(inverse(pose), v + shift);
            EXPECT_EQ(expect_touches(BuiltMesh(plate), BuiltMesh(b), pose),
                      shift[0] <= 1 && shift[2] == 0);
        }
        if (HasFailure()) return;
    }
}

/// Two surfaces of 4,608 triangles each that cross along a line.
struct CrossingSheets {
    Mesh mesh = height_field(48);
    PackedHierarchy<QuickestCodec> packed = build_packed(mesh);
    PackedCollider<QuickestCodec> side{packed, mesh};
    Pose pose{(Mat3() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished(), {0.4, 0.05, -0.1}};
};

TEST(Touches, EndsAtTheFirstPair) {
    const CrossingSheets scene;
    const PackedCollision all = collide_packed(scene.side, scene.side, scene.pose);
    const PackedTouch first = touches(scene.side, scene.side, scene.pose);
    EXPECT_TRUE(first);
    EXPECT_GT(all.pairs.size(), 100u);
    EXPECT_LT(5 * first.n_v, all.n_v);
    EXPECT_LT(10 * first.n_p, all.n_p);
}

// Nodes of B whose siblings are nearer wait, and are not divided again.
TEST(Touches, TestsWhereNothingMeetsAsManyNodesAsAQueryForAllPairs) {
    Mesh bowl = height_field(48);
    for (Vec3& v : bowl.vertices) v[2] += (v[0] * v[0] + v[1] * v[1]) / 2;
    const PackedHierarchy<QuickestCodec> packed = build_packed(bowl);
    const PackedCollider side{packed, bowl};
    std::uint64_t tests = 0;
    for (int i = 0; i < 20; ++i) {
        const Pose above{Mat3::Identity(), {0, 0, 0.01 * i}};
        const PackedCollision all = collide_packed(side, side, above);
        const PackedTouch first = touches(side, side, above);
        EXPECT_EQ(first.pair.has_value(), !all.pairs.empty());
        if (first) continue;
        tests += all.n_v;
        EXPECT_EQ(first.n_v, all.n_v);
        EXPECT_EQ(first.n_p, all.n_p);
    }
    EXPECT_GT(tests, 2000u);
}

// At each pair of nodes, the children of one are tested with the other, then the other's children
// with the nearest of these: at most 16 tests a level. The nearest is right for most poses, any
// other for a third of them.
TEST(Touches, GoesStraightToTheNearestLeaves) {
    const CrossingSheets scene;
    const std::array<double, 5> shifts = {0, 1e-3, 0.1, 0.3, 0.5};
    int straight = 0;
    for (const double x : shifts)
        for (const double y : shifts) {
            const Pose moved{Mat3::Identity(), {x, y, 0}};
            const PackedTouch found = touches(scene.side, scene.side, moved);
            EXPECT_TRUE(found);
            straight += found.n_v <= 16u * 5;
        }
    EXPECT_GE(straight, 15);
}

TEST(Touches, BeginsWithThePairOfTheLastCall) {
    const CrossingSheets scene;
    PackedWorkspace workspace;
    PackedFront front;
    const auto at = [&](double shift) {
        const Pose pose{scene.pose.rotation, scene.pose.translation + Vec3(shift, 0, 0)};
        return touches(scene.side, scene.side, pose, {}, &workspace, &front);
    };
    const PackedTouch first = at(0), again = at(1e-9);
    EXPECT_GT(first.n_v, 0u);
    EXPECT_EQ(again.pair, first.pair);
    EXPECT_EQ(again.n_v, 0u);
    EXPECT_EQ(again.n_p, 1u);
    // These triangles meet no longer, others do.
    const PackedTouch other = at(0.25);
    EXPECT_TRUE(other);
    EXPECT_NE(other.pair, first.pair);
    EXPECT_FALSE(at(50));
    front.clear();
    EXPECT_GT(at(0).n_v, 0u) << "the front has no pair after clear()";
}

TEST(Touches, UsesAFrontWhileTheBodiesAreApart) {
    const CrossingSheets scene;
    PackedWorkspace workspace;
    PackedFront front;
    // Two sheets, one above the other, that come nearer and meet.
    std::uint64_t n_v = 0, from_roots = 0;
    bool met = false;
    for (int i = 0; i < 60; ++i) {
        const Pose pose{Mat3::Identity(), {0.01, 0.003, 2e-4 * (40 - i)}};
        const PackedTouch found = touches(scene.side, scene.side, pose, {}, &workspace, &front),
                          expected = touches(scene.side, scene.side, pose);
        EXPECT_EQ(static_cast<bool>(found), static_cast<bool>(expected)) << i;
        if (!expected) {
            n_v += found.n_v;
            from_roots += expected.n_v;
        }
        met = met || expected;
    }
    EXPECT_TRUE(met);
    EXPECT_GT(front.used(), 5u);
    EXPECT_LT(n_v, from_roots / 2);
}

TEST(Touches, SharesAFrontWithQueriesForAllPairs) {
    const CrossingSheets scene;
    PackedWorkspace workspace;
    PackedFront front;
    // In contact, apart, and back, in small steps, with as many threads as asked for.
    for (int i = 0; i < 60; ++i) {
        const double height = 2e-4 * (i < 30 ? 20 - i : i - 40);
        const Pose pose{Mat3::Identity(), {0.01, 0.003, height}};
        const PackedOptions options{SimdLevel::best, 1 + i % 3};
        const PackedCollision all = collide_packed(scene.side, scene.side, pose);
        const PackedTouch found =
            touches(scene.side, scene.side, pose, options, &workspace, &front);
        EXPECT_EQ(static_cast<bool>(found), !all.pairs.empty()) << i;
        if (i % 4 == 0) {
            const PackedCollision again =
                collide_packed(scene.side, scene.side, pose, options, &workspace, &front);
            EXPECT_EQ(again.pairs, all.pairs) << i;
        }
    }
    EXPECT_GT(front.used(), 0u);
}

TEST(Touches, RefusesTwoLayouts) {
    const Mesh mesh = height_field(2);
    const AnyPacked wide = build_packed_any({}, VolumeKind::scb2, mesh),
                    narrow = build_packed_any({.width = 2}, VolumeKind::scb2, mesh);
    EXPECT_THROW(touches(wide, mesh, narrow, mesh, {}), InputError);
    EXPECT_TRUE(touches(wide, mesh, wide, mesh, {}));
}

}  // namespace
}  // namespace scb
