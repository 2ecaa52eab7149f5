#include "core/hierarchy/leaf_order.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/base/parallel_for.h"

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
                     const std::vector<std::uint32_t>& welded, int threads) {
    const std::size_t count = mesh.triangles.size();
    LeafOrder result;
    // Vertices at first, then points. What waits for memory is in threads; the rest is one pass.
    result.corners.resize(count);
    parallel_blocks(threads, count, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k)
            for (std::size_t i = 0; i < 3; ++i)
                result.corners[k][i] = welded[mesh.triangles[topology.order[k]][i]];
    });
    std::vector<std::uint32_t> id(mesh.vertices.size(), none), vertex_of;
    vertex_of.reserve(mesh.vertices.size());
    result.own_first.reserve(count + 1);
    for (auto& corners : result.corners) {
        result.own_first.push_back(static_cast<std::uint32_t>(vertex_of.size()));
        for (std::uint32_t& corner : corners) {
            std::uint32_t& point = id[corner];
            if (point == none) {
                point = static_cast<std::uint32_t>(vertex_of.size());
                vertex_of.push_back(corner);
            }
            corner = point;
        }
    }
    result.own_first.push_back(static_cast<std::uint32_t>(vertex_of.size()));
    PointArrays& points = result.points;
    points.resize(vertex_of.size());
    parallel_blocks(threads, vertex_of.size(), [&](std::size_t first, std::size_t end) {
        for (std::size_t p = first; p < end; ++p) points.set(p, mesh.vertices[vertex_of[p]]);
    });
    return result;
}

}  // namespace scb
