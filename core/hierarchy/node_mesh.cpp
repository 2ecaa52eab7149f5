#include "core/hierarchy/node_mesh.h"

#include <algorithm>

namespace scb {

Mesh node_mesh(const Mesh& mesh, const Topology& topology, std::uint32_t node) {
    const TopologyNode& n = topology.nodes[node];
    std::vector<std::uint32_t> used;
    for (std::uint32_t i = n.first; i < n.first + n.count; ++i) {
        const Triangle& triangle = mesh.triangles[topology.order[i]];
        used.insert(used.end(), triangle.begin(), triangle.end());
    }
    std::vector<std::uint32_t> vertices = used;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto place_of = [&](std::uint32_t vertex) {
        return static_cast<std::uint32_t>(
            std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin());
    };
    Mesh result;
    for (const std::uint32_t vertex : vertices) result.vertices.push_back(mesh.vertices[vertex]);
    for (std::size_t i = 0; i < used.size(); i += 3)
        result.triangles.push_back(
            {place_of(used[i]), place_of(used[i + 1]), place_of(used[i + 2])});
    return result;
}

}  // namespace scb
