#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "scb/pose.h"
#include "scb/topology.h"

namespace scb {

/// A mesh and the shape of a hierarchy of it. Refers, does not own.
struct MeshTree {
    const Mesh& mesh;
    const Topology& topology;
};

/// The corners of all triangles, three of each, in the order of the leaves.
struct PlacedCorners {
    std::string fault;  ///< why there are none, or empty
    std::vector<Vec3> corners;
    double largest_coordinate = 0;

    std::span<const Vec3> below(const TopologyNode& node) const {
        return std::span(corners).subspan(std::size_t{3} * node.first, std::size_t{3} * node.count);
    }
};

/// The corners as stored, or, if there is a pose, as transform_point rounds them. Finds the fault
/// of a mesh that check_mesh refuses, and of a tree whose root has not each triangle once.
PlacedCorners placed_corners(const MeshTree& tree, const Pose* pose);

}  // namespace scb
