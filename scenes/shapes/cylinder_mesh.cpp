#include "core/base/portable_math.h"
#include "scenes/shapes/parameter_checks.h"
#include "scenes/shapes/procedural.h"

namespace scb::scenes {
namespace {

void check_round(double radius, double height, int sides, int segments) {
    require_length("radius", radius);
    require_length("height", height);
    require_between("sides", sides, 3, max_procedural_triangles);
    require_between("segments", segments, 1, max_procedural_triangles);
    require_triangles(std::int64_t{2} * sides * (std::int64_t{segments} + 1));
}

void add_circle(Mesh& mesh, double radius, double z, int sides) {
    for (int i = 0; i < sides; ++i) {
        const SinCos angle = sin_cos_turns(static_cast<double>(i) / sides);
        mesh.vertices.emplace_back(radius * angle.cos, radius * angle.sin, z);
    }
}

/// The quads between the circle that starts at vertex `lower` and the next circle above it.
void add_belt(Mesh& mesh, std::uint32_t lower, std::uint32_t sides) {
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = lower + i, b = lower + (i + 1) % sides;
        mesh.triangles.push_back({a, b, b + sides});
        mesh.triangles.push_back({a, b + sides, a + sides});
    }
}

/// Triangles from the circle that starts at `circle` to the vertex `middle`, counterclockwise seen
/// from +z or -z.
void add_fan(Mesh& mesh, std::uint32_t circle, std::uint32_t sides, std::uint32_t middle,
             bool seen_from_above) {
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = circle + i, b = circle + (i + 1) % sides;
        mesh.triangles.push_back(seen_from_above ? Triangle{a, b, middle} : Triangle{b, a, middle});
    }
}

std::uint32_t add_vertex(Mesh& mesh, double z) {
    mesh.vertices.emplace_back(0, 0, z);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

}  // namespace

Mesh cylinder_mesh(const CylinderShape& shape) {
    check_round(shape.radius, shape.height, shape.sides, shape.segments);
    const auto sides = static_cast<std::uint32_t>(shape.sides),
               segments = static_cast<std::uint32_t>(shape.segments);
    Mesh mesh;
    for (int k = 0; k <= shape.segments; ++k)
        add_circle(mesh, shape.radius,
                   shape.height * (static_cast<double>(k) / shape.segments - 0.5), shape.sides);
    for (std::uint32_t k = 0; k < segments; ++k) add_belt(mesh, k * sides, sides);
    if (shape.capped) {
        add_fan(mesh, 0, sides, add_vertex(mesh, -0.5 * shape.height), false);
        add_fan(mesh, segments * sides, sides, add_vertex(mesh, 0.5 * shape.height), true);
    }
    return mesh;
}

Mesh cone_mesh(const ConeShape& shape) {
    check_round(shape.radius, shape.height, shape.sides, shape.segments);
    const auto sides = static_cast<std::uint32_t>(shape.sides),
               segments = static_cast<std::uint32_t>(shape.segments);
    Mesh mesh;
    for (int k = 0; k < shape.segments; ++k) {
        const double up = static_cast<double>(k) / shape.segments;
        add_circle(mesh, shape.radius * (1 - up), shape.height * (up - 0.5), shape.sides);
    }
    for (std::uint32_t k = 0; k + 1 < segments; ++k) add_belt(mesh, k * sides, sides);
    add_fan(mesh, (segments - 1) * sides, sides, add_vertex(mesh, 0.5 * shape.height), true);
    if (shape.capped) add_fan(mesh, 0, sides, add_vertex(mesh, -0.5 * shape.height), false);
    return mesh;
}

}  // namespace scb::scenes
