// Bullet: GImpact's trees of quantized boxes. Bullet makes the tests of boxes where nobody can see
// them; what it finds, and the tests of triangles, are recorded.
#include "tests/peers/bullet_body.h"
#include "tests/recordings/recorded_engine.h"

namespace scb {
namespace {

using Index = std::uint32_t;

void record_tree(scb_recorder& recorder, Index tree, const btGImpactBoxSet& boxes) {
    for (int i = 0; i < boxes.getNodeCount(); ++i) {
        btAABB box;
        boxes.getNodeBound(i, box);
        std::vector<double> values;
        for (const btVector3& corner : {box.m_min, box.m_max})
            for (int k = 0; k < 3; ++k) values.push_back(static_cast<double>(corner[k]));
        std::vector<Index> children, items;
        if (boxes.isLeafNode(i))
            items = {static_cast<Index>(boxes.getNodeData(i))};
        else
            children = {static_cast<Index>(boxes.getLeftNode(i)),
                        static_cast<Index>(boxes.getRightNode(i))};
        record_node(recorder, tree, static_cast<Index>(i), children, items, SCB_RECORD_AABB,
                    values);
    }
}

}  // namespace

RecordedQuery record_bullet(scb_recorder& recorder, const PeerMesh& a, const PeerMesh& b) {
    const auto body_a = std::make_shared<BulletBody>(a), body_b = std::make_shared<BulletBody>(b);
    for (const Index i : {0u, 1u}) {
        record_body<float>(recorder, i, i == 0 ? a : b);
        record_tree(recorder, i, (i == 0 ? body_a : body_b)->boxes());
    }
    return [&recorder, body_a, body_b](const PeerPose& at_a, const PeerPose& at_b) {
        const btTransform pose_a = transform(at_a), pose_b = transform(at_b);
        btPairSet candidates;
        btGImpactBoxSet::find_collision(&body_a->boxes(), pose_a, &body_b->boxes(), pose_b,
                                        candidates);
        for (int i = 0; i < candidates.size(); ++i) {
            const auto item_a = static_cast<Index>(candidates[i].m_index1),
                       item_b = static_cast<Index>(candidates[i].m_index2);
            const bool meet = triangles_collide(*body_a, pose_a, *body_b, pose_b, candidates[i]);
            scb_record_items(&recorder, item_a, item_b, meet);
            if (meet) scb_record_pair(&recorder, item_a, item_b);
        }
    };
}

}  // namespace scb
