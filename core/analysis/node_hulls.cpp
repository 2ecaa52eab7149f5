#include "core/analysis/node_hulls.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/parallel_for.h"
#include "core/geometry/convex_hull.h"

namespace scb {
namespace {

using PointIds = std::vector<std::uint32_t>;  ///< ascending

struct HullBuild {
    const TreeShape& shape;
    const ItemCorners& corners;
    const PointArrays& points;
    int threads;
    std::vector<std::uint32_t> counts;      ///< per node the items below it
    std::vector<std::uint32_t> first_item;  ///< per node, into `items`; one more at the end
    std::vector<std::uint32_t> items;       ///< by the nodes that have them
    NodeHulls hulls;

    /// Nodes with fewer triangles have one thread.
    static constexpr std::uint32_t least_shared = 2048;

    void sort_items() {
        first_item.assign(shape.size() + 1, 0);
        for (const std::uint32_t node : shape.holder)
            if (node != no_index) ++first_item[node + std::size_t{1}];
        for (std::size_t i = 1; i < first_item.size(); ++i) first_item[i] += first_item[i - 1];
        items.resize(first_item.back());
        std::vector<std::uint32_t> next = first_item;
        for (std::uint32_t item = 0; item < shape.holder.size(); ++item)
            if (shape.holder[item] != no_index) items[next[shape.holder[item]]++] = item;
    }

    /// Fills in this node and all nodes below it; returns the points on its hull.
    PointIds build(std::uint32_t node) {
        PointIds ids;
        for (std::uint32_t i = first_item[node]; i < first_item[node + 1]; ++i)
            ids.insert(ids.end(), corners[items[i]].begin(), corners[items[i]].end());
        std::sort(ids.begin(), ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        // A triangle lies in a plane.
        if (shape.is_leaf(node) && first_item[node + 1] - first_item[node] < 2) return ids;
        std::vector<PointIds> of_children;
        for (std::uint32_t child = shape.first_child[node]; child != no_index;
             child = shape.next_sibling[child])
            of_children.emplace_back();
        const std::uint32_t left = shape.first_child[node];
        if (threads > 1 && counts[node] >= least_shared && of_children.size() == 2) {
            parallel_invoke(
                threads, [&] { of_children[0] = build(left); },
                [&] { of_children[1] = build(shape.next_sibling[left]); });
        } else {
            std::size_t i = 0;
            for (std::uint32_t child = left; child != no_index; child = shape.next_sibling[child])
                of_children[i++] = build(child);
        }
        for (const PointIds& below : of_children) {
            PointIds both;
            std::set_union(ids.begin(), ids.end(), below.begin(), below.end(),
                           std::back_inserter(both));
            ids = std::move(both);
        }
        std::vector<Vec3> positions;
        Box box;
        for (const std::uint32_t id : ids) {
            positions.push_back(points.view()[id]);
            box.add(positions.back());
        }
        if (positions.empty()) return ids;
        const ConvexHull hull = convex_hull(positions);
        const double diagonal = std::sqrt(squared_norm(box.upper - box.lower));
        hulls.volumes[node] = hull.volume;
        hulls.solid[node] = hull.volume > 1e-9 * diagonal * diagonal * diagonal;
        PointIds on_hull;
        for (const std::uint32_t vertex : hull.vertices) on_hull.push_back(ids[vertex]);
        return on_hull;
    }
};

}  // namespace

NodeHulls node_hulls(const TreeShape& shape, const ItemCorners& corners, const PointArrays& points,
                     int threads) {
    HullBuild build{shape, corners, points, threads, items_below(shape), {}, {}, {}};
    build.sort_items();
    build.hulls.volumes.resize(shape.size());
    build.hulls.solid.resize(shape.size());
    for (const std::uint32_t root : shape.roots) build.build(root);
    return std::move(build.hulls);
}

}  // namespace scb
