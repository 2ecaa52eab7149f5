#include <cmath>
#include <utility>

#include "scenes/shapes/parameter_checks.h"
#include "scenes/shapes/procedural.h"

namespace scb::scenes {
namespace {

Vec3 on_unit_sphere(const Vec3& v) { return v / std::sqrt(squared_norm(v)); }

Mesh icosahedron() {
    const double g = (1 + std::sqrt(5.0)) / 2;
    Mesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (Vec3& v : mesh.vertices) v = on_unit_sphere(v);
    return mesh;
}

/// The middle vertices of edges, stored with the edge's end of lower index: a vertex here has at
/// most six edges.
struct EdgeMiddles {
    struct Entry {
        std::uint32_t other_end = 0, middle = 0;
    };
    struct Fan {
        std::array<Entry, 6> entries;
        int count = 0;
    };
    std::vector<Fan> fans;

    std::uint32_t middle(std::uint32_t a, std::uint32_t b, std::vector<Vec3>& vertices) {
        if (a > b) std::swap(a, b);
        Fan& fan = fans[a];
        for (int i = 0; i < fan.count; ++i)
            if (fan.entries[static_cast<std::size_t>(i)].other_end == b)
                return fan.entries[static_cast<std::size_t>(i)].middle;
        const auto created = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(on_unit_sphere(vertices[a] + vertices[b]));
        fan.entries[static_cast<std::size_t>(fan.count++)] = {b, created};
        return created;
    }
};

void subdivide(Mesh& mesh) {
    EdgeMiddles middles;
    middles.fans.resize(mesh.vertices.size());
    std::vector<Triangle> finer;
    finer.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middles.middle(a, b, mesh.vertices);
        const std::uint32_t bc = middles.middle(b, c, mesh.vertices);
        const std::uint32_t ca = middles.middle(c, a, mesh.vertices);
        finer.push_back({a, ab, ca});
        finer.push_back({b, bc, ab});
        finer.push_back({c, ca, bc});
        finer.push_back({ab, bc, ca});
    }
    mesh.triangles = std::move(finer);
}

}  // namespace

Mesh icosphere(int subdivisions, double radius) {
    require_between("subdivisions", subdivisions, 0, 9);
    require_length("radius", radius);
    Mesh mesh = icosahedron();
    for (int i = 0; i < subdivisions; ++i) subdivide(mesh);
    for (Vec3& v : mesh.vertices) v *= radius;
    return mesh;
}

}  // namespace scb::scenes
