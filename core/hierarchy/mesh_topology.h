#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/geometry/points.h"
#include "scb/hierarchy.h"
#include "scb/topology.h"

namespace scb {

/// The points of a mesh in the order in which the leaves of a topology first use them, equal
/// positions joined to one point (0 and -0 are equal). A node's points are then its own, a
/// contiguous range, and a few with smaller ids, which it shares with triangles left of it. A soup
/// and an indexed mesh of the same triangles have the same points.
struct LeafOrder {
    PointArrays points;  ///< by point id
    std::vector<std::array<std::uint32_t, 3>>
        corners;  ///< point ids per position in Topology::order
    /// Per position in Topology::order, and behind the last: the number of points in the leaves
    /// before it. A node's own points are from own_first[first] to own_first[first + count].
    std::vector<std::uint32_t> own_first;
};

LeafOrder leaf_order(const Mesh& mesh, const Topology& topology);

/// The same; `welded` are the joined_vertices of the mesh.
LeafOrder leaf_order(const Mesh& mesh, const Topology& topology,
                     const std::vector<std::uint32_t>& welded, int threads = 1);

/// The data that all hierarchies of a mesh share, for any volumes.
struct MeshTopology {
    std::shared_ptr<const Topology> topology;
    LeafOrder points;
};

/// `mesh` must satisfy check_mesh. The same for any number of threads.
MeshTopology mesh_topology(const Mesh& mesh, const TopologyOptions& options = {});

/// The same for a mesh and options from outside. Throws InputError, naming the mesh, as check_mesh
/// does, and if the margin is below 0 or not a number.
MeshTopology checked_topology(const Mesh& mesh, const BuildOptions& options, std::string_view name);

}  // namespace scb
