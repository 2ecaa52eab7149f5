#pragma once

#include "app/query_options.h"
#include "app/scene_hierarchies.h"
#include "core/any_collide.h"

namespace scb {

/// Two bodies of a scene, ready for queries frame by frame.
struct SceneQuery {
    Scene scene;
    std::size_t a = 0, b = 0;               ///< indices of Scene::bodies
    std::vector<MeshTopology> topologies;   ///< per mesh
    std::vector<AnyHierarchy> hierarchies;  ///< per mesh
    CollideOptions options;

    const Mesh& mesh(std::size_t body) const;
    const AnyHierarchy& hierarchy(std::size_t body) const;
    /// The pose of B as A sees it.
    Pose b_to_a(int frame) const;
    Collision collide(int frame) const;
    Collision collide(int frame, EventRecorder& recorder) const;
};

/// The bodies that `names` ("A,B") names, or the only two. Throws InputError where that leaves a
/// choice, or names no body.
std::pair<std::size_t, std::size_t> two_bodies(const Scene& scene, const std::string& names);

/// Loads the scene and builds hierarchies of `kind`. Throws InputError. Notes where two meshes were
/// left at the same pose.
SceneQuery open_query(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                      const QueryOptions& query, VolumeKind kind, const Console& console);

}  // namespace scb
