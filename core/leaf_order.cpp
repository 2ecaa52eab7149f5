#include "core/leaf_order.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace scb {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

std::vector<std::uint32_t> weld(const Mesh& mesh) {
    struct Located {
        double x, y, z;
        std::uint32_t vertex;
    };
    std::vector<Located> located;
    located.reserve(mesh.vertices.size());
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3& p = mesh.vertices[v];
        // An unused vertex may be NaN, which has no place in an order.
        if (p.allFinite()) located.push_back({p[0], p[1], p[2], v});
    }
    std::sort(located.begin(), located.end(), [](const Located& a, const Located& b) {
        if (a.x != b.x) return a.x < b.x;
        return std::tie(a.y, a.z, a.vertex) < std::tie(b.y, b.z, b.vertex);
    });
    std::vector<std::uint32_t> first(mesh.vertices.size(), none);
    for (std::size_t i = 0; i < located.size(); ++i) {
        const bool repeats = i > 0 && located[i].x == located[i - 1].x &&
                             located[i].y == located[i - 1].y && located[i].z == located[i - 1].z;
        first[located[i].vertex] = repeats ? first[located[i - 1].vertex] : located[i].vertex;
    }
    return first;
}

LeafOrder leaf_order(const Mesh& mesh, const Topology& topology) {
    return leaf_order(mesh, topology, weld(mesh));
}

LeafOrder leaf_order(const Mesh& mesh, const Topology& topology,
                     const std::vector<std::uint32_t>& welded) {
    std::vector<std::uint32_t> id(mesh.vertices.size(), none);
    LeafOrder result;
    result.points.reserve(mesh.vertices.size());
    result.corners.reserve(mesh.triangles.size());
    result.own_first.reserve(mesh.triangles.size() + 1);
    for (const std::uint32_t t : topology.order) {
        result.own_first.push_back(static_cast<std::uint32_t>(result.points.size()));
        std::array<std::uint32_t, 3>& corners = result.corners.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = welded[mesh.triangles[t][i]];
            if (id[vertex] == none) {
                id[vertex] = static_cast<std::uint32_t>(result.points.size());
                result.points.push_back(mesh.vertices[vertex]);
            }
            corners[i] = id[vertex];
        }
    }
    result.own_first.push_back(static_cast<std::uint32_t>(result.points.size()));
    return result;
}

}  // namespace scb
