#include "scb/mesh.h"

#include <cmath>

#include "core/base/sentence.h"
#include "scb/error.h"

namespace scb {
namespace {

template <class... Parts>
[[noreturn]] void refuse(std::string_view name, const Parts&... parts) {
    throw InputError(sentence(name, ": ", parts...));
}

}  // namespace

void check_mesh(const Mesh& mesh, std::string_view name) {
    if (mesh.triangles.empty())
        refuse(name, "the mesh has no triangles; give a surface, not points or lines.");
    if (mesh.triangles.size() > max_triangles)
        refuse(name, "the mesh has ", mesh.triangles.size(), " triangles; at most ", max_triangles,
               " can be indexed.");
    if (mesh.vertices.size() > max_vertices)
        refuse(name, "the mesh has ", mesh.vertices.size(), " vertices; at most ", max_vertices,
               " can be indexed.");
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const std::uint32_t v : mesh.triangles[t]) {
            if (v >= mesh.vertices.size())
                refuse(name, "triangle ", t, " names vertex ", v, ", but the mesh has ",
                       mesh.vertices.size(), " vertices (0 to ",
                       static_cast<long long>(mesh.vertices.size()) - 1, "); repair the index.");
            const Vec3& p = mesh.vertices[v];
            for (int axis = 0; axis < 3; ++axis)
                if (!(std::abs(p[axis]) <= max_coordinate))
                    refuse(name, "vertex ", v, " of triangle ", t, " has the coordinate ",
                           "xyz"[axis], " = ", p[axis], "; coordinates must be finite and at most ",
                           max_coordinate, " in magnitude.");
        }
    }
    const Box box = bounding_box(mesh);
    const double longest = (box.upper - box.lower).maxCoeff();
    if (longest > 0 && longest < min_size)
        refuse(name, "the mesh is only ", longest, " long; at least ", min_size,
               " is needed (or 0, for a point), so scale it up.");
}

Box bounding_box(const Mesh& mesh) {
    Box box;
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle) box.add(mesh.vertices[v]);
    return box;
}

}  // namespace scb
