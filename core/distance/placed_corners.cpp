#include "core/distance/placed_corners.h"

#include <algorithm>
#include <utility>

namespace scb {

PlacedCorners placed_corners(const MeshTree& tree, const Pose* pose) {
    const auto& [mesh, topology] = tree;
    PlacedCorners result;
    const auto fail = [](std::string fault) { return PlacedCorners{std::move(fault), {}, 0}; };
    const std::size_t count = mesh.triangles.size();
    if (count == 0 || topology.nodes.empty() || topology.order.size() != count ||
        topology.nodes[0].first != 0 || topology.nodes[0].count != count)
        return fail("the root of the tree does not have as many triangles as the mesh.");
    std::vector<bool> seen(count, false);
    result.corners.reserve(3 * count);
    for (const std::uint32_t triangle : topology.order) {
        if (triangle >= count || seen[triangle]) return fail("the tree has a triangle twice.");
        seen[triangle] = true;
        for (const std::uint32_t vertex : mesh.triangles[triangle]) {
            if (vertex >= mesh.vertices.size()) return fail("a triangle has no such vertex.");
            const Vec3& stored = mesh.vertices[vertex];
            const Vec3 p = pose ? transform_point(*pose, stored) : stored;
            const double largest = p.cwiseAbs().maxCoeff();
            if (!p.allFinite() || largest > 1e300)
                return fail("a corner is not finite, or too large.");
            result.corners.push_back(p);
            result.largest_coordinate = std::max(result.largest_coordinate, largest);
        }
    }
    return result;
}

}  // namespace scb
