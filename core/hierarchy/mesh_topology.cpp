#include "core/hierarchy/mesh_topology.h"

#include "core/base/parallel_for.h"
#include "scb/error.h"

namespace scb {

MeshTopology mesh_topology(const Mesh& mesh, const TopologyOptions& options) {
    MeshTopology result;
    std::vector<std::uint32_t> welded;
    parallel_invoke(
        options.threads,
        [&] { result.topology = std::make_shared<Topology>(build_topology(mesh, options)); },
        [&] { welded = joined_vertices(mesh); });
    result.points = leaf_order(mesh, *result.topology, welded, options.threads);
    return result;
}

MeshTopology checked_topology(const Mesh& mesh, const BuildOptions& options,
                              std::string_view name) {
    check_mesh(mesh, name);
    if (!(options.fit.margin >= 0))
        throw InputError(std::string(name) +
                         ": the margin is below 0 or not a number; give a share of the radius.");
    return mesh_topology(mesh, options.topology());
}

}  // namespace scb
