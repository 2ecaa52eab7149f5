#pragma once

#include "app/query/query_options.h"
#include "core/analysis/trace.h"
#include "scb/any_collide.h"
#include "scenes/scene/scene_hierarchies.h"

namespace scb::app {

/// Two bodies of a scene, or one against itself, ready for queries frame by frame.
struct SceneQuery {
    scenes::Scene scene;
    VolumeKind kind = VolumeKind::scb;
    std::vector<int> frames;                ///< those asked for, ascending
    std::size_t a = 0, b = 0;               ///< indices of Scene::bodies; equal in a self query
    std::vector<std::uint32_t> joined;      ///< joined_vertices of the mesh of a self query
    std::vector<MeshTopology> topologies;   ///< per mesh
    std::vector<AnyHierarchy> hierarchies;  ///< per mesh
    BuildOptions build;                     ///< of the hierarchies
    CollideOptions options;
    Mutation mutation = Mutation::none;

    bool is_self() const { return a == b; }
    const Mesh& mesh(std::size_t body) const;
    const AnyHierarchy& hierarchy(std::size_t body) const;
    /// Where A and B are.
    std::array<Pose, 2> poses(int frame) const;
    /// The pose of B as A sees it.
    Pose b_to_a(int frame) const;
    Collision collide(int frame) const;
    Collision collide(int frame, StepRecorder& recorder) const;

  private:
    /// What is asked, which pictures and tables say, with the error that the mutation puts into it.
    CollideOptions mutated_options() const;
};

/// The bodies that `names` names ("pin,bracket", or "pin,pin" for a self query; the only two also
/// as A and B), or the only two. Throws InputError where that leaves a choice, or names no body.
std::pair<std::size_t, std::size_t> two_bodies(const scenes::Scene& scene,
                                               const std::string& names);

/// Checks everything that was asked, loads the scene and builds its hierarchies. Throws InputError.
SceneQuery open_query(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                      const QueryOptions& query, const QueryLimits& limits);

/// What such queries are asked, as a trace says it.
TraceHeader trace_header(const SceneOptions& scene, const SceneQuery& query);

/// Notes where two meshes are left at the same pose.
void note_same_pose(const SceneOptions& scene, const Console& console);

/// The same, and what note_doubts says.
void note_doubts(const SceneOptions& scene, const QueryOptions& query,
                 const std::vector<VolumeKind>& kinds, const Console& console);

}  // namespace scb::app
