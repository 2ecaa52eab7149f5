#pragma once

#include "app/study/query_setup.h"
#include "core/analysis/distance_steps.h"
#include "core/distance/placed_corners.h"
#include "core/model/packed_tree.h"
#include "scb/any_collide.h"
#include "scb/any_distance.h"
#include "scb/any_packed.h"
#include "scenes/scene/scene_hierarchies.h"

namespace scb::app {

/// Two bodies by their indices in Scene::bodies; equal in a self query.
using BodyPair = std::array<std::size_t, 2>;

/// Bodies of a scene, ready for queries frame by frame: of two bodies, or of one with itself.
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
    std::optional<DistanceQuery> distance;  ///< what `trace` measures; none: it collides
    Mutation mutation = Mutation::none;
    std::vector<AnyPacked> packed;         ///< per mesh; empty: queries run on `hierarchies`
    std::vector<PackedTree> packed_trees;  ///< per mesh, after trace_packed()

    bool is_self() const { return a == b; }
    QueryKind query_kind() const;
    bool is_packed() const { return !packed.empty(); }
    /// From now on, `collide` runs on hierarchies that are packed in this layout. Its result has
    /// N_v, N_p and pairs only; at `options.max_pairs` of 1 it has the first pair that is found.
    /// Throws InputError if the volumes cannot be packed; `collide` throws it at more pairs than
    /// `options.max_pairs`.
    void pack(const PackedLayout& layout);
    /// After pack(): from now on, `collide` with a recorder is possible, too. Its steps have the
    /// nodes of `hierarchies`.
    void trace_packed();
    /// Sets the bodies of the next query.
    void choose(const BodyPair& pair);
    const Mesh& mesh(std::size_t body) const;
    const AnyHierarchy& hierarchy(std::size_t body) const;
    /// The mesh and the tree of a body.
    MeshTree mesh_tree(std::size_t body) const;
    /// The poses of A and B in the world.
    std::array<Pose, 2> poses(int frame) const;
    /// The pose of B in A's frame.
    Pose b_to_a(int frame) const;
    Collision collide(int frame) const;
    Collision collide(int frame, StepRecorder& recorder) const;
    /// The distance of A and B; they must be two bodies.
    Distance nearest(int frame, const DistanceOptions& limits) const;
    /// The triangles of A and B that are at most this far apart; they must be two bodies.
    Collision within(int frame, double tolerance) const;
    /// The error that a distance of the two bodies may have, see distance_rounding.
    double rounding(int frame) const;
    /// How the tests of a traced query of distances compare with its answer.
    DistanceSteps distance_steps(const TraceHeader& header, const QueryTrace& frame) const;
    /// The query of a frame, of query_kind(), with its steps. The memory of `into` is reused.
    void trace(int frame, QueryTrace& into) const;

  private:
    /// Throws InputError if a packed query gave up.
    Collision whole(Collision found, int frame) const;
    Collision packed_query(int frame) const;
    Collision packed_query(int frame, StepRecorder& recorder) const;
    /// The options with the error of `mutation`; pictures and tables show `options`.
    CollideOptions mutated_options() const;
};

/// The index of the body with this name. Two bodies may also be called A and B.
std::optional<std::size_t> body_named(const scenes::Scene& scene, const std::string& name);

/// The pairs of bodies that a command may query.
enum class QueriedBodies {
    two,       ///< two bodies, or one with itself
    all_pairs  ///< each two bodies of the scene, if no bodies are named
};

/// The bodies in `names` ("pin,bracket", or "pin,pin" for a self query; the only two bodies also as
/// A and B). Without names: the only two, or, if allowed, all pairs in the order of the bodies.
/// Throws InputError if several pairs are left, or a name is no body.
std::vector<BodyPair> body_pairs(const scenes::Scene& scene, const std::string& names,
                                 QueriedBodies bodies = QueriedBodies::two);

/// Checks all options, loads the scene and builds its hierarchies. Throws InputError.
SceneQuery open_query(const SceneOptions& scene, const HierarchyOptions& hierarchy,
                      const QueryOptions& query, const QueryLimits& limits,
                      QueriedBodies bodies = QueriedBodies::two);

/// The parameters of such queries, as in a trace.
TraceHeader trace_header(const SceneOptions& scene, const SceneQuery& query);

/// Notes if two meshes are left at the same pose, and the poses that were replaced by the nearest
/// rotation.
void note_poses(const SceneOptions& options, const scenes::Scene& scene, const Note& note);

/// note_poses, and note_doubts for the query.
void note_doubts(const SceneOptions& options, const scenes::Scene& scene, const QueryOptions& query,
                 const std::vector<VolumeKind>& kinds, const Note& note);

}  // namespace scb::app
