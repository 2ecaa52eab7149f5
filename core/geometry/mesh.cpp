#include "scb/mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "core/base/text_format.h"
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

std::vector<std::uint32_t> joined_vertices(const Mesh& mesh) {
    struct Located {
        double x, y, z;
        std::uint32_t vertex;
    };
    std::vector<Located> located;
    located.reserve(mesh.vertices.size());
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3& p = mesh.vertices[v];
        // An unused vertex may be NaN, which cannot be sorted.
        if (p.allFinite()) located.push_back({p[0], p[1], p[2], v});
    }
    std::sort(located.begin(), located.end(), [](const Located& a, const Located& b) {
        if (a.x != b.x) return a.x < b.x;
        return std::tie(a.y, a.z, a.vertex) < std::tie(b.y, b.z, b.vertex);
    });
    std::vector<std::uint32_t> first(mesh.vertices.size(), UINT32_MAX);
    for (std::size_t i = 0; i < located.size(); ++i) {
        const bool repeats = i > 0 && located[i].x == located[i - 1].x &&
                             located[i].y == located[i - 1].y && located[i].z == located[i - 1].z;
        first[located[i].vertex] = repeats ? first[located[i - 1].vertex] : located[i].vertex;
    }
    return first;
}

}  // namespace scb
