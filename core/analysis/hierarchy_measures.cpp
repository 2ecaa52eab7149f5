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

}  // namespace scb
