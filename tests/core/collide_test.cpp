#include "core/collide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "core/level_cover.h"
#include "tests/core/brute_force.h"
#include "tests/core/volume_pairs.h"

namespace scb {
namespace {

#ifdef SCB_SANITIZED
constexpr int scenes_tried = 100;
#else
constexpr int scenes_tried = 1000;
#endif

// -------------------------------------------------------------------------------- small scenes

// Corners on a grid of dyadic coordinates, most of them shared.
Mesh grid_soup(Random& random, int count, std::uint32_t size) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        Triangle t;
        for (std::uint32_t& corner : t) {
            if (mesh.vertices.size() > 2 && random.below(3) == 0) {
                corner = random.below(static_cast<std::uint32_t>(mesh.vertices.size()));
                continue;
            }
            corner = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.emplace_back(random.below(size) / 4.0, random.below(size) / 4.0,
                                       random.below(size) / 4.0);
        }
        mesh.triangles.push_back(t);
    }
    return mesh;
}

// A flat patch of a height that is one of few, so that two of them are coplanar now and then.
Mesh flat_patch(Random& random, int count) {
    Mesh mesh = height_field(4);
    const double height = random.below(2) / 4.0;
    for (Vec3& v : mesh.vertices) v[2] = height;
    mesh.triangles.resize(static_cast<std::size_t>(std::min(count, 32)));
    return mesh;
}

void degenerate_some(Mesh& mesh, Random& random) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Triangle& t = mesh.triangles[i];
        const std::uint32_t kind = random.below(12);
        if (kind == 0) t[1] = t[0];
        if (kind == 1) t[1] = t[2] = t[0];
        if (kind == 2) t = mesh.triangles[random.below(static_cast<std::uint32_t>(i + 1))];
        if (kind == 3) mesh.vertices[t[2]] = (mesh.vertices[t[0]] + mesh.vertices[t[1]]) / 2;
    }
}

Mesh small_mesh(Random& random, int count) {
    const std::uint32_t kind = random.below(4);
    Mesh mesh = kind == 0   ? random_soup(random.next(), count, 0.3)
                : kind == 1 ? random_soup(random.next(), count, 1)
                : kind == 2 ? grid_soup(random, count, 3 + random.below(6))
                            : flat_patch(random, count);
    if (random.below(2) == 0) degenerate_some(mesh, random);
    return mesh;
}

Mat3 random_quarter_turn(Random& random) {
    Mat3 m = Mat3::Zero();
    const int first = static_cast<int>(random.below(3));
    const int step = 1 + static_cast<int>(random.below(2));
    for (int k = 0; k < 3; ++k) m((first + step * k) % 3, k) = random.below(2) == 0 ? 1 : -1;
    if (dot(cross(Vec3(m.col(0)), Vec3(m.col(1))), Vec3(m.col(2))) < 0) m.col(0) *= -1;
    return m;
}

// Transforms dyadic coordinates without rounding, there and back.
Pose exact_pose(Random& random) {
    const auto part = [&] { return (static_cast<int>(random.below(9)) - 4) / 8.0; };
    return {random_quarter_turn(random), {part(), part(), part()}};
}

Pose small_pose(Random& random) {
    const std::uint32_t kind = random.below(4);
    if (kind == 0) return {};
    if (kind == 1) return exact_pose(random);
    return random_pose(random);
}

struct SmallScene {
    BuiltMesh a, b;
    Pose pose;
};

SmallScene small_scene(std::uint64_t seed) {
    Random random(seed);
    const auto count = [&] { return 1 + static_cast<int>(random.below(40)); };
    const Mesh a = small_mesh(random, count());
    if (random.below(5) == 0) return {BuiltMesh(a), BuiltMesh(a), Pose{}};
    return {BuiltMesh(a), BuiltMesh(small_mesh(random, count())), small_pose(random)};
}

// ----------------------------------------------------------------------- what must always hold

template <class V>
double size_by(DescentRule rule, const V& v) {
    if (rule == DescentRule::radius) return descent_size(v);
    return rule == DescentRule::area ? surface_area(v) : volume(v);
}

/// Traverses as the recorded events say and expects them to be a dual traversal of both trees.
template <class V>
void expect_traversal(const Hierarchy<V>& a, const Hierarchy<V>& b, const Events& events,
                      const CollideOptions& options) {
    const std::vector<TopologyNode>&nodes_a = a.topology->nodes, &nodes_b = b.topology->nodes;
    const auto& tests = events.volume_tests;
    std::size_t next = 0, next_triangle = 0;
    std::vector<VolumeTest> pending;
    const auto at_end_a = [&](const VolumeTest& t) {
        return nodes_a[t.nodes.a].is_leaf() || t.depth_a == options.stop_level;
    };
    const auto at_end_b = [&](const VolumeTest& t) {
        return nodes_b[t.nodes.b].is_leaf() || t.depth_b == options.stop_level;
    };
    // Takes the next test, which must be this one.
    const auto take = [&](std::uint32_t i, std::uint32_t j, int depth_a, int depth_b) {
        ASSERT_LT(next, tests.size());
        const VolumeTest& t = tests[next];
        ASSERT_EQ(t.nodes, (IndexPair{i, j})) << next;
        ASSERT_EQ(t.depth_a, depth_a);
        ASSERT_EQ(t.depth_b, depth_b);
        if (t.stage == Stage::overlapping) {
            if (!at_end_a(t) || !at_end_b(t)) {
                pending.push_back(t);
            } else if (options.stop_level < 0) {
                ASSERT_LT(next_triangle, events.triangle_tests.size());
                const TriangleTest& triangles = events.triangle_tests[next_triangle++];
                ASSERT_EQ(triangles.after, next);
                ASSERT_EQ(triangles.triangles, (IndexPair{a.topology->order[nodes_a[i].first],
                                                          b.topology->order[nodes_b[j].first]}));
            }
        }
        ++next;
    };
    ASSERT_NO_FATAL_FAILURE(take(0, 0, 0, 0));
    while (!pending.empty()) {
        const VolumeTest t = pending.back();
        pending.pop_back();
        bool into_a = !at_end_a(t);
        if (into_a && !at_end_b(t))
            into_a = options.descent == DescentRule::alternating
                         ? (t.depth_a + t.depth_b) % 2 == 0
                         : size_by(options.descent, a.volumes[t.nodes.a]) >=
                               size_by(options.descent, b.volumes[t.nodes.b]);
        for (const std::uint32_t side : {0u, 1u}) {
            if (into_a)
                ASSERT_NO_FATAL_FAILURE(
                    take(nodes_a[t.nodes.a].left + side, t.nodes.b, t.depth_a + 1, t.depth_b));
            else
                ASSERT_NO_FATAL_FAILURE(
                    take(t.nodes.a, nodes_b[t.nodes.b].left + side, t.depth_a, t.depth_b + 1));
        }
    }
    EXPECT_EQ(next, tests.size());
    EXPECT_EQ(next_triangle, events.triangle_tests.size());
}

std::uint64_t transforms_of(const VolumeTest& t, const QueryVariant& variant) {
    if (variant.volume_kind() == VolumeKind::obb) return 4;
    if (variant.volume_kind() != VolumeKind::scb || t.stage == Stage::ball_ball) return 1;
    const bool extents = variant.options.overlap.test == OverlapTest::extents;
    return t.stage == Stage::slab_ball && !extents ? 1 : 2;
}

void expect_same(const Collision& a, const Collision& b) {
    EXPECT_EQ(a.pairs, b.pairs);
    EXPECT_EQ(a.n_v, b.n_v);
    EXPECT_EQ(a.n_p, b.n_p);
    EXPECT_EQ(a.n_u, b.n_u);
    EXPECT_EQ(a.stages, b.stages);
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(a.complete, b.complete);
}

// The counts are those of the events, the pairs are those that the events found.
void expect_counts_of_events(const Collision& found, const Events& events,
                             const QueryVariant& variant) {
    StageCounts stages{};
    std::uint64_t transforms = 0, sum = 0;
    int depth = 0;
    std::set<IndexPair> nodes;
    for (const VolumeTest& t : events.volume_tests) {
        ++stages[static_cast<std::size_t>(t.stage)];
        transforms += transforms_of(t, variant);
        depth = std::max(depth, t.depth_a + t.depth_b);
        nodes.insert(t.nodes);
    }
    for (const std::uint64_t count : found.stages) sum += count;
    EXPECT_EQ(nodes.size(), events.volume_tests.size()) << "a pair was tested twice";
    EXPECT_EQ(found.stages, stages);
    EXPECT_EQ(found.n_v, sum);
    EXPECT_EQ(found.n_v, events.volume_tests.size());
    EXPECT_EQ(found.n_p, events.triangle_tests.size());
    EXPECT_EQ(found.n_u, transforms);
    EXPECT_EQ(found.depth, depth);
    if (variant.options.stop_level >= 0) return;
    std::vector<IndexPair> pairs;
    for (const TriangleTest& t : events.triangle_tests)
        if (t.intersect) pairs.push_back(t.triangles);
    std::sort(pairs.begin(), pairs.end());
    EXPECT_EQ(found.pairs, pairs);
}

// Everything about one query; it must find `expected`.
void expect_query(const BuiltMesh& a, const BuiltMesh& b, const Pose& pose,
                  const QueryVariant& variant, const std::vector<IndexPair>& expected) {
    SCOPED_TRACE(variant.name());
    EventRecorder recorder;
    const Collision found = query(a, b, pose, variant, recorder);
    EXPECT_EQ(found.pairs, expected);
    EXPECT_TRUE(found.complete);
    expect_counts_of_events(found, recorder.events, variant);
    expect_same(query(a, b, pose, variant), found);
    std::visit(
        [&]<class V>(const Hierarchy<V>& hierarchy) {
            expect_traversal(hierarchy, std::get<Hierarchy<V>>(b.hierarchies[variant.kind]),
                             recorder.events, variant.options);
        },
        a.hierarchies[variant.kind]);
}

void expect_queries(const BuiltMesh& a, const BuiltMesh& b, const Pose& pose) {
    const std::vector<IndexPair> expected = brute_force(a.mesh, b.mesh, pose);
    for (const QueryVariant& variant : all_query_variants()) {
        expect_query(a, b, pose, variant, expected);
        if (testing::Test::HasFailure()) return;
    }
}

TEST(Collide, FindsWhatBruteForceFindsInSmallScenes) {
    std::size_t with_pairs = 0, without = 0;
    for (int i = 0; i < scenes_tried; ++i) {
        SCOPED_TRACE("scene " + std::to_string(i));
        const SmallScene s = small_scene(1000 + static_cast<std::uint64_t>(i));
        expect_queries(s.a, s.b, s.pose);
        ++(brute_force(s.a.mesh, s.b.mesh, s.pose).empty() ? without : with_pairs);
        if (HasFailure()) return;
    }
    EXPECT_GT(with_pairs, scenes_tried / 3);
    EXPECT_GT(without, scenes_tried / 50);
}

TEST(Collide, FindsWhatBruteForceFindsInMeshesOfFewTriangles) {
    for (const int count_a : {1, 2, 7, 8, 9})
        for (const int count_b : {1, 2, 7, 8, 9})
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                const Mesh a = random_soup(seed, count_a, 1.5),
                           b = random_soup(seed + 10, count_b, 1.5);
                SCOPED_TRACE(std::to_string(count_a) + " and " + std::to_string(count_b));
                expect_queries(BuiltMesh(a), BuiltMesh(b), Pose{});
            }
}

TEST(Collide, FindsAPointOnAPoint) {
    const Mesh point{{{1, 2, 3}}, {{0, 0, 0}}};
    const BuiltMesh built(point);
    Pose pose;
    EXPECT_EQ(brute_force(point, point, pose).size(), 1u);
    expect_queries(built, built, pose);
    pose.translation[0] = 1;
    EXPECT_EQ(brute_force(point, point, pose).size(), 0u);
    expect_queries(built, built, pose);
}

TEST(Collide, FindsEveryPairOfTrianglesThatAreAllTheSame) {
    Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    mesh.triangles.assign(33, {0, 1, 2});
    const BuiltMesh built(mesh);
    EXPECT_EQ(brute_force(mesh, mesh, Pose{}).size(), 33u * 33u);
    expect_queries(built, built, Pose{});
}

// Half the way to the origin each time, which attacks the depth of the tree.
Mesh halving_mesh(int count) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const double s = std::ldexp(1.0, -i);
        const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(),
                             {Vec3(s, 0, 0), Vec3(s, s / 4, 0), Vec3(s, 0, s)});
        mesh.triangles.push_back({v, v + 1, v + 2});
    }
    return mesh;
}

TEST(Collide, FindsWhatBruteForceFindsWherePositionsAttackTheDepth) {
    const BuiltMesh a(halving_mesh(100));
    EXPECT_GT(depth(a.topology()), 8);
    expect_queries(a, a, Pose{});
    expect_queries(a, a, {Mat3::Identity(), {0, std::ldexp(1.0, -20), 0}});
}

// A tree that takes one triangle off at each node, much deeper than build_topology's ever are.
Topology chain(std::uint32_t count) {
    Topology topology;
    topology.nodes.push_back({0, count, 0});
    for (std::uint32_t k = 0; k + 1 < count; ++k) {
        const auto left = static_cast<std::uint32_t>(topology.nodes.size());
        topology.nodes.back().left = left;
        topology.nodes.push_back({k, 1, 0});
        topology.nodes.push_back({k + 1, count - k - 1, 0});
    }
    topology.rules.assign(topology.nodes.size(), SplitRule::index);
    for (std::uint32_t i = 0; i < count; ++i) topology.order.push_back(i);
    return topology;
}

TEST(Collide, TakesTreesThatAreAsDeepAsTheirTriangles) {
#ifdef SCB_SANITIZED
    constexpr std::uint32_t count = 150;
#else
    constexpr std::uint32_t count = 400;
#endif
    const Mesh mesh = random_soup(55, count, 0.05);
    const BuiltMesh a(mesh, chain(count));
    ASSERT_EQ(validate(a.topology(), mesh), "");
    EXPECT_EQ(depth(a.topology()), static_cast<int>(count) - 1);
    const Pose pose{Mat3::Identity(), {0.01, 0.02, 0}};
    const std::vector<IndexPair> expected = brute_force(mesh, mesh, pose);
    EXPECT_FALSE(expected.empty());
    for (const QueryVariant& variant : all_query_variants()) {
        if (variant.options.descent != DescentRule::radius) continue;
        const Collision found = query(a, a, pose, variant);
        EXPECT_EQ(found.pairs, expected) << variant.name();
        EXPECT_GT(found.depth, static_cast<int>(count)) << variant.name();
    }
}

// ----------------------------------------------------------------------------- poses and rounding

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

// ------------------------------------------------------------------------------------- options

TEST(CollideMaxPairs, EndsTheQueryWithSoManyOfAllPairs) {
    const BuiltMesh a(random_soup(61, 60, 0.4)), b(random_soup(62, 60, 0.4));
    const std::vector<IndexPair> all = brute_force(a.mesh, b.mesh, Pose{});
    ASSERT_GT(all.size(), 20u);
    for (QueryVariant variant : all_query_variants()) {
        SCOPED_TRACE(variant.name());
        const Collision whole = query(a, b, Pose{}, variant);
        std::uint64_t tests = 0;
        for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{7},
                                        all.size() - 1, all.size(), all.size() + 1}) {
            variant.options.max_pairs = count;
            EventRecorder recorder;
            const Collision found = query(a, b, Pose{}, variant, recorder);
            EXPECT_EQ(found.pairs.size(), std::min(count, all.size()));
            EXPECT_TRUE(
                std::includes(all.begin(), all.end(), found.pairs.begin(), found.pairs.end()));
            EXPECT_EQ(found.complete, count > all.size());
            expect_counts_of_events(found, recorder.events, variant);
            expect_same(query(a, b, Pose{}, variant), found);
            if (!found.complete) {
                // It ended at once, with the test that found the last pair.
                EXPECT_TRUE(recorder.events.triangle_tests.back().intersect);
                EXPECT_EQ(recorder.events.triangle_tests.back().after + 1,
                          recorder.events.volume_tests.size());
            }
            EXPECT_GT(found.n_v, tests - (found.complete ? 1 : 0));
            tests = found.n_v;
        }
        EXPECT_LE(tests, whole.n_v);
    }
}

TEST(CollideMaxPairs, IsCompleteWhereNothingIsFound) {
    const BuiltMesh a(random_soup(61, 20, 0.1)), b(random_soup(62, 20, 0.1));
    for (QueryVariant variant : all_query_variants()) {
        variant.options.max_pairs = 1;
        const Collision found = query(a, b, {Mat3::Identity(), {9, 0, 0}}, variant);
        EXPECT_TRUE(found.pairs.empty());
        EXPECT_TRUE(found.complete);
        EXPECT_EQ(found.n_v, 1u);
    }
}

// Pairs of the two covers that overlap by the test itself, one by one.
std::vector<IndexPair> overlapping_in_covers(const BuiltMesh& a, const BuiltMesh& b,
                                             const Pose& pose, const QueryVariant& variant) {
    const int level = variant.options.stop_level;
    std::vector<IndexPair> pairs;
    std::visit(
        [&]<class V>(const Hierarchy<V>& p) {
            const auto& q = std::get<Hierarchy<V>>(b.hierarchies[variant.kind]);
            const Placement placed = query_placement(p, q, pose);
            with_overlap_test<V>(variant.options.overlap, [&](const auto& test) {
                for (const std::uint32_t i : level_cover(*p.topology, level))
                    for (const std::uint32_t j : level_cover(*q.topology, level))
                        if (test(p.volumes[i], q.volumes[j], placed) == Stage::overlapping)
                            pairs.push_back({i, j});
            });
        },
        a.hierarchies[variant.kind]);
    return pairs;
}

// The node of the cover that holds each triangle.
std::vector<std::uint32_t> cover_node_of(const Topology& topology, int level) {
    std::vector<std::uint32_t> node_of(topology.order.size());
    for (const std::uint32_t node : level_cover(topology, level))
        for (std::uint32_t k = 0; k < topology.nodes[node].count; ++k)
            node_of[topology.order[topology.nodes[node].first + k]] = node;
    return node_of;
}

// A volume may stick out of its parent's, so a pair that overlaps may have ancestors that do not:
// the pairs found are some of those of the two covers that overlap, and all whose triangles
// intersect are among them.
TEST(CollideStopLevel, FindsPairsOfTheCoversThatOverlapAndAllThatHoldIntersections) {
    const BuiltMesh a(random_soup(63, 80, 0.4)), b(random_soup(64, 60, 0.4));
    Random random(65);
    const Pose pose = random_pose(random, 0.2);
    const std::vector<IndexPair> triangles = brute_force(a.mesh, b.mesh, pose);
    ASSERT_GT(triangles.size(), 20u);
    const int deepest = std::max(depth(a.topology()), depth(b.topology()));
    std::size_t left_out = 0;
    for (QueryVariant variant : all_query_variants())
        for (int level = 0; level <= deepest + 1; ++level) {
            variant.options.stop_level = level;
            SCOPED_TRACE(variant.name() + ", level " + std::to_string(level));
            EventRecorder recorder;
            const Collision found = query(a, b, pose, variant, recorder);
            const std::vector<IndexPair> covers = overlapping_in_covers(a, b, pose, variant);
            EXPECT_TRUE(std::includes(covers.begin(), covers.end(), found.pairs.begin(),
                                      found.pairs.end()));
            left_out += covers.size() - found.pairs.size();
            const auto node_a = cover_node_of(a.topology(), level),
                       node_b = cover_node_of(b.topology(), level);
            for (const IndexPair& t : triangles)
                EXPECT_TRUE(std::binary_search(found.pairs.begin(), found.pairs.end(),
                                               IndexPair{node_a[t.a], node_b[t.b]}));
            EXPECT_TRUE(found.complete);
            EXPECT_EQ(found.n_p, 0u);
            EXPECT_LE(found.depth, 2 * level);
            expect_counts_of_events(found, recorder.events, variant);
            expect_same(query(a, b, pose, variant), found);
            std::visit(
                [&]<class V>(const Hierarchy<V>& hierarchy) {
                    expect_traversal(hierarchy, std::get<Hierarchy<V>>(b.hierarchies[variant.kind]),
                                     recorder.events, variant.options);
                },
                a.hierarchies[variant.kind]);
            if (level == 0) {
                EXPECT_EQ(found.pairs, (std::vector<IndexPair>{{0, 0}}));
            }
            if (HasFailure()) return;
        }
    EXPECT_GT(left_out, 0u);  // else the sentence above says less than it could
}

TEST(CollideStopLevel, EndsAtMaxPairsToo) {
    const BuiltMesh a(random_soup(63, 80, 0.3));
    for (QueryVariant variant : all_query_variants()) {
        variant.options.stop_level = 3;
        const Collision all = query(a, a, Pose{}, variant);
        ASSERT_GT(all.pairs.size(), 8u);
        variant.options.max_pairs = 5;
        const Collision some = query(a, a, Pose{}, variant);
        EXPECT_EQ(some.pairs.size(), 5u);
        EXPECT_FALSE(some.complete);
        EXPECT_TRUE(std::includes(all.pairs.begin(), all.pairs.end(), some.pairs.begin(),
                                  some.pairs.end()));
    }
}

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
        const auto stages = stages_of(s.a.hierarchies[variant.kind], variant.options.overlap);
        const Collision found = query(s.a, s.b, s.pose, variant);
        for (std::size_t k = 1; k < stage_count; ++k) {
            if (std::find(stages.begin(), stages.end(), static_cast<Stage>(k)) != stages.end())
                continue;
            EXPECT_EQ(found.stages[k], 0u) << stage_name(static_cast<Stage>(k));
        }
    }
}

TEST(CollideTemplate, TakesAnyObserverAndHierarchiesOfOneType) {
    struct Counter {
        std::uint64_t volumes = 0, triangles = 0, intersections = 0;
        void volume_test(IndexPair, int, int, Stage) { ++volumes; }
        void triangle_test(IndexPair, bool intersect) {
            ++triangles;
            intersections += intersect;
        }
    };
    const Mesh a = random_soup(66, 40, 0.4), b = random_soup(67, 40, 0.4);
    const auto hierarchy_a = build_hierarchy<Scb>(a), hierarchy_b = build_hierarchy<Scb>(b);
    const Collider<Scb> collider_a{hierarchy_a, a}, collider_b{hierarchy_b, b};
    Counter counter;
    const Collision found = collide(collider_a, collider_b, Pose{}, {}, counter);
    EXPECT_EQ(counter.volumes, found.n_v);
    EXPECT_EQ(counter.triangles, found.n_p);
    EXPECT_EQ(counter.intersections, found.pairs.size());
    expect_same(collide(collider_a, collider_b, Pose{}), found);
    expect_same(query(BuiltMesh(a), BuiltMesh(b), Pose{}, QueryVariant{0, {}}), found);
}

}  // namespace
}  // namespace scb

namespace scb {
namespace {

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
