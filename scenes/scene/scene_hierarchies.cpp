#include "scenes/scene/scene_hierarchies.h"

#include <algorithm>

#include "core/hierarchy/fit_volumes.h"
#include "scb/level_cover.h"
#include "scenes/scene/kept_hierarchies.h"

namespace scb::scenes {

namespace {

/// Null unless the process keeps hierarchies.
KeptHierarchies*& kept() {
    static KeptHierarchies* hierarchies = nullptr;
    return hierarchies;
}

std::vector<AnyHierarchy> fitted(const std::vector<MeshTopology>& topologies, VolumeKind kind,
                                 const BuildOptions& options, int deepest) {
    std::vector<AnyHierarchy> result;
    for (const MeshTopology& mesh : topologies)
        result.push_back(fit_any(kind, mesh.topology, mesh.points, options.fit, options.threads,
                                 {.deepest = deepest}));
    return result;
}

}  // namespace

void keep_hierarchies() {
    static KeptHierarchies hierarchies;
    kept() = &hierarchies;
}

std::vector<MeshTopology> build_topologies(const Scene& scene, const TopologyOptions& options) {
    std::vector<MeshTopology> result;
    if (kept() != nullptr) result = kept()->topologies(scene, options.split);
    if (!result.empty()) return result;
    for (const NamedMesh& named : scene.meshes) {
        check_mesh(named.mesh, named.name);
        result.push_back(mesh_topology(named.mesh, options));
    }
    if (kept() != nullptr) kept()->keep(scene, options.split, result);
    return result;
}

int deepest(const std::vector<MeshTopology>& topologies) {
    int deepest_level = 0;
    for (const MeshTopology& mesh : topologies)
        deepest_level = std::max(deepest_level, depth(*mesh.topology));
    return deepest_level;
}

std::vector<int> telling_levels(const std::vector<MeshTopology>& topologies) {
    std::vector<TreeShape> of_meshes;
    for (const MeshTopology& mesh : topologies) of_meshes.push_back(tree_shape(*mesh.topology));
    std::vector<const TreeShape*> trees;
    for (const TreeShape& shape : of_meshes) trees.push_back(&shape);
    return telling_levels(trees);
}

std::vector<int> telling_levels(const std::vector<const TreeShape*>& trees) {
    int last = 0;
    for (const TreeShape* shape : trees) last = std::max(last, depth(*shape));
    std::vector<std::size_t> leaves(static_cast<std::size_t>(last) + 1);  // by depth
    std::size_t all = 0;
    for (const TreeShape* shape : trees)
        for (std::uint32_t i = 0; i < shape->size(); ++i)
            if (shape->is_reachable(i) && shape->is_leaf(i)) ++leaves[shape->depths[i]], ++all;
    std::vector<int> levels;
    std::size_t so_far = 0;
    for (int level = 0; level < last && 20 * so_far < 19 * all; ++level) {
        so_far += leaves[static_cast<std::size_t>(level)];
        levels.push_back(level);
    }
    levels.push_back(last);
    return levels;
}

std::vector<AnyHierarchy> fit_meshes(const std::vector<MeshTopology>& topologies, VolumeKind kind,
                                     const BuildOptions& options, int deepest) {
    if (kept() != nullptr) return *shared_hierarchies(topologies, kind, options, deepest);
    return fitted(topologies, kind, options, deepest);
}

SharedHierarchies shared_hierarchies(const std::vector<MeshTopology>& topologies, VolumeKind kind,
                                     const BuildOptions& options, int deepest) {
    SharedHierarchies result;
    if (kept() != nullptr) result = kept()->hierarchies(topologies, kind, options.fit, deepest);
    if (result) return result;
    result = std::make_shared<const std::vector<AnyHierarchy>>(
        fitted(topologies, kind, options, deepest));
    if (kept() != nullptr) kept()->keep(topologies, kind, options.fit, deepest, result);
    return result;
}

}  // namespace scb::scenes
