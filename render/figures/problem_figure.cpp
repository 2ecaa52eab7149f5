#include "render/figures/problem_figure.h"

#include <algorithm>

#include "scb/triangle_overlap.h"

namespace scb::render {
namespace {

constexpr double problem_opacity = 0.35;

std::vector<std::uint32_t> of_body(const std::vector<BodyPart>& parts, std::size_t body) {
    std::vector<std::uint32_t> indices;
    for (const BodyPart& part : parts)
        if (part.body == body) indices.push_back(part.index);
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

}  // namespace

Pane problem_pane(const ProblemParts& parts, const Theme& theme) {
    Pane pane;
    for (std::size_t b = 0; b < parts.bodies.size(); ++b) {
        const QueryBody& body = parts.bodies[b];
        const std::vector<std::uint32_t> triangles = of_body(parts.triangles, b);
        if (!triangles.empty())
            pane.meshes.push_back(
                marked_triangles(body, triangles, body_color(b + parts.first_side)));
        MeshDraw mesh = mesh_draw(body, dimmed_body_color(b + parts.first_side, theme));
        mesh.first_id = 0;
        mesh.dim = 0.5;
        mesh.backdrop = true;
        pane.meshes.push_back(std::move(mesh));
        for (const std::uint32_t node : of_body(parts.nodes, b))
            pane.volumes.push_back({volume_of(body, node),
                                    with_opacity(body_color(b + parts.first_side), problem_opacity),
                                    body.first_node_id + node, b + parts.first_side == 1});
    }
    return pane;
}

std::vector<AnyVolume> problem_region(const ProblemParts& parts) {
    std::vector<AnyVolume> region;
    for (const BodyPart& node : parts.nodes)
        region.push_back(volume_of(parts.bodies[node.body], node.index));
    for (const BodyPart& triangle : parts.triangles) {
        const QueryBody& body = parts.bodies[triangle.body];
        for (const Vec3& corner : corners(*body.mesh, triangle.index))
            region.push_back(Ball{transform_point(body.pose, corner), 0});
    }
    if (region.empty()) return region;
    const Support support = support_of(region);
    const Vec3 center = center_of(support);
    double radius = 0;
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = Vec3::Unit(i);
        radius = std::max({radius, support(axis) - center[i], support(Vec3(-axis)) + center[i]});
    }
    constexpr double wider = 1.5;
    region.push_back(Ball{center, wider * radius});
    return region;
}

std::vector<PanelItem> problem_keys(const ProblemParts& parts, const Theme& theme) {
    std::vector<PanelItem> items;
    for (const BodyPart& node : parts.nodes)
        items.emplace_back(PanelLegendRow{
            seen_color(body_color(node.body + parts.first_side), problem_opacity, theme),
            parts.bodies[node.body].tree->node_words(node.index) + " of " +
                parts.bodies[node.body].name,
            "", "", node.body + parts.first_side == 1});
    for (const BodyPart& triangle : parts.triangles)
        items.emplace_back(PanelKey{body_color(triangle.body + parts.first_side),
                                    "triangle " + std::to_string(triangle.index) + " of " +
                                        parts.bodies[triangle.body].name});
    return items;
}

}  // namespace scb::render
