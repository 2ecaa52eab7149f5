#include "core/hierarchy/node_surfaces.h"

#include "core/geometry/surface_moments.h"

namespace scb {

std::vector<double> node_surfaces(const Topology& topology, const Mesh& mesh) {
    std::vector<double> surfaces(topology.nodes.size());
    // Parents come before their children.
    for (std::size_t i = topology.nodes.size(); i-- > 0;) {
        const TopologyNode& node = topology.nodes[i];
        if (!node.is_leaf()) {
            surfaces[i] = surfaces[node.left] + surfaces[node.left + 1];
            continue;
        }
        const Triangle& t = mesh.triangles[topology.order[node.first]];
        surfaces[i] =
            triangle_moments(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]).area;
    }
    return surfaces;
}

}  // namespace scb
