// Bullet's dynamic tree of boxes as a broadphase of opaque objects, here the triangles' boxes in
// the world. Bullet finds the pairs; the tests are a traversal's of one's own: nobody sees
// Bullet's.
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
        for (int t = 0; t < body.part().getPrimitiveManager()->get_primitive_count(); ++t) {
            body.part().getPrimitiveTriangle(t, triangle);
            triangle.applyTransform(at);
            tree.insert(btDbvtVolume::FromPoints(triangle.m_vertices, 3),
                        reinterpret_cast<void*>(std::intptr_t{t}));
        }
    }
    Index number_of(const btDbvtNode* node) {
        return numbers.try_emplace(node, static_cast<Index>(numbers.size())).first->second;
    }
    void record(scb_recorder& recorder, Index number, const btDbvtNode* node) {
        std::vector<double> values;
        for (const btVector3* corner : {&node->volume.Mins(), &node->volume.Maxs()})
            for (int k = 0; k < 3; ++k) values.push_back(static_cast<double>((*corner)[k]));
        std::vector<Index> children, items;
        for (int k = 0; k < 2 && !node->isleaf(); ++k)
            children.push_back(number_of(node->childs[k]));
        if (node->isleaf()) items = {static_cast<Index>(node->dataAsInt)};
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
        scb_record_pair(&recorder, static_cast<Index>(i->dataAsInt),
                        static_cast<Index>(j->dataAsInt));
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
        const btDbvtNode *i = query->sides[0].tree.m_root, *j = query->sides[1].tree.m_root;
        query->test(i, j);
        btDbvt().collideTT(i, j, *query);
    };
}

}  // namespace scb
