#pragma once

#include "app/query/query_options.h"
#include "core/analysis/trace.h"
#include "scb/any_collide.h"
#include "scenes/scene/scene_hierarchies.h"

namespace scb::app {

/// Two bodies by their indices in Scene::bodies; equal in a self query.
using BodyPair = std::array<std::size_t, 2>;

/// Bodies of a scene, ready for queries frame by frame: of two of them, or of one with itself.
struct SceneQuery {
    scenes::Scene scene;
    VolumeKind kind = VolumeKind::scb;
    std::vector<int> frames;                ///< the frames to query, ascending
    std::vector<BodyPair> pairs;            ///< the bodies to query, in each frame
    std::size_t a = 0, b = 0;               ///< one of `pairs`: the bodies of the next query
    std::vector<std::uint32_t> joined;      ///< joined_vertices of the mesh of a self query
    std::vector<MeshTopology> topologies;   ///< per mesh
    std::vector<AnyHierarchy> hierarchies;  ///< per mesh
    BuildOptions build;                     ///< of the hierarchies
    CollideOptions options;
    Mutation mutation = Mutation::none;

    bool is_self() const { return a == b; }
    /// Sets the bodies of the next query.
    void choose(const BodyPair& pair);
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

/// The pairs of bodies that a command may query.
enum class QueriedBodies {
    two,       ///< two bodies, or one with itself
    all_pairs  ///< each two bodies of the scene, where no bodies are named
};

/// The bodies that `names` names ("pin,bracket", or "pin,pin" for a self query; the only two also
/// as A and B); without names the only two, or, if allowed, all pairs in the order of the bodies.
/// Throws InputError if several pairs are left, or a name is no body.
std::vector<BodyPair> body_pairs(const scenes::Scene& scene, const std::string& names,
                                 QueriedBodies bodies = QueriedBodies::two);

/// Checks all options, loads the scene and builds its hierarchies. Throws InputError.
SceneQuery open_query(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                      const QueryOptions& query, const QueryLimits& limits,
                      QueriedBodies bodies = QueriedBodies::two);

/// What such queries are asked, as a trace says it.
TraceHeader trace_header(const SceneOptions& scene, const SceneQuery& query);

/// Notes where two meshes are left at the same pose.
void note_same_pose(const SceneOptions& scene, const Console& console);

/// The same, and what note_doubts says.
void note_doubts(const SceneOptions& scene, const QueryOptions& query,
                 const std::vector<VolumeKind>& kinds, const Console& console);

}  // namespace scb::app
