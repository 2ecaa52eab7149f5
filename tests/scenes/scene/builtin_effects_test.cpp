#include "core/analysis/attribution.h"
#include "scenes/scene/builtin.h"
#include "tests/core/analysis/traces.h"
#include "tests/core/hierarchy/built_mesh.h"
#include "tests/scenes/support.h"

// The built-in scenes that were made to show something: that they do, in the frame that they show
// where none is asked for.

namespace scb::scenes {
namespace {

struct Shown {
    Scene scene;
    std::vector<BuiltMesh> meshes;

    explicit Shown(const char* name) : scene(load_builtin(*find_builtin(name))) {
        for (const NamedMesh& mesh : scene.meshes) meshes.emplace_back(mesh.mesh);
    }
    const BuiltMesh& a() const { return meshes[scene.bodies[0].mesh]; }
    const BuiltMesh& b() const { return meshes[scene.bodies[1].mesh]; }
    Pose pose(int frame) const {
        return relative_pose(pose_at(scene.bodies[0].motion, frame),
                             pose_at(scene.bodies[1].motion, frame));
    }
    Collision found(VolumeKind kind, OverlapTest test, int frame) const {
        QueryVariant variant{static_cast<std::size_t>(kind), {}};
        variant.options.overlap.test = test;
        return query(a(), b(), pose(frame), variant);
    }
    Collision found(VolumeKind kind, OverlapTest test) const {
        return found(kind, test, scene.default_frame);
    }
};

TEST(BuiltinScenes, Line8LosesAllPairsToOneWrongRejectionOfThePrintedTest) {
    const Shown shown("line-8");
    const std::size_t pairs = shown.found(VolumeKind::scb, OverlapTest::corrected).pairs.size();
    EXPECT_GE(pairs, 20u);
    EXPECT_LE(pairs, 50u);
    const Collision printed = shown.found(VolumeKind::scb, OverlapTest::printed);
    EXPECT_EQ(printed.pairs.size(), 0u);
    EXPECT_EQ(printed.n_v, 1u);
    EXPECT_EQ(printed.stages[static_cast<std::size_t>(Stage::ball_slab)], 1u);

    // The volumes do overlap, by its certificate.
    const TraceHeader header = asking(VolumeKind::scb, OverlapTest::printed);
    const QueryTrace frame =
        record_frame(shown.a(), shown.b(), 0, shown.pose(shown.scene.default_frame), header);
    const auto kind = static_cast<std::size_t>(VolumeKind::scb);
    const std::vector<IndexPair> contacts =
        shown.found(VolumeKind::scb, OverlapTest::corrected).pairs;
    const Attribution attribution = attribute(shown.a().hierarchies[kind],
                                              shown.b().hierarchies[kind], header, frame, contacts);
    EXPECT_EQ(attribution.wrongly_rejected, (std::vector<WrongRejection>{{0, pairs}}));
}

// Lines 20 and 23 test the cylinder about the small tile against the slab of the large panel; the
// cylinder about the panel reaches through the tile.
TEST(BuiltinScenes, Lines20And23AreAllThatKeepsTheTileFromThePanel) {
    const Shown shown("lines-20-23");
    const Collision corrected = shown.found(VolumeKind::scb, OverlapTest::corrected),
                    line8 = shown.found(VolumeKind::scb, OverlapTest::line8);
    EXPECT_EQ(corrected.n_v, 1u);
    EXPECT_EQ(corrected.stages[static_cast<std::size_t>(Stage::cylinder_slab)], 1u);
    EXPECT_GT(line8.n_v, 10'000 * corrected.n_v);
    // Nearly all that two trees of 4,608 and 2 triangles have.
    EXPECT_GT(line8.n_v, std::uint64_t{2} * 4608 * 2 * 9 / 10);
    EXPECT_EQ(line8.stages[static_cast<std::size_t>(Stage::cylinder_slab)], 0u);
    EXPECT_EQ(line8.pairs.size(), 0u);
    // Slower, but not wrong.
    EXPECT_GT(shown.found(VolumeKind::scb, OverlapTest::line8, 120).pairs.size(), 0u);
    EXPECT_EQ(shown.found(VolumeKind::scb, OverlapTest::line8, 120).pairs,
              shown.found(VolumeKind::scb, OverlapTest::corrected, 120).pairs);
}

TEST(BuiltinScenes, LongTrianglesNeedOneTestOfBoxesAndNearlyAllOfSlabCutBalls) {
    const Shown shown("long-triangles");
    const Collision scb = shown.found(VolumeKind::scb, OverlapTest::symmetric),
                    obb = shown.found(VolumeKind::obb, OverlapTest::symmetric);
    EXPECT_EQ(obb.n_v, 1u);
    EXPECT_GT(scb.n_v, 60'000 * obb.n_v);
    // Most pairs of leaves overlap.
    EXPECT_GT(scb.n_p, std::uint64_t{192} * 192 * 9 / 10);
    EXPECT_EQ(scb.pairs.size(), 0u);
    // Boxes are ahead in contact, too.
    EXPECT_GT(shown.found(VolumeKind::scb, OverlapTest::symmetric, 199).n_v,
              20 * shown.found(VolumeKind::obb, OverlapTest::symmetric, 199).n_v);
}

}  // namespace
}  // namespace scb::scenes
