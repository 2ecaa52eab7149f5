#include "core/analysis/wasted_cost.h"

#include <algorithm>

namespace scb {

std::vector<double> wasted_cost(const Steps& steps, const TreeShape& shape, std::size_t side,
                                const std::vector<bool>& wasted, const TestCosts& costs) {
    const auto on_side = [side](const IndexPair& pair) { return side == 0 ? pair.a : pair.b; };
    const auto tested = std::count_if(steps.items.begin(), steps.items.end(),
                                      [](const ItemStep& test) { return !test.neighbors; });
    const double all = costs.volumes * static_cast<double>(steps.volumes.size()) +
                       costs.triangles * static_cast<double>(tested);
    std::vector<double> cost(shape.holder.size());
    if (!(all > 0)) return cost;
    // Per node the part of one of the triangles below it.
    std::vector<double> part(shape.size());
    for (std::size_t i = 0; i < steps.volumes.size(); ++i)
        if (wasted[i]) part[on_side(steps.volumes[i].nodes)] += costs.volumes / 2 / all;
    const std::vector<std::uint32_t> below = items_below(shape);
    for (const std::uint32_t node : shape.order) {
        part[node] /= std::max(1u, below[node]);
        if (shape.parents[node] != no_index) part[node] += part[shape.parents[node]];
    }
    for (std::size_t item = 0; item < cost.size(); ++item)
        if (shape.holder[item] != no_index) cost[item] = part[shape.holder[item]];
    for (const ItemStep& test : steps.items)
        if (!test.hit && !test.neighbors) cost[on_side(test.items)] += costs.triangles / 2 / all;
    return cost;
}

}  // namespace scb
