// Bullet's dynamic tree as a broadphase of opaque objects: the triangles' boxes in the world.
// Bullet finds the pairs; the tests are a traversal's of one's own, for nobody sees Bullet's.
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <unordered_map>
#include "tests/peers/bullet_body.h"
#include "tests/recordings/recorded_engine.h"

namespace scb {
namespace {
using Index = std::uint32_t;

struct Objects {
    BulletBody body;
    btDbvt tree{};
    std::unordered_map<const btDbvtNode*, Index> numbers{};

    void place(const btTransform& at) {
        tree.clear();
        numbers.clear();
        btPrimitiveTriangle triangle;
        const int count = body.part().getPrimitiveManager()->get_primitive_count();
        for (std::intptr_t t = 0; t < count; ++t) {
            body.part().getPrimitiveTriangle(static_cast<int>(t), triangle);
            triangle.applyTransform(at);
            const auto box = btDbvtVolume::FromPoints(triangle.m_vertices, 3);
            tree.insert(box, reinterpret_cast<void*>(t));
        }
    }
    Index number_of(const btDbvtNode* node) {
        return numbers.try_emplace(node, static_cast<Index>(numbers.size())).first->second;
    }
    void record(scb_recorder& recorder, Index number, const btDbvtNode* node) {
        const btVector3 &a = node->volume.Mins(), &b = node->volume.Maxs();
        const std::vector<double> values{a[0], a[1], a[2], b[0], b[1], b[2]};
        const std::vector<Index> items(node->isleaf() ? 1 : 0, Index(node->dataAsInt));
        std::vector<Index> children;
        for (int k = 0; k < 2 && !node->isleaf(); ++k)
            children.push_back(number_of(node->childs[k]));
        record_node(recorder, number, number_of(node), children, items, SCB_RECORD_AABB, values);
        for (std::size_t k = 0; k < children.size(); ++k) record(recorder, number, node->childs[k]);
    }
};

struct Query : btDbvt::ICollide {
    scb_recorder& recorder;
    Objects sides[2];
    Query(scb_recorder& r, const PeerMesh& a, const PeerMesh& b)
        : recorder(r), sides{{BulletBody(a)}, {BulletBody(b)}} {}

    void Process(const btDbvtNode* i, const btDbvtNode* j) override {
        scb_record_pair(&recorder, Index(i->dataAsInt), Index(j->dataAsInt));
    }
    void test(const btDbvtNode* i, const btDbvtNode* j) {
        const bool overlap = Intersect(i->volume, j->volume);
        scb_record_test(&recorder, sides[0].number_of(i), sides[1].number_of(j), overlap ? 0 : 1);
        for (int k = 0; k < 2 && overlap && !(i->isleaf() && j->isleaf()); ++k)
            i->isleaf() ? test(i, j->childs[k]) : test(i->childs[k], j);
    }
};

}  // namespace

RecordedQuery record_dbvt(scb_recorder& recorder, const PeerMesh& a, const PeerMesh& b) {
    const auto query = std::make_shared<Query>(recorder, a, b);
    scb_record_stage(&recorder, 1, "boxes apart");
    return [&recorder, query](const PeerPose& at_a, const PeerPose& at_b) {
        for (const Index side : {0u, 1u}) {
            Objects& objects = query->sides[side];
            objects.place(transform(side == 0 ? at_a : at_b));
            scb_record_tree(&recorder, side, side == 0 ? "A" : "B", SCB_RECORD_NONE, nullptr, 0);
            objects.record(recorder, side, objects.tree.m_root);
            scb_record_body(&recorder, side, side == 0 ? "A" : "B", side);
        }
        scb_record_query(&recorder, 0, 1);
        query->test(query->sides[0].tree.m_root, query->sides[1].tree.m_root);
        btDbvt().collideTT(query->sides[0].tree.m_root, query->sides[1].tree.m_root, *query);
    };
}
}  // namespace scb
