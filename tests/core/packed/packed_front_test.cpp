#include "scb/packed_front.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/base/portable_math.h"
#include "core/packed/front_schedule.h"
#include "scb/any_packed.h"
#include "tests/core/collide/brute_force.h"
#include "tests/core/collide/small_scenes.h"
#include "tests/core/packed/packed_variants.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

/// How many queries were made, how many of them began at a front, and how many pairs they found.
struct FrontUse {
    std::uint64_t queries = 0, used = 0, made = 0, pairs = 0;
    FrontUse& operator+=(const FrontUse& other) {
        queries += other.queries;
        used += other.used;
        made += other.made;
        pairs += other.pairs;
        return *this;
    }
};

/// Queries along a motion, with a front and from the roots, find the same; at every SIMD level and
/// with threads the front makes the same difference.
template <class Codec>
FrontUse expect_same_of(const BuiltMesh& a, const BuiltMesh& b, const std::vector<Pose>& motion,
                        LeafCorners corners = LeafCorners::stored) {
    const auto packed_a = pack<Codec>(scb_of<typename Codec::Volume>(a), a.mesh,
                                      most_leaf_triangles, corners),
               packed_b = pack<Codec>(scb_of<typename Codec::Volume>(b), b.mesh,
                                      most_leaf_triangles, corners);
    const PackedCollider<Codec> side_a{packed_a, a.mesh}, side_b{packed_b, b.mesh};
    std::vector<PackedOptions> ways = {{}, {SimdLevel::best, 3}};
    for (const SimdLevel level : available_simd_levels()) ways.push_back({level});
    PackedWorkspace workspace;
    FrontUse use;
    std::vector<PackedFront> fronts(ways.size());
    for (std::size_t i = 0; i < motion.size(); ++i) {
        SCOPED_TRACE(i);
        const auto expected = collide_packed(side_a, side_b, motion[i], {}, &workspace);
        PackedCollision first;
        for (std::size_t way = 0; way < ways.size(); ++way) {
            const auto found =
                collide_packed(side_a, side_b, motion[i], ways[way], &workspace, &fronts[way]);
            EXPECT_EQ(found.pairs, expected.pairs) << way;
            if (way == 0) first = found;
            EXPECT_EQ(found.n_v, first.n_v) << way;
            EXPECT_EQ(found.n_p, first.n_p) << way;
            EXPECT_EQ(found.n_exact, first.n_exact) << way;
        }
        use += {1, 0, 0, expected.pairs.size()};
        if (testing::Test::HasFailure()) break;
    }
    return use += {0, fronts[0].used(), fronts[0].made(), 0};
}

FrontUse expect_same(const BuiltMesh& a, const BuiltMesh& b, const std::vector<Pose>& motion) {
    FrontUse use;
    for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
        SCOPED_TRACE(name);
        use += expect_same_of<Codec>(a, b, motion);
    });
    return use += expect_same_of<QuantizedCodec<8>>(a, b, motion, LeafCorners::in_mesh);
}

Mat3 turn_about_z(double degrees) {
    const SinCos a = sin_cos_degrees(degrees);
    Mat3 turn;
    turn << a.cos, -a.sin, 0, a.sin, a.cos, 0, 0, 0, 1;
    return turn;
}

/// The pose after some time of a turn at a constant rate and a translation.
Pose at_time(const Pose& start, double time) {
    return compose({turn_about_z(20 * time), time * Vec3(0.1, -0.2, 0.3)}, start);
}

std::vector<Pose> motion_of(const Pose& start, int count,
                            const std::function<double(int)>& time_of) {
    std::vector<Pose> motion;
    for (int i = 0; i < count; ++i) motion.push_back(at_time(start, time_of(i)));
    return motion;
}

/// Two surfaces that cross.
struct Crossing {
    BuiltMesh a{height_field(16)}, b{height_field(16)};
    Pose pose{(Mat3() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished(), {0.4, 0.05, -0.1}};
};

TEST(PackedFront, FindsTheSameWhereTheMotionIsSlow) {
    const Crossing scene;
    for (const double step : {1e-3, 1e-4, 1e-6, 0.0}) {
        SCOPED_TRACE(step);
        const FrontUse use = expect_same(
            scene.a, scene.b, motion_of(scene.pose, 30, [&](int i) { return step * i; }));
        EXPECT_EQ(use.used, use.queries / 30 * 29) << "all but the first";
        EXPECT_LT(use.made, use.used / 2);
        EXPECT_GT(use.pairs, 0u);
    }
}

TEST(PackedFront, IsNotMadeWhereTheMotionIsFast) {
    const Crossing scene;
    const FrontUse use =
        expect_same(scene.a, scene.b, motion_of(scene.pose, 20, [](int i) { return 0.1 * i; }));
    EXPECT_EQ(use.made, 0u);
    EXPECT_GT(use.pairs, 0u);
}

TEST(PackedFront, FindsTheSameWhereTheMotionJumps) {
    const Crossing scene;
    Random random(95);
    // Rests, moves slowly, is far away, and back where a front was made.
    const FrontUse use = expect_same(
        scene.a, scene.b, motion_of(scene.pose, 60, [&](int i) {
            return i % 10 == 9 ? 50.0 : i % 10 == 5 ? random.uniform() : 0.2 * (i / 20) + 1e-4 * i;
        }));
    EXPECT_GT(use.used, use.queries / 3);
    EXPECT_LT(use.used, use.queries);
}

TEST(PackedFront, FindsTheSameWhereTheMotionGoesBackAndForth) {
    const Crossing scene;
    const double steps[] = {0, 1, 2, 1, 0, -1, -2, -1};
    for (const double step : {2e-3, 1e-3, 1e-4}) {
        const FrontUse use =
            expect_same(scene.a, scene.b,
                        motion_of(scene.pose, 80, [&](int i) { return step * steps[i % 8]; }));
        EXPECT_GT(use.used, 0u);
    }
}

// At random times, so that every other front or so is not good for the next query.
TEST(PackedFront, FindsTheSameOnSmallMeshes) {
    FrontUse use;
    for (int i = 0; i < scenes_tried / 20; ++i) {
        SCOPED_TRACE(i);
        Random random(5000 + static_cast<std::uint64_t>(i));
        const SmallScene scene = small_scene(random.next());
        const double step = std::ldexp(1.0, -static_cast<int>(random.below(16)) - 3);
        use += expect_same(scene.a, scene.b, motion_of(scene.pose, 12, [&](int k) {
                               return step * (k / 2 + 2 * random.uniform());
                           }));
        if (HasFailure()) return;
    }
    EXPECT_GT(use.used, use.queries / 4);
    EXPECT_LT(use.used, use.queries);
}

// Plates on each other, face to face and edge to edge: where one slides, pairs touch in the last
// bit, and the least rounding in the wrong direction loses them.
TEST(PackedFront, FindsTheSameWhereMeshesTouch) {
    Random random(96);
    for (int i = 0; i < scenes_tried / 50; ++i) {
        SCOPED_TRACE(i);
        Mesh plate = height_field(4);
        for (Vec3& v : plate.vertices) v[2] = 0;
        const Pose frame = i % 2 == 0 ? exact_pose(random) : random_pose(random);
        Mesh turned = plate;
        for (Vec3& v : turned.vertices) v = transform_point(inverse(frame), v);
        const Vec3 way = i % 3 == 0 ? Vec3::UnitZ() : Vec3::UnitX();
        std::vector<Pose> motion;
        // Comes nearer until it touches, goes on as far, and rests where it touches.
        for (int k = -12; k <= 12; ++k)
            motion.push_back(
                {frame.rotation, frame.translation + Vec3(1, 0.25, 0) - 0x1p-12 * k * way});
        for (int k = 0; k < 3; ++k)
            motion.push_back({frame.rotation, frame.translation + Vec3(1, 0.25, 0)});
        const FrontUse use = expect_same(BuiltMesh(plate), BuiltMesh(turned), motion);
        EXPECT_GT(use.used, use.queries / 2);
        if (HasFailure()) return;
    }
}

// A triangle comes down on many in steps as long as a front allows: the front is made where they
// are apart, and used where they meet.
TEST(PackedFront, HasWhatIsReachedAtTheEndOfItsSkin) {
    const BuiltMesh ground(height_field(unless_sanitized(16, 8)));
    Mesh roof = height_field(unless_sanitized(16, 8));
    for (Vec3& v : roof.vertices) v[2] = -v[2];
    const BuiltMesh above(roof);
    std::uint64_t found = 0;
    for (const double step : {1e-3, 3e-4, 1e-4}) {
        std::vector<Pose> motion;
        for (int i = 0; i < 40; ++i)
            motion.push_back({Mat3::Identity(), {0.01, 0.02, 0.03 - step * i}});
        const FrontUse use = expect_same(ground, above, motion);
        EXPECT_GT(use.used, use.queries / 2) << step;
        found += use.pairs;
    }
    EXPECT_GT(found, 0u);
}

TEST(PackedFront, OfOneTriangleEach) {
    const BuiltMesh one(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    expect_same(one, one, motion_of({}, 10, [](int i) { return 1e-3 * i; }));
    const BuiltMesh point(Mesh{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}});
    const FrontUse use = expect_same(point, point, std::vector<Pose>(4));
    EXPECT_EQ(use.made, 0u) << "there is no skin to speak of";
}

TEST(PackedFront, IsOfOtherHierarchiesOnceCleared) {
    const Crossing scene;
    const PackedLayout layout;
    const AnyPacked a = pack_any(layout, scb_of(scene.a), scene.a.mesh);
    const BuiltMesh small_mesh(height_field(5));
    const AnyPacked small = pack_any(layout, scb_of(small_mesh), small_mesh.mesh);
    PackedFront front;
    for (int i = 0; i < 4; ++i)
        collide_packed(a, scene.a.mesh, a, scene.a.mesh, scene.pose, {}, nullptr, &front);
    EXPECT_EQ(front.made(), 1u);
    EXPECT_EQ(front.used(), 3u);
    front.clear();
    EXPECT_EQ(front.used(), 0u);
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(collide_packed(small, small_mesh.mesh, small, small_mesh.mesh, scene.pose, {},
                                 nullptr, &front)
                      .pairs,
                  brute_force(small_mesh.mesh, small_mesh.mesh, scene.pose));
    EXPECT_EQ(front.used(), 3u);
}

const FrontBodies unit_balls = {{Vec3::Zero(), 1}, {Vec3::Zero(), 1}, 0.1};

// The proof rests on this alone. It does not depend on the heuristics.
TEST(FrontSchedule, OffersAFrontOnlyWithinItsSkin) {
    Random random(97);
    int used = 0, not_used = 0;
    for (int run = 0; run < 200; ++run) {
        FrontSchedule schedule;
        FrontPlan front;
        Pose pose = random_pose(random);
        for (int i = 0; i < 50; ++i) {
            const double step = std::ldexp(random.uniform(), -static_cast<int>(random.below(20)));
            pose = compose({turn_about_z(step), step * random_point(random)}, pose);
            const double rounding = run % 2 == 0 ? 1e-6 : 0.01;
            if (const auto plan = schedule.next(unit_balls, pose, rounding)) front = *plan;
            if (!schedule.is_good()) {
                ++not_used;
                continue;
            }
            ++used;
            ASSERT_LE(motion_bound(unit_balls, front.b_to_a, pose) + rounding, front.skin);
            for (int k = 0; k < 20; ++k) {
                const Vec3 p = random_unit_vector(random), q = random_unit_vector(random);
                const auto distance = [&](const Pose& at) {
                    return std::sqrt(squared_norm(transform_point(at, q) - p));
                };
                ASSERT_LE(std::abs(distance(pose) - distance(front.b_to_a)) + rounding,
                          front.skin + 1e-14);
            }
        }
    }
    EXPECT_GT(used, 1000);
    EXPECT_GT(not_used, 1000);
}

TEST(FrontSchedule, OfSteadyMotionLiesAhead) {
    FrontSchedule schedule;
    int longest = 0, uses = 0;
    for (int i = 0; i < 40; ++i) {
        const Pose pose = at_time({}, 1e-4 * i);
        if (const auto plan = schedule.next(unit_balls, pose, 1e-14)) {
            uses = 0;
            if (i > 3) {
                EXPECT_GT(motion_bound(unit_balls, plan->b_to_a, pose), plan->skin / 2);
            }
        }
        longest = std::max(longest, ++uses);
    }
    EXPECT_GT(longest, 8);
}

TEST(FrontSchedule, GivesUpWhereFrontsDoNotPay) {
    // Each step leads out of the skin that the one before makes.
    FrontSchedule schedule;
    const double steps[] = {1e-6, 2e-4, 2e-3, 6e-3};
    double far = 0;
    const auto next = [&](double step) {
        far += step;
        schedule.next(unit_balls, {Mat3::Identity(), {far, 0, 0}}, 1e-14);
        return schedule.is_good();
    };
    for (int i = 0; i < 1000; ++i) next(steps[i % 4]);
    EXPECT_GT(schedule.made, 3u);
    EXPECT_LT(schedule.made, 30u);
    // And tries again in the end.
    int good = 0;
    for (int i = 0; i < 1000; ++i) good += next(1e-5) ? 1 : 0;
    EXPECT_GT(good, 900);
}

}  // namespace
}  // namespace scb
