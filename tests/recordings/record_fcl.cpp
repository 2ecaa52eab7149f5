// FCL: every node of its trees, and every test, by way of a traversal node of one's own.
#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

#include "tests/recordings/fcl_nodes.h"

namespace scb {
namespace {

using Node = fcl::detail::MeshCollisionTraversalNodeOBBd;
using Index = std::uint32_t;

/// FCL calls these two for each test.
struct RecordingNode : Node {
    using Node::BVTesting;
    using Node::leafTesting;
    scb_recorder* recorder = nullptr;

    bool BVTesting(int a, int b) const override {
        const bool apart = Node::BVTesting(a, b);
        scb_record_test(recorder, static_cast<Index>(a), static_cast<Index>(b), apart);
        return apart;
    }
    void leafTesting(int a, int b) const override {
        const std::size_t before = result->numContacts();
        Node::leafTesting(a, b);
        scb_record_items(recorder, triangle_of(*model1, a), triangle_of(*model2, b),
                         result->numContacts() > before);
    }
};

std::vector<double> values_of(const fcl::OBBd& obb) {
    std::vector<double> box(15);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<int>(k);
        box[k] = obb.To[axis];
        for (std::size_t row = 0; row < 3; ++row)
            box[3 + 3 * k + row] = obb.axis(static_cast<int>(row), axis);
        box[12 + k] = obb.extent[axis];
    }
    return box;
}

}  // namespace

RecordedQuery record_fcl(scb_recorder& recorder, const PeerMesh& a, const PeerMesh& b) {
    const auto models = std::make_shared<std::array<FclModel, 2>>();
    scb_record_stage(&recorder, 1, "boxes apart");
    for (const Index i : {0u, 1u})
        record_fcl_body(recorder, i, i == 0 ? a : b, (*models)[i], SCB_RECORD_OBB, values_of);
    return [&recorder, models](const PeerPose& at_a, const PeerPose& at_b) {
        const fcl::CollisionRequestd request(std::numeric_limits<std::size_t>::max());
        fcl::CollisionResultd result;
        RecordingNode node;
        node.recorder = &recorder;
        fcl::detail::initialize<double>(node, (*models)[0], transform(at_a), (*models)[1],
                                        transform(at_b), request, result);
        fcl::detail::collide<double>(&node);
        for (std::size_t i = 0; i < result.numContacts(); ++i)
            scb_record_pair(&recorder, static_cast<Index>(result.getContact(i).b1),
                            static_cast<Index>(result.getContact(i).b2));
    };
}

}  // namespace scb
