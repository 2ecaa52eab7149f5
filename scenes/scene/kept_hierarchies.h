#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

#include "core/hierarchy/mesh_topology.h"
#include "scb/any_hierarchy.h"
#include "scenes/scene/scene.h"
#include "scenes/scene/scene_hierarchies.h"

namespace scb::scenes {

/// From now on this process keeps the results of build_topologies and fit_meshes for the latest
/// scene, which copy them for equal requests. For a process that runs several commands.
void keep_hierarchies();

/// The topologies and hierarchies of the latest scene, for commands that would build the same
/// again. Any thread may call its functions.
class KeptHierarchies {
  public:
    /// Nothing if these meshes are no longer, or not yet, the latest.
    std::vector<MeshTopology> topologies(const Scene& scene, SplitMethod split) const;
    /// Forgets everything of other meshes.
    void keep(const Scene& scene, SplitMethod split, const std::vector<MeshTopology>& topologies);

    /// The hierarchies of exactly these topologies; null if they are not kept.
    SharedHierarchies hierarchies(const std::vector<MeshTopology>& topologies, VolumeKind kind,
                                  const FitOptions& options, int deepest) const;
    /// No effect if the topologies are not kept, or too much is kept already.
    void keep(const std::vector<MeshTopology>& topologies, VolumeKind kind,
              const FitOptions& options, int deepest, const SharedHierarchies& hierarchies);

  private:
    struct Fitted {
        SplitMethod split;
        VolumeKind kind;
        FitOptions options;
        int deepest;
        SharedHierarchies hierarchies;
    };
    struct Split {
        SplitMethod method;
        std::vector<MeshTopology> topologies;
    };

    bool are_latest(const Scene& scene) const;
    const Split* split_of(const std::vector<MeshTopology>& topologies) const;

    mutable std::mutex mutex_;
    std::vector<Mesh> meshes_;
    std::vector<Split> splits_;
    std::vector<Fitted> fitted_;
    std::size_t bytes_ = 0;  ///< of hierarchies
};

}  // namespace scb::scenes
