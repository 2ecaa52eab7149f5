#pragma once

#include <memory>
#include <vector>

#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "core/hierarchy/tree_shape.h"
#include "scb/any_hierarchy.h"
#include "scenes/scene/scene.h"

namespace scb::scenes {

/// One per mesh of the scene. Throws InputError, naming the mesh, as check_mesh does.
std::vector<MeshTopology> build_topologies(const Scene& scene, const TopologyOptions& options = {});

/// The deepest level of all topologies.
int deepest(const std::vector<MeshTopology>& topologies);

/// The levels that look different: down to the first level that has 95 of 100 leaves, in all trees
/// together, and the deepest level.
std::vector<int> telling_levels(const std::vector<MeshTopology>& topologies);
std::vector<int> telling_levels(const std::vector<const TreeShape*>& trees);

/// One hierarchy per mesh, without the volumes of deeper nodes, see FittedNodes.
std::vector<AnyHierarchy> fit_meshes(const std::vector<MeshTopology>& topologies, VolumeKind kind,
                                     const BuildOptions& options,
                                     int deepest = FittedNodes{}.deepest);

/// Immutable hierarchies, which several owners may share.
using SharedHierarchies = std::shared_ptr<const std::vector<AnyHierarchy>>;
/// The same as fit_meshes, without a copy if this process keeps them.
SharedHierarchies shared_hierarchies(const std::vector<MeshTopology>& topologies, VolumeKind kind,
                                     const BuildOptions& options,
                                     int deepest = FittedNodes{}.deepest);

}  // namespace scb::scenes
