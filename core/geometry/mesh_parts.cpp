#include "core/geometry/mesh_parts.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/triangle_pair.h"

namespace scb {

std::vector<Triangle> joined_triangles(const Mesh& mesh) {
    std::vector<bool> used(mesh.vertices.size());
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t) used[v] = true;
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < used.size(); ++v)
        if (used[v]) order.push_back(v);
    const auto before = [&](std::uint32_t i, std::uint32_t j) {
        const Vec3 &p = mesh.vertices[i], &q = mesh.vertices[j];
        return precedes(p, q) || (p == q && i < j);
    };
    std::sort(order.begin(), order.end(), before);
    std::vector<std::uint32_t> place(mesh.vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && mesh.vertices[order[i]] == mesh.vertices[order[i - 1]];
        place[order[i]] = same ? place[order[i - 1]] : order[i];
    }
    std::vector<Triangle> joined;
    joined.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        joined.push_back({place[t[0]], place[t[1]], place[t[2]]});
    return joined;
}

MeshParts mesh_parts(const std::vector<Triangle>& joined, std::size_t vertices) {
    DisjointSets sets(vertices);
    for (const Triangle& t : joined) {
        sets.join(t[0], t[1]);
        sets.join(t[0], t[2]);
    }
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> part_of_set(vertices, none);
    MeshParts parts;
    parts.of_triangle.reserve(joined.size());
    for (const Triangle& t : joined) {
        std::uint32_t& part = part_of_set[sets.find(t[0])];
        if (part == none) part = static_cast<std::uint32_t>(parts.count++);
        parts.of_triangle.push_back(part);
    }
    return parts;
}

std::vector<std::uint32_t> edge_uses(const std::vector<Triangle>& joined) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(3 * joined.size());
    for (const Triangle& t : joined)
        for (std::size_t k = 0; k < 3; ++k) edges.push_back(std::minmax(t[k], t[(k + 1) % 3]));
    std::sort(edges.begin(), edges.end());
    std::vector<std::uint32_t> uses;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i == 0 || edges[i] != edges[i - 1]) uses.push_back(0);
        ++uses.back();
    }
    return uses;
}

bool are_closed(std::vector<Triangle> joined) {
    std::erase_if(joined,
                  [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    const std::vector<std::uint32_t> uses = edge_uses(joined);
    return std::all_of(uses.begin(), uses.end(), [](std::uint32_t n) { return n % 2 == 0; });
}

}  // namespace scb
