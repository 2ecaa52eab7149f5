#include "scenes/shapes/parameter_checks.h"
#include "scenes/shapes/procedural.h"

namespace scb::scenes {

Mesh plane_mesh(const PlaneShape& shape) {
    require_length("size", shape.size_x);
    require_length("size", shape.size_y);
    require_between("cells", shape.cells_x, 1, max_procedural_triangles);
    require_between("cells", shape.cells_y, 1, max_procedural_triangles);
    require_triangles(std::int64_t{2} * shape.cells_x * shape.cells_y);

    Mesh mesh;
    for (int j = 0; j <= shape.cells_y; ++j)
        for (int i = 0; i <= shape.cells_x; ++i)
            mesh.vertices.emplace_back(
                shape.size_x * (static_cast<double>(i) / shape.cells_x - 0.5),
                shape.size_y * (static_cast<double>(j) / shape.cells_y - 0.5), 0);
    const auto row = static_cast<std::uint32_t>(shape.cells_x) + 1;
    for (std::uint32_t j = 0; j + 1 <= static_cast<std::uint32_t>(shape.cells_y); ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = j * row + i;
            mesh.triangles.push_back({a, a + 1, a + row + 1});
            mesh.triangles.push_back({a, a + row + 1, a + row});
        }
    }
    return mesh;
}

}  // namespace scb::scenes
