#include "render/figures/query_body.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/volumes/shape.h"
#include "render/view/palette.h"

namespace scb::render {

AnyVolume volume_of(const QueryBody& body, std::uint32_t node) {
    return std::visit(
        [&](const auto& h) { return AnyVolume(placed(shape_of(h.volumes[node]), body.pose)); },
        *body.hierarchy);
}

double mesh_reach(const QueryBody& body, const Vec3& direction) {
    const Vec3 local = rotate(body.pose.rotation.transpose(), direction);
    const Topology& topology = topology_of(*body.hierarchy);
    double most = -std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> open = {0};
    while (!open.empty()) {
        const std::uint32_t i = open.back();
        open.pop_back();
        const double bound = std::visit(
            [&](const auto& h) { return reach(shape_of(h.volumes[i]), local); }, *body.hierarchy);
        if (bound <= most) continue;
        const TopologyNode& node = topology.nodes[i];
        if (!node.is_leaf()) {
            open.insert(open.end(), {node.left + 1, node.left});
            continue;
        }
        for (const std::uint32_t corner : body.mesh->triangles[topology.order[node.first]])
            most = std::max(most, dot(body.mesh->vertices[corner], local));
    }
    return most + dot(body.pose.translation, direction);
}

Rgba8 body_color(std::size_t side) { return side == 0 ? body_a_color : body_b_color; }

Rgba8 dimmed_body_color(std::size_t side, const Theme& theme) {
    return mix(theme.mesh, body_color(side), 0.18);
}

MeshDraw mesh_draw(const QueryBody& body, Rgba8 color) {
    MeshDraw draw;
    draw.mesh = body.handle;
    draw.pose = body.pose;
    draw.color = color;
    draw.first_id = body.first_triangle_id;
    return draw;
}

MeshDraw marked_triangles(const QueryBody& body, std::vector<std::uint32_t> triangles,
                          Rgba8 color) {
    MeshDraw draw = mesh_draw(body, color);
    draw.chosen = std::move(triangles);
    draw.shading = 0.3;
    return draw;
}

Rgba8 seen_color(Rgba8 color, double opacity, const Theme& theme) {
    return mix(theme.background, color, 1 - (1 - opacity) * (1 - opacity));
}

}  // namespace scb::render
