// Embree: trees that rtcBuildBVH builds of nodes of one's own, and a traversal of one's own, which
// takes for B's box the box about it in A's frame.
#include "tests/peers/embree_tree.h"
#include "tests/recordings/recorded_engine.h"

namespace scb {
namespace {

using Index = std::uint32_t;

/// All below a node, whose boxes it fits.
void record_tree(scb_recorder& recorder, Index tree, EmbreeNode& node, Index& next) {
    node.number = next++;
    std::vector<Index> children, items;
    for (EmbreeNode* child : node.children)
        if (child) {
            record_tree(recorder, tree, *child, next);
            children.push_back(child->number);
            node.box.add(child->box);
        }
    if (children.empty()) items = {node.triangle};
    const Vec3 &l = node.box.lower, &u = node.box.upper;
    record_node(recorder, tree, node.number, children, items, SCB_RECORD_AABB,
                {l[0], l[1], l[2], u[0], u[1], u[2]});
}

struct Traversal {
    scb_recorder& recorder;
    const Mesh &mesh_a, &mesh_b;
    Pose pose;  ///< of B in A's frame

    void visit(const EmbreeNode& a, const EmbreeNode& b) const {
        const Vec3 half = (b.box.upper - b.box.lower) / 2,
                   distance = transform_point(pose, Vec3(b.box.lower + half)) -
                              (a.box.lower + a.box.upper) / 2,
                   reach = (a.box.upper - a.box.lower) / 2 + pose.rotation.cwiseAbs() * half;
        const bool apart = (distance.cwiseAbs().array() > reach.array()).any();
        scb_record_test(&recorder, a.number, b.number, apart);
        if (apart) return;
        if (a.triangle != UINT32_MAX && b.triangle != UINT32_MAX) {
            const bool meet = triangles_overlap(
                corners(mesh_a, a.triangle), transform_corners(pose, corners(mesh_b, b.triangle)));
            scb_record_items(&recorder, a.triangle, b.triangle, meet);
            if (meet) scb_record_pair(&recorder, a.triangle, b.triangle);
            return;
        }
        const bool divide_a =
            b.triangle != UINT32_MAX || (a.triangle == UINT32_MAX && reach.sum() > 2 * half.sum());
        for (const EmbreeNode* child : (divide_a ? a : b).children)
            if (child) visit(divide_a ? *child : a, divide_a ? b : *child);
    }
};

}  // namespace

RecordedQuery record_embree(scb_recorder& recorder, const PeerMesh& a, const PeerMesh& b) {
    const RTCDevice device = rtcNewDevice("threads=1");
    const auto meshes = std::make_shared<std::array<Mesh, 2>>();
    std::array<EmbreeNode*, 2> roots{};
    scb_record_stage(&recorder, 1, "boxes apart");
    for (const Index i : {0u, 1u}) {
        Mesh& mesh = (*meshes)[i];
        mesh = core_mesh(i == 0 ? a : b);
        for (Vec3& vertex : mesh.vertices) vertex = vertex.cast<float>().cast<double>();
        roots[i] = build(device, mesh);
        record_body<float>(recorder, i, i == 0 ? a : b);
        Index next = 0;
        record_tree(recorder, i, *roots[i], next);
    }
    return [&recorder, meshes, roots](const PeerPose& at_a, const PeerPose& at_b) {
        const Pose b_to_a = relative_pose(core_pose(at_a), core_pose(at_b));
        Traversal{recorder, (*meshes)[0], (*meshes)[1], b_to_a}.visit(*roots[0], *roots[1]);
    };
}

}  // namespace scb
