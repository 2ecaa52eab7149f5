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
    const Topology& topology;
    const LeafOrder& points;
    int threads;
    NodeHulls hulls;

    /// Below so many triangles a node has one thread.
    static constexpr std::uint32_t least_shared = 2048;

    /// Fills in all nodes from this one on down; the points on its hull.
    PointIds build(std::uint32_t node) {
        const TopologyNode& n = topology.nodes[node];
        PointIds ids;
        if (n.is_leaf()) {
            const auto& corners = points.corners[n.first];
            ids.assign(corners.begin(), corners.end());
            std::sort(ids.begin(), ids.end());
            ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
            return ids;
        }
        PointIds left, right;
        if (threads > 1 && n.count >= least_shared) {
            parallel_invoke(
                threads, [&] { left = build(n.left); }, [&] { right = build(n.left + 1); });
        } else {
            left = build(n.left);
            right = build(n.left + 1);
        }
        std::set_union(left.begin(), left.end(), right.begin(), right.end(),
                       std::back_inserter(ids));
        std::vector<Vec3> positions;
        Box box;
        for (const std::uint32_t id : ids) {
            positions.push_back(points.points.view()[id]);
            box.add(positions.back());
        }
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

NodeHulls node_hulls(const Topology& topology, const LeafOrder& points, int threads) {
    HullBuild build{topology, points, threads, {}};
    build.hulls.volumes.resize(topology.nodes.size());
    build.hulls.solid.resize(topology.nodes.size());
    build.build(0);
    return std::move(build.hulls);
}

}  // namespace scb
