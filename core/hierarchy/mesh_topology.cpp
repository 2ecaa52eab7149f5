#include "core/hierarchy/mesh_topology.h"

#include <limits>

#include "core/base/parallel_for.h"
#include "scb/error.h"

namespace scb {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

LeafOrder leaf_order(const Mesh& mesh, const Topology& topology) {
    return leaf_order(mesh, topology, joined_vertices(mesh));
}

LeafOrder leaf_order(const Mesh& mesh, const Topology& topology,
                     const std::vector<std::uint32_t>& welded, int threads) {
    const std::size_t count = mesh.triangles.size();
    LeafOrder result;
    // First vertices, then points. The loops that wait for memory run in threads; the rest is one
    // pass.
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

MeshTopology mesh_topology(const Mesh& mesh, const TopologyOptions& options) {
    MeshTopology result;
    std::vector<std::uint32_t> welded;
    parallel_invoke(
        options.threads,
        [&] { result.topology = std::make_shared<Topology>(build_topology(mesh, options)); },
        [&] { welded = joined_vertices(mesh); });
    result.points = leaf_order(mesh, *result.topology, welded, options.threads);
    return result;
}

MeshTopology checked_topology(const Mesh& mesh, const BuildOptions& options,
                              std::string_view name) {
    check_mesh(mesh, name);
    if (!(options.fit.margin >= 0))
        throw InputError(std::string(name) +
                         ": the margin is below 0 or not a number; give a share of the radius.");
    return mesh_topology(mesh, options.topology());
}

}  // namespace scb
