#include "scenes/scene/scene_hierarchies.h"

#include <algorithm>

#include "core/hierarchy/fit_volumes.h"
#include "scb/level_cover.h"

namespace scb::scenes {

std::vector<MeshTopology> build_topologies(const Scene& scene, const TopologyOptions& options) {
    std::vector<MeshTopology> result;
    for (const NamedMesh& named : scene.meshes) {
        check_mesh(named.mesh, named.name);
        result.push_back(mesh_topology(named.mesh, options));
    }
    return result;
}

int deepest(const std::vector<MeshTopology>& topologies) {
    int deepest_level = 0;
    for (const MeshTopology& mesh : topologies)
        deepest_level = std::max(deepest_level, depth(*mesh.topology));
    return deepest_level;
}

std::vector<AnyHierarchy> fit_meshes(const std::vector<MeshTopology>& topologies, VolumeKind kind,
                                     const BuildOptions& options, int deepest) {
    std::vector<AnyHierarchy> result;
    for (const MeshTopology& mesh : topologies)
        result.push_back(fit_any(kind, mesh.topology, mesh.points, options.fit, options.threads,
                                 {.deepest = deepest}));
    return result;
}

}  // namespace scb::scenes
