#include "render/figures/query_body.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "render/view/palette.h"

namespace scb::render {

AnyVolume volume_of(const QueryBody& body, std::uint32_t node) {
    return placed(body.tree->volume(node), body.pose);
}

double mesh_reach(const QueryBody& body, const Vec3& direction) {
    const Vec3 local = rotate(body.pose.rotation.transpose(), direction);
    const TreeShape& shape = body.tree->shape();
    double most = -std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> open(shape.roots.rbegin(), shape.roots.rend());
    while (!open.empty()) {
        const std::uint32_t node = open.back();
        open.pop_back();
        if (body.tree->has_volume(node) && reach(body.tree->volume(node), local) <= most) continue;
        for (const std::uint32_t triangle : body.tree->items(node)) {
            if (triangle >= body.mesh->triangles.size()) continue;
            for (const std::uint32_t corner : body.mesh->triangles[triangle])
                most = std::max(most, dot(body.mesh->vertices[corner], local));
        }
        const std::size_t below = open.size();
        for (std::uint32_t child = shape.first_child[node]; child != no_index;
             child = shape.next_sibling[child])
            open.push_back(child);
        std::reverse(open.begin() + static_cast<std::ptrdiff_t>(below), open.end());
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
