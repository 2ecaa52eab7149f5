#include "render/figures/query_body.h"

#include "core/volumes/shape.h"
#include "render/view/palette.h"

namespace scb::render {

AnyVolume volume_of(const QueryBody& body, std::uint32_t node) {
    return std::visit(
        [&](const auto& h) { return AnyVolume(placed(shape_of(h.volumes[node]), body.pose)); },
        *body.hierarchy);
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

}  // namespace scb::render
