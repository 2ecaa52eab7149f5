#include "scb/packed_collide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "scb/any_packed.h"
#include "scb/error.h"
#include "tests/core/collide/brute_force.h"
#include "tests/core/collide/small_scenes.h"
#include "tests/core/packed/packed_variants.h"

namespace scb {
namespace {

/// What must be the same at every SIMD level.
void expect_same(const PackedCollision& a, const PackedCollision& b) {
    EXPECT_EQ(a.pairs, b.pairs);
    EXPECT_EQ(a.n_v, b.n_v);
    EXPECT_EQ(a.n_p, b.n_p);
    EXPECT_EQ(a.n_exact, b.n_exact);
}

/// Every layout, leaf size and level finds the pairs of brute force. Returns how many pairs of
/// triangles floats were asked about, and how many they left open, both in all.
struct Asked {
    std::uint64_t triangles = 0, open = 0;
};
Asked expect_packed(const BuiltMesh& a, const BuiltMesh& b, const Pose& pose) {
    const std::vector<IndexPair> expected = brute_force(a.mesh, b.mesh, pose);
    Asked asked;
    for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
        SCOPED_TRACE(name);
        for (const auto& [leaf, corners] : {std::pair(1, LeafCorners::stored),
                                            std::pair(most_leaf_triangles, LeafCorners::stored),
                                            std::pair(most_leaf_triangles, LeafCorners::in_mesh)}) {
            const auto packed_a =
                           pack<Codec>(scb_of<typename Codec::Volume>(a), a.mesh, leaf, corners),
                       packed_b =
                           pack<Codec>(scb_of<typename Codec::Volume>(b), b.mesh, leaf, corners);
            PackedWorkspace workspace;  // of the query before, which must not matter
            const auto found = [&](SimdLevel level) {
                return collide_packed<Codec>({packed_a, a.mesh}, {packed_b, b.mesh}, pose, {level},
                                             &workspace);
            };
            expect_same(collide_packed<Codec>({packed_a, a.mesh}, {packed_b, b.mesh}, pose),
                        found(SimdLevel::base));
            const PackedCollision best = found(SimdLevel::best);
            EXPECT_EQ(best.pairs, expected);
            asked.triangles += best.n_p;
            asked.open += best.n_exact;
            for (const int threads : {2, 3})
                expect_same(collide_packed<Codec>({packed_a, a.mesh}, {packed_b, b.mesh}, pose,
                                                  {SimdLevel::best, threads}, &workspace),
                            best);
            for (const SimdLevel level : available_simd_levels()) {
                SCOPED_TRACE(simd_level_name(level));
                expect_same(found(level), best);
            }
        }
    });
    return asked;
}

template <class Packed>
concept CollidesWithMesh = requires(const Packed& packed, const Mesh& mesh, const Pose& b_to_a) {
    collide_packed(packed, mesh, packed, mesh, b_to_a);
    touches(packed, mesh, packed, mesh, b_to_a);
};
// A hierarchy of a known layout would be converted to AnyPacked in each query, with a copy.
static_assert(CollidesWithMesh<AnyPacked> && !CollidesWithMesh<PackedHierarchy<QuickestCodec>>);

TEST(CollidePacked, FindsWhatBruteForceFinds) {
    Asked all;
    for (int i = 0; i < scenes_tried / 4; ++i) {
        SCOPED_TRACE(i);
        const SmallScene scene = small_scene(3000 + static_cast<std::uint64_t>(i));
        const Asked asked = expect_packed(scene.a, scene.b, scene.pose);
        all.triangles += asked.triangles;
        all.open += asked.open;
        if (HasFailure()) return;
    }
    // Triangles on a grid touch, and degenerate ones have no plane.
    EXPECT_GT(all.triangles, all.open);
    EXPECT_GT(all.open, 0u);
}

TEST(CollidePacked, FindsWhatBruteForceFindsFarFromTheOrigin) {
    Random random(71);
    for (int i = 0; i < scenes_tried / 50; ++i) {
        SCOPED_TRACE(i);
        const Vec3 away = 1e6 * random_point(random);
        const Mesh a = random_soup(random.next(), 30, 0.5);
        Mesh b = random_soup(random.next(), 30, 0.5);
        Pose pose = random_pose(random, 0.3);
        for (Vec3& v : b.vertices) v += away;
        pose.translation -= rotate(pose.rotation, away);
        expect_packed(BuiltMesh(a), BuiltMesh(b), pose);
        expect_packed(BuiltMesh(b), BuiltMesh(a), inverse(pose));
        if (HasFailure()) return;
    }
}

TEST(CollidePacked, FindsWhatBruteForceFindsInSurfacesThatCross) {
    Random random(72);
    Asked asked;
    for (int i = 0; i < 4; ++i) {
        const Asked some = expect_packed(BuiltMesh(height_field(24)), BuiltMesh(height_field(24)),
                                         {random_rotation(random), {0.1, 0, 0.05}});
        asked.triangles += some.triangles;
        asked.open += some.open;
    }
    EXPECT_GT(asked.triangles, 20 * asked.open) << "floats decide nearly all";
}

// A thin needle stands on a plate with its tip in a corner: its ball touches the plate's slab,
// which normals that are not quite of unit length would miss.
TEST(CollidePacked, FindsANeedleOnAPlate) {
    Random random(73);
    std::size_t pairs = 0;
    for (int i = 0; i < scenes_tried / 2; ++i) {
        SCOPED_TRACE(i);
        Mesh plate = height_field(2);
        for (Vec3& v : plate.vertices) v[2] = 0;
        const Mat3 turn = random_rotation(random);
        for (Vec3& v : plate.vertices) v = 0.001 * rotate(turn, v);
        const Vec3 up = turn.col(2), side = turn.col(0);
        const Vec3 tip = plate.vertices[random.below(9)];
        Mesh needle;
        for (int k = 0; k < 5; ++k)
            needle.vertices.push_back(tip + 0.5 * k * up + (k % 2 ? 1e-6 : 0) * side);
        needle.triangles = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}};
        expect_packed(BuiltMesh(plate), BuiltMesh(needle), {});
        expect_packed(BuiltMesh(needle), BuiltMesh(plate), {});
        pairs += brute_force(plate, needle, {}).size();
        if (HasFailure()) return;
    }
    EXPECT_GE(pairs, static_cast<std::size_t>(scenes_tried / 2));
}

// Plates on each other, face to face and edge to edge, in turned frames.
TEST(CollidePacked, FindsWhatBruteForceFindsWhereMeshesTouch) {
    Random random(74);
    for (int i = 0; i < scenes_tried / 50; ++i) {
        SCOPED_TRACE(i);
        Mesh plate = height_field(4);
        for (Vec3& v : plate.vertices) v[2] = 0;
        const Vec3 shift = random.below(2) == 0 ? Vec3(0.5, 0.125, 0) : Vec3(1, 0.25, 0);
        for (const Pose& pose : {exact_pose(random), random_pose(random)}) {
            Mesh b = plate;
            for (Vec3& v : b.vertices) v = transform_point(inverse(pose), v + shift);
            expect_packed(BuiltMesh(plate), BuiltMesh(b), pose);
        }
        if (HasFailure()) return;
    }
}

// At both ends of the range of floats whose products are still floats, see check_packable.
TEST(CollidePacked, FindsWhatBruteForceFindsInTheSmallestAndTheLargestMeshes) {
    Random random(75);
    for (const double size : {1.1e-8, 0.9e8}) {
        SCOPED_TRACE(size);
        std::size_t pairs = 0;
        for (int i = 0; i < 3; ++i) {
            Mesh a = height_field(12), b = height_field(12);
            for (Mesh* mesh : {&a, &b})
                for (Vec3& v : mesh->vertices) v *= size;
            const Pose pose{random_rotation(random), size * Vec3(0.1, 0, 0.05)};
            expect_packed(BuiltMesh(a), BuiltMesh(b), pose);
            pairs += brute_force(a, b, pose).size();
        }
        EXPECT_GT(pairs, 5u);
    }
}

TEST(CollidePacked, RefusesVolumesThatNoLayoutHas) {
    const BuiltMesh built(height_field(3));
    const PackedLayout layout;
    for (const AnyHierarchy& hierarchy : built.hierarchies) {
        const bool packs = std::holds_alternative<Hierarchy<Scb>>(hierarchy) ||
                           std::holds_alternative<Hierarchy<Scb2>>(hierarchy);
        if (packs) continue;
        EXPECT_THROW(pack_any(layout, hierarchy, built.mesh), InputError);
    }
    EXPECT_THROW(build_packed_any(layout, VolumeKind::obb, built.mesh), InputError);
    const AnyPacked one = pack_any(layout, scb_of<Scb>(built), built.mesh),
                    two = pack_any(layout, scb_of<Scb2>(built), built.mesh);
    EXPECT_THROW(collide_packed(one, built.mesh, two, built.mesh, {}), InputError);
    for (const VolumeKind kind : {VolumeKind::scb, VolumeKind::scb2}) {
        const AnyPacked built_at_once = build_packed_any(layout, kind, built.mesh);
        EXPECT_EQ(built_at_once.index(), (kind == VolumeKind::scb ? one : two).index());
        EXPECT_EQ(validate(built_at_once, built.mesh), "");
    }
}

TEST(CollidePacked, OfALayoutChosenAtRunTime) {
    const BuiltMesh a(height_field(12));
    const Pose pose{Mat3::Identity(), {0.05, 0.03, 0.01}};
    std::set<std::size_t> sizes;
    for (const PackedLayout& layout : all_packed_layouts()) {
        EXPECT_EQ(packed_layout_name(*packed_layout_of(packed_layout_name(layout))),
                  packed_layout_name(layout));
        for (const AnyHierarchy& hierarchy : packable(a)) {
            const AnyPacked packed = pack_any(layout, hierarchy, a.mesh);
            EXPECT_EQ(validate(packed, a.mesh), "");
            EXPECT_EQ(collide_packed(packed, a.mesh, packed, a.mesh, pose).pairs,
                      brute_force(a.mesh, a.mesh, pose));
            sizes.insert(bytes_of(packed));
        }
    }
    EXPECT_EQ(sizes.size(), 2 * all_packed_layouts().size());
    EXPECT_FALSE(packed_layout_of("float3"));
}

TEST(CollidePacked, EndsAtMorePairsThanItMayFind) {
    // Some that floats decide on, and many that they leave open.
    Mesh same{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    same.triangles.assign(150, {0, 1, 2});
    for (const Mesh& mesh : {random_soup(73, 1500, 0.3), same}) {
        const auto hierarchy = build_hierarchy<Scb>(mesh);
        const auto packed = pack<FloatCodec<8>>(hierarchy, mesh);
        const auto found = [&](std::size_t max_pairs, int threads) {
            return collide_packed<FloatCodec<8>>({packed, mesh}, {packed, mesh}, Pose{},
                                                 {SimdLevel::best, threads, max_pairs});
        };
        const std::size_t all = found(1'000'000, 1).pairs.size();
        ASSERT_GT(all, 5000u);
        for (const int threads : {1, 3}) {
            EXPECT_TRUE(found(all, threads).complete);
            EXPECT_EQ(found(all, threads).pairs.size(), all);
            for (const std::size_t few : {all - 1, std::size_t{1}}) {
                EXPECT_FALSE(found(few, threads).complete);
                EXPECT_TRUE(found(few, threads).pairs.empty());
            }
        }
        // It stops early.
        EXPECT_LT(found(1, 1).n_p, found(all, 1).n_p);
    }
}

/// Checks that steps lead from the roots to each test once, and that they are the work of `result`.
template <class Codec>
void expect_steps(const Steps& steps, const PackedHierarchy<Codec>& a,
                  const PackedHierarchy<Codec>& b, const PackedCollision& result) {
    EXPECT_EQ(steps.volumes.size(), result.n_v);
    EXPECT_EQ(steps.items.size(), result.n_p);
    const auto children = [](const PackedHierarchy<Codec>& side, std::uint32_t bits) {
        return side.nodes[PackedRef{bits}.index()].count;
    };
    const auto is_leaf = [](std::uint32_t bits) { return PackedRef{bits}.is_leaf(); };
    std::set<IndexPair> tested;
    std::vector<std::uint32_t> led_to(steps.volumes.size(), 0), items_of(steps.volumes.size(), 0);
    for (std::size_t i = 0; i < steps.volumes.size(); ++i) {
        const Step& step = steps.volumes[i];
        EXPECT_TRUE(tested.insert(step.nodes).second);
        Step from{{a.root.bits, b.root.bits}, 0, 0, Stage::overlapping, no_step};
        if (step.parent != no_step) {
            ASSERT_LT(step.parent, i);
            from = steps.volumes[step.parent];
            ++led_to[step.parent];
        }
        EXPECT_EQ(from.stage, Stage::overlapping);
        EXPECT_EQ(step.depth_a + step.depth_b, from.depth_a + from.depth_b + 1);
        EXPECT_EQ(step.nodes.a == from.nodes.a, step.depth_a == from.depth_a);
        EXPECT_EQ(step.nodes.b == from.nodes.b, step.depth_b == from.depth_b);
        EXPECT_TRUE(step.stage == Stage::overlapping || step.stage == packed_rejection);
    }
    std::vector<IndexPair> hits;
    std::uint32_t before = 0;
    for (const ItemStep& item : steps.items) {
        if (item.hit) hits.push_back(item.items);
        if (item.step == no_step) continue;
        EXPECT_LE(before, item.step);
        before = item.step;
        ++items_of.at(item.step);
    }
    std::sort(hits.begin(), hits.end());
    EXPECT_EQ(hits, result.pairs);
    for (std::size_t i = 0; i < steps.volumes.size(); ++i) {
        const Step& step = steps.volumes[i];
        const auto [node_a, node_b] = step.nodes;
        const bool overlap = step.stage == Stage::overlapping;
        const bool leaves = is_leaf(node_a) && is_leaf(node_b);
        EXPECT_EQ(items_of[i] > 0, overlap && leaves);
        if (!overlap || leaves) {
            EXPECT_EQ(led_to[i], 0u);
            continue;
        }
        // A step whose nodes have one depth, or one of two a leaf, is divided as it is. Else B's
        // node has been divided, and A's children follow.
        const bool divides_b =
            is_leaf(node_a) || (!is_leaf(node_b) && step.depth_a == step.depth_b);
        EXPECT_EQ(led_to[i], divides_b ? children(b, node_b) : children(a, node_a));
    }
}

TEST(CollidePacked, ReportsEachTestToAnObserver) {
    std::size_t hits = 0, rejected = 0;
    const auto expect_observed = [&](const BuiltMesh& a, const BuiltMesh& b, const Pose& pose) {
        for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
            SCOPED_TRACE(name);
            for (const auto corners : {LeafCorners::stored, LeafCorners::in_mesh}) {
                using V = typename Codec::Volume;
                const auto packed_a = pack<Codec>(scb_of<V>(a), a.mesh, 2, corners),
                           packed_b = pack<Codec>(scb_of<V>(b), b.mesh, 2, corners);
                const PackedCollider<Codec> side_a{packed_a, a.mesh}, side_b{packed_b, b.mesh};
                StepRecorder recorder;
                const PackedCollision observed =
                    collide_packed(side_a, side_b, pose, {SimdLevel::best, 3}, recorder);
                expect_same(observed, collide_packed(side_a, side_b, pose));
                expect_steps(recorder.steps, packed_a, packed_b, observed);
                for (const SimdLevel level : available_simd_levels()) {
                    StepRecorder again;
                    expect_same(collide_packed(side_a, side_b, pose, {level}, again), observed);
                    EXPECT_EQ(again.steps, recorder.steps);
                }
                hits += observed.pairs.size();
                for (const Step& step : recorder.steps.volumes)
                    rejected += step.stage == packed_rejection;
            }
        });
    };
    for (int i = 0; i < scenes_tried / 20; ++i) {
        SCOPED_TRACE(i);
        const SmallScene scene = small_scene(7000 + static_cast<std::uint64_t>(i));
        expect_observed(scene.a, scene.b, scene.pose);
        if (HasFailure()) return;
    }
    const BuiltMesh one(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    expect_observed(one, one, {});
    expect_observed(one, BuiltMesh(height_field(8)), {Mat3::Identity(), {0.2, 0.2, 0}});
    expect_observed(BuiltMesh(height_field(24)), one, {Mat3::Identity(), {0.2, 0.2, 0}});
    EXPECT_GT(hits, 0u);
    EXPECT_GT(rejected, hits);
}

TEST(CollidePacked, AnObserverReceivesTheTestsUntilTheQueryGivesUp) {
    const Mesh mesh = random_soup(73, 1500, 0.3);
    const auto packed = build_packed<FloatCodec<8>>(mesh);
    const PackedCollider<FloatCodec<8>> side{packed, mesh};
    StepRecorder recorder;
    const PackedCollision some =
        collide_packed(side, side, Pose{}, {SimdLevel::best, 1, 1}, recorder);
    EXPECT_FALSE(some.complete);
    EXPECT_TRUE(some.pairs.empty());
    EXPECT_EQ(recorder.steps.volumes.size(), some.n_v);
    EXPECT_EQ(recorder.steps.items.size(), some.n_p);
    EXPECT_LT(some.n_v, collide_packed(side, side, Pose{}).n_v);

    struct Thrower {
        int left = 100;
        void volume_test(const Step&) {
            if (left-- == 0) throw InputError("enough");
        }
        void item_test(const ItemStep&) {}
    } thrower;
    EXPECT_THROW(collide_packed(side, side, Pose{}, {}, thrower), InputError);
}

TEST(CollidePacked, OfOneTriangleEach) {
    const Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    expect_packed(BuiltMesh(one), BuiltMesh(one), {});
    expect_packed(BuiltMesh(one), BuiltMesh(one), {Mat3::Identity(), {0, 0, 1}});
    expect_packed(BuiltMesh(one), BuiltMesh(height_field(8)), {Mat3::Identity(), {0.2, 0.2, 0}});
}

TEST(CollidePacked, RefusesWhatFloatsDoNotHold) {
    Mesh mesh{{{0, 0, 0}, {1e9, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const auto message = [&] {
        try {
            pack<FloatCodec<8>>(build_hierarchy<Scb>(mesh), mesh, 4, LeafCorners::stored, "plate");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message().find("plate: packed layouts hold"), 0u);
    mesh.vertices = {{0, 0, 0}, {1e-9, 0, 0}, {0, 1e-9, 0}};
    EXPECT_EQ(message().find("plate: packed layouts hold"), 0u);
    mesh.vertices = {{3, 0, 0}, {3, 0, 0}, {3, 0, 0}};
    EXPECT_EQ(message(), "");
}

TEST(CollidePacked, HasTheSamePairsUnsorted) {
    Random random(76);
    const BuiltMesh a(height_field(24)), b(height_field(24));
    Pose pose;
    pose.rotation = random_rotation(random);
    for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
        SCOPED_TRACE(name);
        const auto of_a = pack<Codec>(scb_of<typename Codec::Volume>(a), a.mesh),
                   of_b = pack<Codec>(scb_of<typename Codec::Volume>(b), b.mesh);
        const PackedCollider from{of_a, a.mesh}, to{of_b, b.mesh};
        const PackedCollision sorted = collide_packed(from, to, pose);
        PackedCollision found = collide_packed(from, to, pose, {.sorted = false});
        EXPECT_GT(found.pairs.size(), 10u);
        EXPECT_NE(found.pairs, sorted.pairs);
        std::sort(found.pairs.begin(), found.pairs.end());
        expect_same(found, sorted);
    });
}

struct Ignore {
    void volume_test(const Step&) {}
    void item_test(const ItemStep&) {}
};

// The balls of the roots show that bodies are far apart, before anything is prepared. A query with
// an observer has no such test, and the same counts.
TEST(CollidePacked, OfBodiesFarApartHasTheCountsOfTheTraversal) {
    const BuiltMesh large(height_field(24)), small(height_field(6)), one(height_field(1));
    int apart = 0;
    for (const BuiltMesh* a : {&large, &small, &one})
        for (const BuiltMesh* b : {&large, &one})
            for_each_layout([&]<class Codec>(LayoutOf<Codec>, const char* name) {
                SCOPED_TRACE(name);
                const auto of_a = pack<Codec>(scb_of<typename Codec::Volume>(*a), a->mesh),
                           of_b = pack<Codec>(scb_of<typename Codec::Volume>(*b), b->mesh);
                const PackedCollider from{of_a, a->mesh}, to{of_b, b->mesh};
                for (int i = 0; i < 60; ++i) {
                    Pose pose;
                    pose.translation = {0.04 * i, 0.03 * i, 0.02 * i};
                    Ignore observer;
                    const PackedCollision watched =
                        collide_packed(from, to, pose, {}, calls_of(observer));
                    const PackedCollision found = collide_packed(from, to, pose);
                    EXPECT_EQ(found.pairs, watched.pairs);
                    EXPECT_EQ(found.n_v, watched.n_v);
                    EXPECT_EQ(found.n_p, watched.n_p);
                    const PackedTouch touch = touches(from, to, pose);
                    EXPECT_EQ(touch.pair.has_value(), !watched.pairs.empty());
                    if (!touch.pair) {
                        EXPECT_EQ(touch.n_v, watched.n_v);
                    }
                    apart += i == 59 && found.pairs.empty();
                }
            });
    EXPECT_GT(apart, 50);
}

}  // namespace
}  // namespace scb
