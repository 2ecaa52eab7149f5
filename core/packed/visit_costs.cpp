#include "core/packed/visit_costs.h"

#include "core/base/large_pages.h"
#include "core/base/parallel_for.h"

namespace scb {
namespace {

class VisitCosts {
  public:
    VisitCosts(const Mesh& mesh, const Topology& topology, std::vector<float>& costs)
        : mesh_(mesh), topology_(topology), costs_(costs) {}

    // Finds the costs of a node and of all below it; returns the node's box. The recursion is as
    // deep as the topology, whose depth is logarithmic.
    Box weigh(std::uint32_t i, int threads) {
        const Box box = box_of(topology_.nodes[i], threads);
        const Vec3 side = box.upper - box.lower;
        const double sum = side[0] + side[1] + side[2],
                     area = 2 * (side[0] * side[1] + side[1] * side[2] + side[2] * side[0]);
        costs_[i] = static_cast<float>(sum * sum + area);
        return box;
    }

  private:
    Box box_of(const TopologyNode& node, int threads) {
        if (node.is_leaf()) return box_of_triangle(topology_.order[node.first]);
        constexpr std::uint32_t divided_from = 8192;
        Box left, right;
        in_halves(
            threads, node.count >= divided_from, [&](int each) { left = weigh(node.left, each); },
            [&](int each) { right = weigh(node.left + 1, each); });
        return {left.lower.cwiseMin(right.lower), left.upper.cwiseMax(right.upper)};
    }
    Box box_of_triangle(std::uint32_t triangle) const {
        Box box;
        for (const std::uint32_t vertex : mesh_.triangles[triangle])
            box.add(mesh_.vertices[vertex]);
        return box;
    }

    const Mesh& mesh_;
    const Topology& topology_;
    std::vector<float>& costs_;
};

}  // namespace

std::vector<float> visit_costs(const Mesh& mesh, const Topology& topology, int threads) {
    std::vector<float> costs;
    resize_large(costs, topology.nodes.size());
    VisitCosts(mesh, topology, costs).weigh(0, threads);
    return costs;
}

}  // namespace scb
