#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/model/tree.h"
#include "render/view/fit_camera.h"
#include "render/view/palette.h"
#include "render/view/picture.h"

namespace scb::render {

/// One of the two bodies of a query for pictures, at one frame. Does not own the objects that it
/// points to.
struct QueryBody {
    std::string name;
    const Mesh* mesh = nullptr;
    const Tree* tree = nullptr;
    MeshHandle handle;
    Pose pose;                            ///< from the body's frame to the world's
    std::uint32_t first_node_id = 1;      ///< node i has the id first_node_id + i
    std::uint32_t first_triangle_id = 1;  ///< triangle i has the id first_triangle_id + i
};
using QueryBodies = std::array<QueryBody, 2>;

/// The volume of a node that has one, in the world.
AnyVolume volume_of(const QueryBody& body, std::uint32_t node);

/// The largest `direction.x` over the vertices of the body's triangles, in the world, for a unit
/// direction: found by the hierarchy, for pictures of many frames.
double mesh_reach(const QueryBody& body, const Vec3& direction);

/// Blue for A, orange for B, as in every picture of bodies; dimmed for a mesh that is not the
/// subject.
Rgba8 body_color(std::size_t side);
Rgba8 dimmed_body_color(std::size_t side, const Theme& theme);

/// The body's mesh in this color, with ids.
MeshDraw mesh_draw(const QueryBody& body, Rgba8 color);

/// Only these triangles of the body's mesh, ascending, in a color of the legend: with little light
/// and shade.
MeshDraw marked_triangles(const QueryBody& body, std::vector<std::uint32_t> triangles, Rgba8 color);

/// The visible color of a translucent volume of this color: both of its sides, one behind the
/// other.
Rgba8 seen_color(Rgba8 color, double opacity, const Theme& theme);

}  // namespace scb::render
