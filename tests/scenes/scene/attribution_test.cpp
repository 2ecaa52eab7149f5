#include "core/analysis/attribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/analysis/alternative_test.h"
#include "core/analysis/cost_equation.h"
#include "core/collide/query_placement.h"
#include "core/explain/overlap_steps.h"
#include "core/explain/pair_explanation.h"
#include "scenes/scene/builtin.h"
#include "scenes/shapes/procedural.h"
#include "tests/core/fit/point_sets.h"
#include "tests/scenes/scene/attributed_query.h"
#include "tests/unless_sanitized.h"

// Why pairs passed, on the built-in scenes, recomputed without what attribution.cpp is made of.

namespace scb::scenes {
namespace {

#ifdef SCB_SANITIZED
constexpr int explained_pairs = 20;
constexpr std::size_t most_triangles = 300;
#else
constexpr int explained_pairs = 200;
constexpr std::size_t most_triangles = SIZE_MAX;
#endif

std::set<std::uint32_t> triangles_below(const Topology& topology, std::uint32_t node) {
    const TopologyNode& n = topology.nodes[node];
    return {topology.order.begin() + n.first, topology.order.begin() + n.first + n.count};
}

void check_counts(const AttributedQuery& q) {
    const Attribution& r = q.result;
    const std::vector<Step>& tests = q.frame.steps.volumes;
    std::uint64_t passed = 0;
    for (const Step& test : tests) passed += test.stage == Stage::overlapping;
    EXPECT_EQ(r.passed.size(), passed);
    EXPECT_EQ(r.counts.passed(PassReason::weak_test) + r.counts.passed(PassReason::loose_fit) +
                  r.counts.passed(PassReason::triangles_meet),
              passed);
    EXPECT_EQ(r.counts.all.volume_tests, q.frame.found.n_v);
    EXPECT_EQ(r.counts.all.triangle_tests, q.frame.found.n_p);
    EXPECT_EQ(r.counts.all.operations,
              operation_count(q.header.volume, q.header.options.overlap, q.frame.found.stages));

    // Test by test: wasted is what a false pair led to.
    std::vector<char> is_false(tests.size());
    for (const PassedPair& pair : r.passed)
        is_false[pair.test] = pair.reason != PassReason::triangles_meet;
    Work wasted, useful;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        const std::uint32_t parent = q.frame.steps.volumes[i].parent;
        (parent != no_step && is_false[parent] ? wasted : useful) +=
            {1, 0, operation_cost(q.header.volume, q.header.options.overlap, tests[i].stage)};
    }
    for (const ItemStep& test : q.frame.steps.items)
        ++(is_false[test.step] ? wasted : useful).triangle_tests;
    EXPECT_EQ(r.counts.wasted(), wasted);
    // An exact test saves all tests below a pair that passed a weak test, at any distance.
    std::vector<char> is_weak(tests.size());
    for (const PassedPair& pair : r.passed)
        is_weak[pair.test] = pair.reason == PassReason::weak_test;
    std::uint64_t saved = 0;
    for (std::size_t i = 0; i < tests.size(); ++i)
        for (std::uint32_t at = q.frame.steps.volumes[i].parent; at != no_step;
             at = q.frame.steps.volumes[at].parent)
            if (is_weak[at]) {
                ++saved;
                break;
            }
    EXPECT_EQ(r.counts.wasted_by(PassReason::weak_test).volume_tests, saved);
    // What was not found was missed by a wrong rejection.
    EXPECT_EQ(q.frame.found.pairs.size() + r.counts.missed, q.contacts.size());
    Work sum = useful;
    sum += r.counts.wasted();
    // The time of parts is not known.
    sum.picoseconds = r.counts.all.picoseconds;
    EXPECT_EQ(sum, r.counts.all);
}

/// The same per depth.
void check_depths(const AttributedQuery& q) {
    const Inspection found = inspection(q.frame, q.result);
    DepthInspection sum;
    std::uint64_t by_weak_tests = 0;
    for (const DepthInspection& depth : found.depths) {
        sum.tests += depth.tests;
        sum.wasted += depth.wasted;
        by_weak_tests += depth.wasted.by(PassReason::weak_test);
    }
    EXPECT_EQ(sum.tests, q.frame.found.n_v);
    EXPECT_EQ(sum.wasted.all(), q.result.counts.wasted().volume_tests);
    EXPECT_EQ(by_weak_tests, q.result.counts.wasted_by(PassReason::weak_test).volume_tests);
}

/// By sets of triangles, for some of the pairs.
void check_contacts(const AttributedQuery& q) {
    const std::size_t step = std::max<std::size_t>(1, q.result.passed.size() / 50);
    for (std::size_t k = 0; k < q.result.passed.size(); k += step) {
        const PassedPair& pair = q.result.passed[k];
        const IndexPair nodes = q.frame.steps.volumes[pair.test].nodes;
        const std::set<std::uint32_t> of_a = triangles_below(q.a.topology(), nodes.a),
                                      of_b = triangles_below(q.b.topology(), nodes.b);
        const bool contact =
            std::any_of(q.contacts.begin(), q.contacts.end(), [&](const IndexPair& c) {
                return (of_a.contains(c.a) && of_b.contains(c.b)) ||
                       (q.header.kind == QueryKind::self && of_a.contains(c.b) &&
                        of_b.contains(c.a));
            });
        EXPECT_EQ(contact, pair.reason == PassReason::triangles_meet) << pair.test;
        EXPECT_EQ(pair.reason == PassReason::weak_test,
                  !contact && pair.exact == Contact::disjoint);
    }
}

struct Case {
    int frame = 0;
    VolumeKind kind{};
    OverlapTest test{};
};

/// Every hierarchy and every overlap test, at frames from the whole scene.
std::vector<Case> cases(const Scene& scene) {
#ifdef SCB_SANITIZED
    const std::vector<int> frames = {scene.frames / 5};
#else
    const std::vector<int> frames = {0,
                                     scene.frames / 5,
                                     scene.frames * 2 / 5,
                                     scene.frames * 3 / 5,
                                     scene.frames * 4 / 5,
                                     scene.frames - 1};
#endif
    std::vector<Case> cases;
    for (const int frame : frames)
        for (const VolumeKind kind : all_volume_kinds())
            // The exact verdict on convex volumes is a search, and that on k-DOPs the longest.
            if (kind <= VolumeKind::aabb_exact ||
                (frame == frames[frames.size() / 2] &&
                 unless_sanitized(true, kind == VolumeKind::dop14 || kind >= VolumeKind::rss)))
                for (const OverlapTest test : all_overlap_tests())
                    if (kind == VolumeKind::scb || test == OverlapTest::symmetric)
                        cases.push_back({frame, kind, test});
    return cases;
}

TEST(Attribution, AddsUpOnEveryBuiltinSceneForEveryHierarchyAndTest) {
    std::uint64_t weak = 0, loose = 0, wrong = 0;
    for (const BuiltinScene& builtin : builtin_scenes()) {
        if (!builtin.mesh_files.empty()) continue;
        const Scene scene = load_builtin(builtin);
        if (scene.bodies.size() != 2 || scene.meshes[0].mesh.triangles.size() > most_triangles)
            continue;
        SCOPED_TRACE(builtin.name);
        std::vector<BuiltMesh> meshes;
        for (const NamedMesh& mesh : scene.meshes) meshes.emplace_back(mesh.mesh);
        const BuiltMesh &a = meshes[scene.bodies[0].mesh], &b = meshes[scene.bodies[1].mesh];
        for (const auto& [frame, kind, test] : cases(scene)) {
            const Pose pose = relative_pose(pose_at(scene.bodies[0].motion, frame),
                                            pose_at(scene.bodies[1].motion, frame));
            SCOPED_TRACE(std::string(volume_kind_name(kind)) + " " +
                         std::string(overlap_test_name(test)) + ", frame " + std::to_string(frame));
            const AttributedQuery query(a, b, pose, kind, test);
            check_counts(query);
            check_depths(query);
            check_contacts(query);
            if (kind == VolumeKind::scb && test == OverlapTest::printed)
                wrong += query.result.wrongly_rejected.size();
            else
                EXPECT_EQ(query.result.wrongly_rejected.size(), 0u);
            if (kind != VolumeKind::scb && kind != VolumeKind::scb2 && kind != VolumeKind::aabb) {
                EXPECT_EQ(query.result.counts.passed(PassReason::weak_test), 0u)
                    << "the test of these volumes is exact";
            } else {
                weak += query.result.counts.passed(PassReason::weak_test);
            }
            loose += query.result.counts.passed(PassReason::loose_fit);
        }
    }
    EXPECT_GT(weak, 0u);
    EXPECT_GT(loose, 0u);
    EXPECT_GT(wrong, 0u) << "line 8 as printed rejects volumes that overlap";
}

TEST(Attribution, AddsUpOfABodyAgainstItself) {
    const BuiltMesh body(soup_mesh({300, 0.6, 0.15, 1}));
    for (const VolumeKind kind : {VolumeKind::scb, VolumeKind::obb, VolumeKind::aabb})
        for (const OverlapTest test : {OverlapTest::symmetric, OverlapTest::printed}) {
            SCOPED_TRACE(volume_kind_name(kind));
            const AttributedQuery query(body, body, Pose{}, kind, test, QueryKind::self);
            ASSERT_GT(query.contacts.size(), 50u);
            check_counts(query);
            check_depths(query);
            check_contacts(query);
        }
}

TEST(Attribution, OfAQueryThatEndsAtItsFirstPairCountsOnlyWhatWasTested) {
    const Scene scene = load_builtin(*find_builtin("spheres-l1"));
    const BuiltMesh a(scene.meshes[scene.bodies[0].mesh].mesh),
        b(scene.meshes[scene.bodies[1].mesh].mesh);
    TraceHeader header = asking(VolumeKind::scb, OverlapTest::symmetric);
    const Pose pose =
        relative_pose(pose_at(scene.bodies[0].motion, 60), pose_at(scene.bodies[1].motion, 60));
    const std::vector<IndexPair> contacts =
        collide(a.hierarchies[0], a.mesh, b.hierarchies[0], b.mesh, pose, {}).pairs;
    header.options.max_pairs = 1;
    const QueryTrace frame = record_frame(a, b, 0, pose, header);
    ASSERT_FALSE(frame.found.complete);
    const Attribution r = attribute(a.hierarchies[0], b.hierarchies[0], header, frame, contacts);
    EXPECT_EQ(r.counts.all.volume_tests, frame.found.n_v);
    // The roots are of a pair that meets, although it is not the one that was found.
    EXPECT_EQ(r.passed.front().reason, PassReason::triangles_meet);
}

// The volumes are two discs with one point in common, and so are the triangles.
TEST(Attribution, ARejectionOfVolumesThatTouchIsWrongWhereItLosesTriangles) {
    const BuiltMesh a(Mesh{{{-10, -10, 0}, {10, -10, 0}, {0, 17, 0}}, {{0, 1, 2}}}),
        b(Mesh{{{6, 0, 0}, {6, 0.5, 1}, {6, -0.5, 1}}, {{0, 1, 2}}});
    const AttributedQuery query(a, b, Pose{}, VolumeKind::scb, OverlapTest::printed);
    ASSERT_EQ(query.contacts.size(), 1u);
    ASSERT_EQ(query.frame.found.pairs.size(), 0u);
    ASSERT_EQ(query.result.wrongly_rejected.size(), 1u);
    EXPECT_EQ(query.result.wrongly_rejected[0], (WrongRejection{0, 1, Contact::touching}));
    EXPECT_EQ(query.result.counts.wrongly_rejected, 1u);
    EXPECT_EQ(query.result.counts.missed, 1u);
    check_counts(query);
}

// Near the origin, and at distances from it at which rounding hides small gaps.
TEST(Attribution, VerdictsAreThoseOfTheExplanation) {
    std::map<Contact, int> verdicts;
    Random random(21);
    for (const VolumeKind kind : all_volume_kinds())
        for (const double away : {0.0, 1.0, 1e3, 1e6, 1e9})
            for (int i = 0; i < explained_pairs; ++i) {
                const auto triangle = [&](const Vec3& at) {
                    Mesh mesh{{}, {{0, 1, 2}}};
                    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(at + random_point(random));
                    return mesh;
                };
                const Vec3 at = away * random_point(random);
                const BuiltMesh a(triangle(at)), b(triangle(at));
                Pose pose;
                if (i % 2 == 1) {
                    // To where the two hardly touch, and by as much as may be rounding farther.
                    const double by = std::ldexp(1e-13, static_cast<int>(random.below(30)));
                    pose.translation =
                        (a.mesh.vertices[0] - b.mesh.vertices[0]) + Vec3(by * random_point(random));
                }
                const AttributedQuery query(a, b, pose, kind, OverlapTest::symmetric);
                const auto& of_a = query.a.hierarchies[static_cast<std::size_t>(kind)];
                const auto& of_b = query.b.hierarchies[static_cast<std::size_t>(kind)];
                const Contact explained = std::visit(
                    [&]<class V>(const Hierarchy<V>& h) {
                        const auto& other = std::get<Hierarchy<V>>(of_b);
                        return explain(h.volumes[0], other.volumes[0],
                                       query_placement(h, other, pose), {OverlapTest::symmetric})
                            .certificate.contact;
                    },
                    of_a);
                if (query.result.passed.empty()) {
                    EXPECT_EQ(query.result.wrongly_rejected.size(),
                              explained == Contact::overlapping);
                    continue;
                }
                ++verdicts[explained];
                EXPECT_EQ(contact_names[query.result.passed[0].exact], contact_names[explained])
                    << volume_kind_name(kind) << " at " << away << ", " << i;
            }
    for (const Contact contact : {Contact::disjoint, Contact::overlapping, Contact::touching})
        EXPECT_GT(verdicts[contact], 0) << contact_names[contact];
}

TEST(Attribution, TrianglesAsFarApartAsRoundingTouch) {
    const auto at_height = [](double z) {
        return BuiltMesh(Mesh{{{1e6, 0, z}, {1e6 + 1, 0, z}, {1e6, 1, z}}, {{0, 1, 2}}});
    };
    const BuiltMesh a = at_height(0), b = at_height(2e-8);
    const AttributedQuery query(a, b, Pose{}, VolumeKind::scb, OverlapTest::symmetric);
    ASSERT_EQ(query.result.passed.size(), 1u);
    EXPECT_EQ(query.result.passed[0].exact, Contact::touching);
    EXPECT_EQ(query.result.passed[0].reason, PassReason::loose_fit);
}

TEST(AllContacts, AreThoseOfAFullQueryWhereTheQueryEndedEarly) {
    const Scene scene = load_builtin(*find_builtin("spheres-l1"));
    const BuiltMesh a(scene.meshes[scene.bodies[0].mesh].mesh),
        b(scene.meshes[scene.bodies[1].mesh].mesh);
    const Pose pose =
        relative_pose(pose_at(scene.bodies[0].motion, 60), pose_at(scene.bodies[1].motion, 60));
    for (const VolumeKind kind : all_volume_kinds()) {
        const auto i = static_cast<std::size_t>(kind);
        const std::vector<IndexPair> full =
            collide(a.hierarchies[i], a.mesh, b.hierarchies[i], b.mesh, pose, {}).pairs;
        ASSERT_GT(full.size(), 1u);
        TraceHeader first = asking(kind, OverlapTest::symmetric), coarse = first;
        first.options.max_pairs = 1;
        coarse.options.stop_level = 6;
        for (const TraceHeader& header : {first, coarse}) {
            const QueryTrace frame = record_frame(a, b, 0, pose, header);
            ASSERT_NE(frame.found.pairs, full);
            std::vector<IndexPair> all =
                all_contacts(a.hierarchies[i], a.mesh, b.hierarchies[i], b.mesh, header, frame);
            EXPECT_EQ(all, full) << volume_kind_name(kind);
        }
    }
}

// By the steps of the other test, which are not what it is made of.
TEST(AlternativeTest, CatchesTheWeakPairsThatItRejects) {
    const Scene scene = load_builtin(*find_builtin("spheres-l1"));
    const BuiltMesh a(scene.meshes[scene.bodies[0].mesh].mesh),
        b(scene.meshes[scene.bodies[1].mesh].mesh);
    const Pose pose =
        relative_pose(pose_at(scene.bodies[0].motion, 60), pose_at(scene.bodies[1].motion, 60));
    const AttributedQuery query(a, b, pose, VolumeKind::scb, OverlapTest::corrected);
    const auto &of_a = std::get<Hierarchy<Scb>>(a.hierarchies[0]),
               &of_b = std::get<Hierarchy<Scb>>(b.hierarchies[0]);
    const Placement placed = query_placement(of_a, of_b, pose);
    std::set<std::uint64_t> seen;
    for (const OverlapOptions& other : alternative_tests(query.header)) {
        std::uint64_t caught = 0, weak = 0;
        for (const PassedPair& pair : query.result.passed) {
            if (pair.reason != PassReason::weak_test) continue;
            ++weak;
            const IndexPair nodes = query.frame.steps.volumes[pair.test].nodes;
            caught += overlap_steps(of_a.volumes[nodes.a], of_b.volumes[nodes.b], placed, other)
                          .decisive()
                          .has_value();
        }
        const AlternativeTest found =
            try_alternative_test(a.hierarchies[0], a.mesh, b.hierarchies[0], b.mesh, query.header,
                                 query.frame, query.result, other);
        EXPECT_EQ(found.caught, caught) << overlap_test_name(other.test);
        EXPECT_LT(found.caught, weak);
        EXPECT_EQ(found.pairs, query.contacts.size());
        seen.insert(caught);
    }
    EXPECT_GT(seen.size(), 2u) << "tests that differ";
    EXPECT_GT(*seen.rbegin(), 0u);
}

}  // namespace
}  // namespace scb::scenes
