#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/node_hulls.h"
#include "core/geometry/surface.h"
#include "core/model/tree.h"
#include "scb/any_hierarchy.h"

namespace scb {

/// The costs of a test of an inner node and of a leaf, in SAH cost and EPO (Aila, Karras and Laine,
/// Section 2).
inline constexpr double inner_node_cost = 1.2, leaf_cost = 1;

/// Measures of the volumes of one level, or of a whole hierarchy. Lengths are in the mesh's units.
struct LevelMeasures {
    std::uint32_t nodes = 0, leaves = 0;
    double area = 0, volume = 0;  ///< summed
    double hull_volume = 0;       ///< summed over the convex hulls of the points below each node
    /// The summed area of inner nodes and leaves, weighted by their costs, over the root's area:
    /// the surface area heuristic.
    double sah_cost = 0;
    /// End-point overlap: the area of the mesh inside volumes of nodes to which it does not belong,
    /// weighted by their costs, over the area of the mesh.
    double epo = 0;
    /// Nodes whose points lie in no plane (see NodeHulls), and pairs of siblings that are both
    /// solid.
    std::uint32_t solid = 0, solid_siblings = 0;
    /// The volume of the hull over the volume of the bounding volume, mean over the solid nodes; 0
    /// if there are none.
    double tightness = 0;
    /// The volume that two siblings share over the volume of the smaller one, mean over the solid
    /// siblings of this level, and its standard error; 0 if there are none.
    double sibling_overlap = 0, sibling_overlap_error = 0;
    double overlap_volume = 0;  ///< summed over all siblings, each pair once
};

/// Quality measures of a hierarchy. SAH cost, EPO and LCV follow Aila, Karras and Laine, "On
/// Quality Metrics of Bounding Volume Hierarchies", 2013. Samples are always drawn alike: the
/// numbers are the same on every machine and for any number of threads, and comparable between
/// hierarchies of one mesh.
struct HierarchyMeasures {
    std::vector<LevelMeasures> levels;  ///< root first
    LevelMeasures all;
    double surface = 0;    ///< the area of the mesh, in the mesh's units
    double epo_error = 0;  ///< standard error of `all.epo`
    /// The number of leaves that a line meets: the mean, the standard deviation (leaf count
    /// variability), and the standard error of the latter. A line goes through a random point of
    /// the surface in a random direction, both ways without end. It meets a leaf if it meets the
    /// volumes of the leaf and of all nodes above it. (The paper uses the rays of an image.)
    double leaf_count = 0, lcv = 0, lcv_error = 0;
};

/// The number of surface points that sample EPO, and the number of lines, each through one of them.
inline constexpr std::size_t epo_samples = 16384, lcv_lines = 4096;

/// Data for the measures of all hierarchies on one topology of a mesh.
struct MeasuredMesh {
    NodeHulls hulls;
    std::vector<SurfaceSample> samples;
    double surface = 0;
};
MeasuredMesh measured_mesh(const Mesh& mesh, const Topology& topology, const LeafOrder& points,
                           int threads = 1);
/// The same for any tree whose items are the mesh's triangles; `corners` and `points` as in
/// node_hulls.
MeasuredMesh measured_mesh(const Mesh& mesh, const TreeShape& shape, const ItemCorners& corners,
                           const PointArrays& points, int threads = 1);

/// Measures a hierarchy. EPO counts a node if the point is also in the volumes of all nodes above
/// it, since only then a query reaches the node. (Volumes that lie within their parent's need no
/// such rule.) Points outside by less than 1e-9 of the root's diameter count as inside. Volumes
/// thinner than 1e-9 of their diameter share nothing with their siblings.
///
/// Areas and volumes are in closed form and hulls are exact, both up to rounding. For two siblings,
/// `2^18 / nodes of the level` points, at least 64 and at most 4096, are drawn from a box about the
/// smaller one. All pairs of children of a node are siblings, except in nodes with more than 16.
HierarchyMeasures hierarchy_measures(const AnyHierarchy& hierarchy, const MeasuredMesh& mesh,
                                     int threads = 1);

/// The measures of any builder's tree whose items are the triangles of `mesh`. Nodes without a
/// volume contain everything, and have no size.
HierarchyMeasures tree_measures(const Tree& tree, const Mesh& mesh, int threads = 1);

}  // namespace scb
