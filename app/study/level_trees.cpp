#include "app/study/level_trees.h"

#include <algorithm>

#include "app/study/mutation.h"
#include "app/study/scene_query.h"
#include "app/study/scene_setup.h"
#include "render/figures/figure_words.h"
#include "scenes/scene/scene_hierarchies.h"

namespace scb::app {
namespace {

/// The depth of the deepest node whose volume is drawn or counted.
int deepest_of(const std::vector<int>& levels) {
    if (std::find(levels.begin(), levels.end(), leaf_level) != levels.end())
        return FittedNodes{}.deepest;
    return *std::max_element(levels.begin(), levels.end());
}

LevelSubject recorded_subject(const SceneOptions& scene, const std::string& levels) {
    scenes::Recording recording = scenes::read_recording(scene.recording_file());
    scenes::RecordedBodies recorded = scenes::bodies_at(recording, scene.frames);
    LevelSubject subject;
    subject.recorded = true;
    std::vector<const TreeShape*> shapes;
    for (const BodyAtFrame& body : recorded.bodies) {
        shapes.push_back(&body.tree->shape());
        subject.deepest = std::max(subject.deepest, depth(body.tree->shape()));
    }
    // A recorded tree may be a list, with very many levels.
    std::vector<int> telling = scenes::telling_levels(shapes);
    constexpr std::size_t most = 40;
    if (telling.size() > most) {
        std::vector<int> some;
        for (std::size_t i = 0; i < most; ++i)
            some.push_back(telling[i * (telling.size() - 1) / (most - 1)]);
        telling = std::move(some);
    }
    subject.levels = parse_levels(levels, subject.deepest, telling);
    subject.frame = recorded.frame;
    subject.scene = std::move(recording.scene);
    subject.trees.push_back({recording.engine + ", " + recorded.volumes,
                             scenes::file_name_of(recording.engine), std::move(recorded.bodies)});
    return subject;
}

}  // namespace

LevelSubject level_subject(const SceneOptions& of_scene, const HierarchyOptions& hierarchy,
                           const std::string& levels, const std::vector<std::string>& given,
                           const Note& note) {
    if (of_scene.is_recording() && asks_for_recorded(given))
        return recorded_subject(of_scene, levels);
    LevelSubject subject;
    subject.scene = of_scene.load(of_scene.frames);
    const scenes::Scene& scene = subject.scene;
    subject.frame = of_scene.frame_of(scene);
    const std::vector<MeshTopology> topologies =
        scenes::build_topologies(scene, hierarchy.build().topology());
    subject.deepest = scenes::deepest(topologies);
    subject.levels = parse_levels(levels, subject.deepest, scenes::telling_levels(topologies));
    const std::vector<VolumeKind> kinds = hierarchy.kinds();
    note_poses(of_scene, scene, note);
    note_doubts(hierarchy, kinds, note);
    subject.hierarchies.reserve(kinds.size());  // trees refer to them
    for (const VolumeKind kind : kinds) {
        LevelTrees of_kind{
            std::string(render::volume_title(kind)), std::string(volume_kind_name(kind)), {}};
        std::vector<std::shared_ptr<const Tree>> of_mesh;
        for (AnyHierarchy& fitted : subject.hierarchies.emplace_back(scenes::fit_meshes(
                 topologies, kind, hierarchy.build(), deepest_of(subject.levels)))) {
            mutate(hierarchy.mutation, fitted);
            of_mesh.push_back(std::make_shared<const Tree>(fitted));
        }
        // The scene owns the meshes.
        for (const scenes::Body& body : scene.bodies)
            of_kind.bodies.push_back(
                {body.name,
                 {std::shared_ptr<const Mesh>(), &scene.meshes[body.mesh].mesh},
                 of_mesh[body.mesh],
                 pose_at(body.motion, subject.frame)});
        subject.trees.push_back(std::move(of_kind));
    }
    return subject;
}

}  // namespace scb::app
