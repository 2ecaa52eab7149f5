#include "scb/hierarchy.h"

#include "core/base/text_format.h"
#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"

namespace scb {

template <Volume V>
Hierarchy<V> build_hierarchy(const Mesh& mesh, const BuildOptions& options, std::string_view name) {
    MeshTopology shared = checked_topology(mesh, options, name);
    std::vector<V> volumes =
        fit_volumes<V>(*shared.topology, shared.points, options.fit, options.threads);
    return {std::move(shared.topology), std::move(volumes)};
}

std::string validate(const Topology& topology, const Mesh& mesh) {
    const std::size_t count = mesh.triangles.size();
    if (topology.order.size() != count)
        return sentence("the topology orders ", topology.order.size(), " triangles, the mesh has ",
                        count, ".");
    if (topology.nodes.size() != 2 * count - 1 || topology.rules.size() != topology.nodes.size())
        return sentence("the topology has ", topology.nodes.size(), " nodes, ", 2 * count - 1,
                        " are needed.");
    std::vector<char> met(count, 0);
    for (const std::uint32_t t : topology.order) {
        if (t >= count || met[t]) return sentence("triangle ", t, " is not in exactly one leaf.");
        met[t] = 1;
    }
    if (topology.nodes[0].first != 0 || topology.nodes[0].count != count)
        return "node 0, the root, does not hold all triangles.";
    for (std::size_t i = 0; i < topology.nodes.size(); ++i) {
        const TopologyNode& node = topology.nodes[i];
        if (node.is_leaf()) {
            if (node.count != 1)
                return sentence("node ", i, " is a leaf of ", node.count, " triangles.");
            continue;
        }
        if (node.left <= i || std::size_t{node.left} + 1 >= topology.nodes.size())
            return sentence("node ", i, " names child ", node.left, ", which does not follow it.");
        const TopologyNode &l = topology.nodes[node.left], &r = topology.nodes[node.left + 1];
        if (l.count == 0 || r.count == 0 || l.first != node.first || r.first != l.first + l.count ||
            l.count + r.count != node.count)
            return sentence("the children of node ", i, " do not make up its range.");
        if ((!l.is_leaf() && l.left != node.left + 2) ||
            (!r.is_leaf() && r.left != node.left + 2 * l.count))
            return sentence("the nodes below node ", i, " are not in the order of a Topology.");
    }
    return {};
}

template <Volume V>
std::string validate(const Hierarchy<V>& hierarchy, const Mesh& mesh) {
    const Topology& topology = *hierarchy.topology;
    if (std::string failure = validate(topology, mesh); !failure.empty()) return failure;
    if (hierarchy.volumes.size() != topology.nodes.size())
        return sentence(hierarchy.volumes.size(), " volumes for ", topology.nodes.size(),
                        " nodes.");
    for (std::size_t i = 0; i < topology.nodes.size(); ++i) {
        const TopologyNode& node = topology.nodes[i];
        if (!is_well_formed(hierarchy.volumes[i]))
            return sentence("the volume of node ", i, " is not well formed.");
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
            for (const std::uint32_t v : mesh.triangles[topology.order[k]])
                if (!contains(hierarchy.volumes[i], mesh.vertices[v]))
                    return sentence("vertex ", v, " of triangle ", topology.order[k],
                                    " is outside the volume of node ", i, ".");
    }
    return {};
}

#define SCB_INSTANTIATE(V)                                                                     \
    template Hierarchy<V> build_hierarchy(const Mesh&, const BuildOptions&, std::string_view); \
    template std::string validate(const Hierarchy<V>&, const Mesh&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
