#include "core/geometry/mesh_clean.h"

#include "core/geometry/mesh_facts.h"
#include "core/geometry/triangle_pair.h"

namespace scb {

CleanMesh clean_mesh(const Mesh& mesh) {
    CleanMesh clean;
    clean.mesh.vertices = mesh.vertices;
    const std::vector<std::uint32_t> copies = duplicate_triangles(mesh);
    auto copy = copies.begin();
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (copy != copies.end() && *copy == i) {
            ++copy;
            ++clean.copies;
        } else if (is_degenerate(corners(mesh, i))) {
            ++clean.degenerate;
        } else {
            clean.mesh.triangles.push_back(mesh.triangles[i]);
            clean.origin.push_back(i);
        }
    }
    if (clean.origin.empty() && !mesh.triangles.empty()) {
        clean.mesh.triangles = {mesh.triangles.front()};
        clean.origin = {0};
        --clean.degenerate;
    }
    return clean;
}

}  // namespace scb
