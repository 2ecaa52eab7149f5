#include "core/hierarchy/mesh_parity.h"

#include <cstddef>

#include "core/geometry/orientation.h"
#include "scb/triangle_overlap.h"

namespace scb {
namespace {

constexpr int upward = 2;

int sign_of(double value) { return static_cast<int>(value > 0) - static_cast<int>(value < 0); }

/// The side of the line from u to v, seen from above, on which the moved point is: the sign of
/// orient2d(u, v, p), or if that is 0, of the first of its derivatives by e and e^2 that is not 0.
int side_of_line(const Vec3& u, const Vec3& v, const Vec3& p) {
    if (const int side = orient2d(u, v, p, upward); side != 0) return side;
    if (u[1] != v[1]) return sign_of(u[1] - v[1]);
    return sign_of(v[0] - u[0]);
}

/// Whether the ray up from the moved point crosses the triangle; p is not on it.
bool crosses(const TriangleCorners& t, const Vec3& p) {
    const int turn = side_of_line(t[0], t[1], p);
    if (turn == 0 || side_of_line(t[1], t[2], p) != turn || side_of_line(t[2], t[0], p) != turn)
        return false;
    // The normal of a triangle that turns counterclockwise points up.
    return orient3d(t[0], t[1], t[2], p) == -turn;
}

bool holds_ray(const Box& box, const Vec3& p) {
    return box.lower[0] <= p[0] && p[0] <= box.upper[0] && box.lower[1] <= p[1] &&
           p[1] <= box.upper[1] && p[2] <= box.upper[2];
}

}  // namespace

MeshParity::MeshParity(const Mesh& mesh, const Topology& topology)
    : mesh_(mesh), topology_(topology), boxes_(topology.nodes.size()) {
    for (std::size_t i = boxes_.size(); i-- > 0;) {
        const TopologyNode& node = topology.nodes[i];
        if (node.is_leaf()) {
            for (std::size_t k = node.first; k < std::size_t{node.first} + node.count; ++k)
                for (const Vec3& corner : corners(mesh, topology.order[k])) boxes_[i].add(corner);
        } else {
            boxes_[i].add(boxes_[node.left]);
            boxes_[i].add(boxes_[node.left + 1]);
        }
    }
}

PointSide MeshParity::side(const Vec3& point) const {
    bool is_in = false;
    std::vector<std::uint32_t> left_to_visit{0};
    while (!left_to_visit.empty()) {
        const std::uint32_t i = left_to_visit.back();
        left_to_visit.pop_back();
        if (!holds_ray(boxes_[i], point)) continue;
        const TopologyNode& node = topology_.nodes[i];
        if (!node.is_leaf()) {
            left_to_visit.push_back(node.left + 1);
            left_to_visit.push_back(node.left);
            continue;
        }
        for (std::size_t k = node.first; k < std::size_t{node.first} + node.count; ++k) {
            const TriangleCorners t = corners(mesh_, topology_.order[k]);
            if (triangles_overlap(t, {point, point, point})) return PointSide::on;
            is_in ^= crosses(t, point);
        }
    }
    return is_in ? PointSide::in : PointSide::out;
}

}  // namespace scb
