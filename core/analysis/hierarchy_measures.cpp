#include "core/analysis/hierarchy_measures.h"

#include "core/analysis/measured_tree-inl.h"

namespace scb {

MeasuredMesh measured_mesh(const Mesh& mesh, const TreeShape& shape, const ItemCorners& corners,
                           const PointArrays& points, int threads) {
    return {node_hulls(shape, corners, points, threads), surface_samples(mesh, epo_samples),
            surface_area(mesh)};
}

MeasuredMesh measured_mesh(const Mesh& mesh, const Topology& topology, const LeafOrder& points,
                           int threads) {
    ItemCorners corners(topology.order.size());
    for (std::size_t i = 0; i < corners.size(); ++i) corners[topology.order[i]] = points.corners[i];
    return measured_mesh(mesh, tree_shape(topology), corners, points.points, threads);
}

HierarchyMeasures hierarchy_measures(const AnyHierarchy& hierarchy, const MeasuredMesh& mesh,
                                     int threads) {
    return std::visit(
        [&]<Volume V>(const Hierarchy<V>& h) {
            const TreeShape shape = tree_shape(*h.topology);
            return MeasuredTree<V>{shape, h.volumes, mesh, threads}.measure();
        },
        hierarchy);
}

namespace {

/// The volume of a node of any tree, for templates.
struct TreeVolume {
    const Tree* tree = nullptr;
    std::uint32_t node = 0;
    double slack = 0;  ///< see enlarged
    VolumeSize size;
    AnyVolume shape;
    Vec3 center = Vec3::Zero();
};

bool contains(const TreeVolume& v, const Vec3& p) {
    return !v.tree->has_volume(v.node) || v.tree->contains(v.node, p, v.slack);
}
double support(const TreeVolume& v, const Vec3& d) {
    return std::visit([&d](const auto& shape) { return support(shape, d); }, v.shape);
}
double surface_area(const TreeVolume& v) { return v.size.area; }
double volume(const TreeVolume& v) { return v.size.volume; }
double diameter(const TreeVolume& v) { return v.size.diameter; }
double thickness(const TreeVolume& v) { return v.size.thickness; }
[[maybe_unused]] double descent_size(const TreeVolume& v) { return v.size.diameter; }

Mat3 box_axes_of(const TreeVolume& v) {
    return std::visit(
        []<class V>(const V& shape) {
            if constexpr (std::is_same_v<V, ConvexShape>)
                return shape.axes;
            else
                return scb::box_axes_of(shape);
        },
        v.shape);
}

TreeVolume enlarged(TreeVolume v, double by) {
    v.slack += by;
    return v;
}

std::vector<TreeVolume> volumes_of(const Tree& tree) {
    std::vector<TreeVolume> volumes(tree.size());
    for (std::uint32_t node = 0; node < tree.size(); ++node) {
        TreeVolume& v = volumes[node];
        v.tree = &tree;
        v.node = node;
        if (!tree.has_volume(node)) continue;
        v.size = tree.volume_size(node);
        v.shape = tree.volume(node);
        v.center = center(v.shape);
    }
    return volumes;
}

}  // namespace

HierarchyMeasures tree_measures(const Tree& tree, const Mesh& mesh, int threads) {
    const std::vector<std::uint32_t> welded = joined_vertices(mesh);
    ItemCorners corners(mesh.triangles.size());
    for (std::size_t t = 0; t < corners.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) corners[t][i] = welded[mesh.triangles[t][i]];
    const std::vector<TreeVolume> volumes = volumes_of(tree);
    const MeasuredMesh measured =
        measured_mesh(mesh, tree.shape(), corners, PointArrays(mesh.vertices), threads);
    return MeasuredTree<TreeVolume>{tree.shape(), volumes, measured, threads}.measure();
}

}  // namespace scb
