#include "core/analysis/tested_triangles.h"

#include <algorithm>
#include <iterator>

#include "core/analysis/triangle_heat.h"
#include "scb/triangle_overlap.h"

namespace scb {

std::vector<TestedTriangle> tested_triangles(const Steps& steps, const TreeShape& shape,
                                             std::size_t side) {
    const std::vector<std::uint32_t> items = triangle_heat(steps, shape, side, HeatOf::triangles),
                                     volumes = triangle_heat(steps, shape, side, HeatOf::volumes);
    std::vector<TestedTriangle> tested;
    for (std::uint32_t i = 0; i < items.size(); ++i)
        if (items[i] > 0) tested.push_back({i, items[i], volumes[i]});
    return tested;
}

void add_tests(std::vector<TestedTriangle>& sum, const std::vector<TestedTriangle>& more) {
    std::vector<TestedTriangle> merged;
    merged.reserve(sum.size() + more.size());
    std::merge(
        sum.begin(), sum.end(), more.begin(), more.end(), std::back_inserter(merged),
        [](const TestedTriangle& x, const TestedTriangle& y) { return x.triangle < y.triangle; });
    sum.clear();
    for (const TestedTriangle& one : merged) {
        if (sum.empty() || sum.back().triangle != one.triangle) {
            sum.push_back(one);
            continue;
        }
        sum.back().items += one.items;
        sum.back().volumes += one.volumes;
    }
}

std::vector<CostlyTriangle> costly_triangles(std::vector<TestedTriangle> tested, const Mesh& mesh,
                                             std::size_t most) {
    const auto end = tested.begin() + static_cast<std::ptrdiff_t>(std::min(most, tested.size()));
    std::partial_sort(tested.begin(), end, tested.end(),
                      [](const TestedTriangle& x, const TestedTriangle& y) {
                          if (x.items != y.items) return x.items > y.items;
                          if (x.volumes != y.volumes) return x.volumes > y.volumes;
                          return x.triangle < y.triangle;
                      });
    std::vector<CostlyTriangle> costly;
    for (auto one = tested.begin(); one != end; ++one)
        costly.push_back({*one, triangle_size(corners(mesh, one->triangle))});
    return costly;
}

std::uint64_t item_tests(const std::vector<TestedTriangle>& tested) {
    std::uint64_t sum = 0;
    for (const TestedTriangle& one : tested) sum += one.items;
    return sum;
}

}  // namespace scb
