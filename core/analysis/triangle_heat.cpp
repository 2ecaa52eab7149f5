#include "core/analysis/triangle_heat.h"

namespace scb {

std::vector<std::uint32_t> triangle_heat(const Events& events, const Topology& topology,
                                         std::size_t side, HeatOf of) {
    std::vector<std::uint32_t> heat(topology.order.size());
    const auto index_on_side = [side](const IndexPair& pair) {
        return side == 0 ? pair.a : pair.b;
    };
    if (of == HeatOf::triangles) {
        for (const TriangleTest& test : events.triangle_tests)
            ++heat[index_on_side(test.triangles)];
        return heat;
    }
    std::vector<std::uint32_t> tests(topology.nodes.size());
    for (const VolumeTest& test : events.volume_tests) ++tests[index_on_side(test.nodes)];
    // Parents come before their children: what was tested of a node was tested of all below it.
    for (std::size_t i = 0; i < topology.nodes.size(); ++i) {
        const TopologyNode& node = topology.nodes[i];
        if (node.is_leaf()) {
            heat[topology.order[node.first]] = tests[i];
            continue;
        }
        tests[node.left] += tests[i];
        tests[node.left + 1] += tests[i];
    }
    return heat;
}

}  // namespace scb
