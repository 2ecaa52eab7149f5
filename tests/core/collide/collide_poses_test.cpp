#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/collide/collide_checks.h"
#include "tests/core/collide/small_scenes.h"

namespace scb {
namespace {

TEST(Collide, FindsWhatBruteForceFindsFarFromTheOrigin) {
    Random random(56);
    std::size_t pairs = 0;
    for (int i = 0; i < scenes_tried / 20; ++i) {
        SCOPED_TRACE(i);
        const Vec3 away = 1e6 * random_point(random);
        const Mesh a = random_soup(random.next(), 30, 0.5);
        // B is stored far from its origin, or is far from A's, or both are far in the world.
        Mesh b = random_soup(random.next(), 30, 0.5);
        Pose pose = random_pose(random, 0.3);
        for (Vec3& v : b.vertices) v += away;
        pose.translation -= rotate(pose.rotation, away);
        expect_queries(BuiltMesh(a), BuiltMesh(b), pose);
        pairs += brute_force(a, b, pose).size();
        expect_queries(BuiltMesh(b), BuiltMesh(a), inverse(pose));
        expect_queries(BuiltMesh(a), BuiltMesh(a), {pose.rotation, away});

        const Pose world_a{random_rotation(random), away}, world_b{random_rotation(random), away};
        expect_queries(BuiltMesh(a), BuiltMesh(a), relative_pose(world_a, world_b));
        if (HasFailure()) return;
    }
    EXPECT_GT(pairs, scenes_tried / 4u);
}

// Plates on each other, face to face and edge to edge, in turned frames: rounding moves corners off
// the common plane, and only what it leaves touching may be found.
TEST(Collide, FindsWhatBruteForceFindsWhereMeshesTouch) {
    Random random(57);
    std::size_t pairs = 0;
    for (int i = 0; i < scenes_tried / 20; ++i) {
        SCOPED_TRACE(i);
        Mesh plate = height_field(4), other = plate;
        for (Vec3& v : plate.vertices) v[2] = 0;
        other = plate;
        const Vec3 shift = random.below(2) == 0 ? Vec3(0.5, 0.125, 0) : Vec3(1, 0.25, 0);
        for (Vec3& v : other.vertices) v += shift;
        const Pose exact = exact_pose(random), turned = random_pose(random);
        for (const Pose& pose : {exact, turned}) {
            Mesh b = other;
            for (Vec3& v : b.vertices) v = transform_point(inverse(pose), v);
            expect_queries(BuiltMesh(plate), BuiltMesh(b), pose);
            pairs += brute_force(plate, b, pose).size();
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(pairs, static_cast<std::size_t>(scenes_tried));
}

TEST(Collide, FindsTheMirroredPairsWhereAAndBAreExchanged) {
    for (int i = 0; i < scenes_tried / 10; ++i) {
        SCOPED_TRACE(i);
        Random random(2000 + static_cast<std::uint64_t>(i));
        const BuiltMesh a(grid_soup(random, 20, 5)), b(grid_soup(random, 15, 5));
        const Pose pose = exact_pose(random);
        for (const QueryVariant& variant : all_query_variants()) {
            const Collision forth = query(a, b, pose, variant);
            Collision back = query(b, a, inverse(pose), variant);
            for (IndexPair& pair : back.pairs) std::swap(pair.a, pair.b);
            std::sort(back.pairs.begin(), back.pairs.end());
            ASSERT_EQ(forth.pairs, back.pairs) << variant.name();
            expect_same(query(a, b, pose, variant), forth);
        }
    }
}

// A pose may be off from rigid by 1e-9. Flat triangles that cross at an angle of about the square
// root of that are where a normal that is not quite a unit vector does most harm.
TEST(Collide, MissesNothingAtPosesThatAreHardlyRigid) {
    Random random(5);
    int crossing = 0;
    for (int i = 0; i < 4000; ++i) {
        const double defect = 4e-15 * std::pow(2e5, random.uniform());
        const double tilt = std::sqrt(defect) * random.uniform(0.2, 2);
        Pose pose;
        pose.rotation << 1, 0, 0, 0, std::cos(tilt), -std::sin(tilt), 0, std::sin(tilt),
            std::cos(tilt);
        pose.rotation *= 1 + (random.below(2) == 0 ? 0.45 : -0.45) * defect;
        // B's plane leaves A's at a line through A, which only their far parts cross.
        pose.translation = {random.uniform(-0.2, 0.2), 0, tilt * random.uniform(0.3, 0.9)};
        Mesh mesh;
        mesh.vertices = {{0, 1, 0}, {-0.9, -0.9, 0}, {0.9, -0.9, 0}};
        mesh.triangles = {{0, 1, 2}};
        const auto pairs = [&]<class V>(V, OverlapTest test) {
            const Hierarchy<V> h = build_hierarchy<V>(mesh);
            CollideOptions options;
            options.overlap.test = test;
            return collide(Collider<V>{h, mesh}, Collider<V>{h, mesh}, pose, options).pairs.size();
        };
        check_rigid(pose, "pose");
        const std::size_t expected = pairs(Ball{}, OverlapTest::symmetric);
        crossing += static_cast<int>(expected);
        for (const OverlapTest test :
             {OverlapTest::corrected, OverlapTest::symmetric, OverlapTest::extents})
            ASSERT_EQ(pairs(Scb{}, test), expected)
                << overlap_test_name(test) << " at a defect of " << rigidity_defect(pose);
    }
    EXPECT_GT(crossing, 1000);
}

}  // namespace
}  // namespace scb
