#include "core/hierarchy/mesh_topology.h"

#include "core/base/parallel_for.h"

namespace scb {

MeshTopology mesh_topology(const Mesh& mesh, const TopologyOptions& options) {
    MeshTopology result;
    std::vector<std::uint32_t> welded;
    both(
        options.threads,
        [&] { result.topology = std::make_shared<Topology>(build_topology(mesh, options)); },
        [&] { welded = weld(mesh); });
    result.points = leaf_order(mesh, *result.topology, welded, options.threads);
    return result;
}

}  // namespace scb
