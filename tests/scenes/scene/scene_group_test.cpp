#include "scenes/scene/scene_group.h"

#include "scenes/scene/builtin.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

TEST(SceneGroups, AreOfBuiltinScenesInTheirOrder) {
    for (const SceneGroup& group : scene_groups) {
        EXPECT_EQ(find_scene_group(group.name), &group);
        EXPECT_EQ(find_builtin(group.name), nullptr);
        std::vector<std::string_view> in_order;
        for (const BuiltinScene& scene : builtin_scenes())
            if (has_scene(group, scene.name)) in_order.push_back(scene.name);
        EXPECT_EQ(in_order,
                  std::vector<std::string_view>(group.scenes.begin(), group.scenes.end()));
    }
    EXPECT_EQ(find_scene_group("dragons"), nullptr);
    EXPECT_FALSE(has_scene(*find_scene_group("table-3"), "dragons"));
}

TEST(SceneGroups, LeaveOutScenesWhoseMeshIsNotThere) {
    const TemporaryFolder models;
    models.write("anchor.ply", "");
    const MeasuredScenes cad = measured_scenes({"cad"}, {}, models.path);
    EXPECT_EQ(cad.names, std::vector<std::string>{"anchor"});
    ASSERT_EQ(cad.left_out.size(), 7u);
    EXPECT_EQ(cad.left_out[0],
              "aatbase is left out: it needs aatbase.ply; name the folder that holds it with "
              "--models DIR or SCB_MODELS.");
    EXPECT_EQ(
        measured_scenes({"table-3"}, {}, {}).names,
        (std::vector<std::string>{"spheres-l1", "spheres-l2", "knots-l1", "knots-l2", "knots-l3"}));
    expect_in("there is no scene to measure: aatbase is left out",
              refusal([] { measured_scenes({"cad"}, {}, {}); }));
}

TEST(SceneGroups, KeepScenesThatAreNamedThemselves) {
    const MeasuredScenes named =
        measured_scenes({"soup", "cad", "horses", "my.json"}, {"cone"}, {});
    EXPECT_EQ(named.names, (std::vector<std::string>{"soup", "horses", "my.json"}));
    EXPECT_EQ(named.left_out.size(), 8u);
}

TEST(SceneGroups, TakeTheDefaultsWhereNoneIsNamed) {
    const MeasuredScenes defaults = measured_scenes({}, {"dragons", "soup"}, {});
    EXPECT_EQ(defaults.names, std::vector<std::string>{"soup"});
    ASSERT_EQ(defaults.left_out.size(), 1u);
    expect_in("dragons is left out", defaults.left_out[0]);
}

}  // namespace
}  // namespace scb::scenes
