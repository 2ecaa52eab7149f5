#include "tests/core/collide/brute_force.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "scenes/scene/builtin.h"
#include "tests/core/hierarchy/built_mesh.h"
#include "tests/real_models.h"
#include "tests/scenes/support.h"

// The pairs of triangles of the built-in scenes: against brute force where that is possible, and
// their sums over many frames against those that other libraries found.

namespace scb::scenes {
namespace {

constexpr std::size_t brute_force_limit = 5000;  // triangles per body

/// The built-in scenes of two bodies below the limit; each has its test below.
const char* const small_scenes[] = {"knots-l1",   "stack",         "shaft-in-bore", "box-grid",
                                    "flat-plate", "thin-cylinder", "cone",          "soup",
                                    "line-8",     "lines-20-23",   "long-triangles"};

/// A scene of two bodies with hierarchies for its meshes.
struct BuiltScene {
    Scene scene;
    std::vector<BuiltMesh> meshes;

    explicit BuiltScene(const std::string& name) : scene(load_builtin(*find_builtin(name))) {
        for (const NamedMesh& mesh : scene.meshes) meshes.emplace_back(mesh.mesh);
    }
    const BuiltMesh& mesh_of(std::size_t body) const { return meshes[scene.bodies[body].mesh]; }
};

Pose relative_pose_at(const Scene& scene, int frame) {
    return relative_pose(pose_at(scene.bodies[0].motion, frame),
                         pose_at(scene.bodies[1].motion, frame));
}

TEST(BruteForceScenes, AreAllBuiltinScenesOfTwoBodiesBelowTheLimit) {
    std::set<std::string> names;
    for (const BuiltinScene& builtin : builtin_scenes()) {
        if (!builtin.mesh_files.empty()) continue;
        const Scene scene = load_builtin(builtin);
        bool small = scene.bodies.size() == 2;
        for (const NamedMesh& mesh : scene.meshes)
            small = small && mesh.mesh.triangles.size() < brute_force_limit;
        if (small) names.insert(builtin.name);
    }
    EXPECT_EQ(names, std::set<std::string>(std::begin(small_scenes), std::end(small_scenes)));
}

class BruteForce : public testing::TestWithParam<const char*> {};

TEST_P(BruteForce, FindsThePairsOfEveryHierarchyTestAndDescentRule) {
    const BuiltScene built(GetParam());
    const int last = built.scene.frames - 1;
    // Some of the scenes keep their bodies apart, so each is also tried with B pushed.
#ifdef SCB_SANITIZED
    const std::vector<std::pair<int, bool>> cases = {{last / 2, false}, {last * 5 / 8, true}};
#else
    std::vector<std::pair<int, bool>> cases;
    for (const int frame : std::string(GetParam()) == "knots-l1"
                               ? std::vector<int>{0, 250}
                               : std::vector<int>{0, last / 4, last / 2, last * 5 / 8, last})
        for (const bool pushed : {false, true}) cases.emplace_back(frame, pushed);
#endif
    std::size_t pairs = 0;
    for (const auto& [frame, pushed] : cases) {
        Pose pose = relative_pose_at(built.scene, frame);
        if (pushed) {
            pose.translation += Vec3(0.25, 0.2, -0.03);
            pose.rotation = rotation_about(Vec3(1, 2, 0), 3) * pose.rotation;
        }
        const BuiltMesh &a = built.mesh_of(0), &b = built.mesh_of(1);
        const std::vector<IndexPair> expected = brute_force(a.mesh, b.mesh, pose);
        pairs += expected.size();
        for (const QueryVariant& variant : all_query_variants()) {
#ifdef SCB_SANITIZED
            if (variant.options.descent != DescentRule::radius) continue;
#endif
            ASSERT_EQ(query(a, b, pose, variant).pairs, expected)
                << variant.name() << ", frame " << frame;
        }
    }
    EXPECT_GT(pairs, 0u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, BruteForce, testing::ValuesIn(small_scenes), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

/// The pairs of every `step`th frame, and how many of them have a degenerate triangle.
struct PairSum {
    std::size_t pairs = 0, degenerate = 0;
};

PairSum sum_of_pairs(const Scene& scene, VolumeKind kind, OverlapTest test, int step) {
    std::vector<AnyHierarchy> hierarchies;
    for (const NamedMesh& mesh : scene.meshes) {
        const auto topology = std::make_shared<const Topology>(build_topology(mesh.mesh));
        hierarchies.push_back(fit_any(kind, topology, leaf_order(mesh.mesh, *topology)));
    }
    const std::size_t a = scene.bodies[0].mesh, b = scene.bodies[1].mesh;
    const Mesh &mesh_a = scene.meshes[a].mesh, &mesh_b = scene.meshes[b].mesh;
    CollideOptions options;
    options.overlap.test = test;
    PairSum sum;
    for (int frame = 0; frame < scene.frames; frame += step) {
        const Collision found = collide(hierarchies[a], mesh_a, hierarchies[b], mesh_b,
                                        relative_pose_at(scene, frame), options);
        sum.pairs += found.pairs.size();
        for (const IndexPair& pair : found.pairs)
            sum.degenerate += is_degenerate(mesh_a, pair.a) || is_degenerate(mesh_b, pair.b);
    }
    return sum;
}

TEST(PairSums, OfEveryTenthFrameOfTheSpheresAreThoseOfEveryHierarchy) {
    const Scene scene = load_builtin(*find_builtin("spheres-l1"));
#ifdef SCB_SANITIZED
    const std::array kinds = {VolumeKind::scb};
#else
    const auto kinds = all_volume_kinds();
#endif
    for (const VolumeKind kind : kinds)
        EXPECT_EQ(sum_of_pairs(scene, kind, OverlapTest::symmetric, 10).pairs, 27'095u)
            << volume_kind_name(kind);
}

#ifndef SCB_SANITIZED
TEST(PairSums, OfTheSpheresAreTheRecordedOnes) {
    const Scene scene = load_builtin(*find_builtin("spheres-l1"));
    EXPECT_EQ(sum_of_pairs(scene, VolumeKind::scb, OverlapTest::corrected, 1).pairs, 268'472u);
}

/// A scene with meshes from files, and what libraries found in it.
struct RecordedSum {
    const char* name;
    int step;
    std::size_t pairs, degenerate;  ///< the latter among the former
};

class ModelPairSums : public testing::TestWithParam<RecordedSum> {};

TEST_P(ModelPairSums, AreTheRecordedOnes) {
    const BuiltinScene& builtin = *find_builtin(GetParam().name);
    for (const std::string& file : builtin.mesh_files)
        if (!has_model_file(file, "the sum of pairs of " + builtin.name)) GTEST_SKIP();
    const Scene scene = load_builtin(builtin, models_folder());
    const PairSum sum =
        sum_of_pairs(scene, VolumeKind::scb, OverlapTest::symmetric, GetParam().step);
    EXPECT_EQ(sum.pairs, GetParam().pairs);
    EXPECT_EQ(sum.degenerate, GetParam().degenerate);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, ModelPairSums,
    testing::Values(RecordedSum{"horses", 1, 505'029, 0}, RecordedSum{"hands", 1, 447'610, 0},
                    RecordedSum{"dragons", 25, 101'893, 5}, RecordedSum{"aatbase", 10, 47'551, 0},
                    RecordedSum{"tray_bottom", 10, 22'810, 0}, RecordedSum{"boeing", 10, 31'988, 0},
                    RecordedSum{"cheese", 10, 732'869, 0}, RecordedSum{"tr12j", 10, 225'157, 0},
                    RecordedSum{"anchor", 10, 28'004, 0}, RecordedSum{"cycloidal", 50, 561'512, 0},
                    RecordedSum{"tube", 10, 15'322, 0}),
    [](const auto& test) { return std::string(test.param.name); });
#endif

}  // namespace
}  // namespace scb::scenes
