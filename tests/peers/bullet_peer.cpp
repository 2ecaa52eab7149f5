#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <algorithm>

#include "tests/peers/adapters.h"

namespace scb {
namespace {

/// A mesh in Bullet's numbers, which are floats in Debian's package, and its tree.
class Body {
  public:
    explicit Body(const PeerMesh& mesh) {
        for (const auto& v : mesh.vertices)
            for (const double x : v) vertices_.push_back(static_cast<btScalar>(x));
        for (const auto& t : mesh.triangles)
            for (const std::uint32_t corner : t) corners_.push_back(static_cast<int>(corner));
        mesh_ = std::make_unique<btTriangleIndexVertexArray>(
            static_cast<int>(mesh.triangles.size()), corners_.data(),
            static_cast<int>(3 * sizeof(int)), static_cast<int>(mesh.vertices.size()),
            vertices_.data(), static_cast<int>(3 * sizeof(btScalar)));
        shape_ = std::make_unique<btGImpactMeshShape>(mesh_.get());
        shape_->setMargin(0);  // else triangles that are so near count as colliding
        shape_->updateBound();
        shape_->getMeshPart(0)->lockChildShapes();
    }

    const btGImpactMeshShapePart& part() const { return *shape_->getMeshPart(0); }
    const btGImpactBoxSet& boxes() const { return *shape_->getMeshPart(0)->getBoxSet(); }

  private:
    std::vector<btScalar> vertices_;
    std::vector<int> corners_;
    std::unique_ptr<btTriangleIndexVertexArray> mesh_;
    std::unique_ptr<btGImpactMeshShape> shape_;
};

btTransform transform(const PeerPose& pose) {
    const auto x = [](double value) { return static_cast<btScalar>(value); };
    const auto& r = pose.rotation;
    return btTransform(
        btMatrix3x3(x(r[0][0]), x(r[0][1]), x(r[0][2]), x(r[1][0]), x(r[1][1]), x(r[1][2]),
                    x(r[2][0]), x(r[2][1]), x(r[2][2])),
        btVector3(x(pose.translation[0]), x(pose.translation[1]), x(pose.translation[2])));
}

class BulletPeer : public Peer {
  public:
    BulletPeer(const PeerMesh& a, const PeerMesh& b) : a_(a), b_(b) {}

    /// What GImpact's collision algorithm does, but for the manifold: pairs of boxes, then its
    /// test of two triangles, whose result is contacts.
    void query(const PeerPose& a, const PeerPose& b) override {
        const btTransform at_a = transform(a), at_b = transform(b);
        candidates_.resizeNoInitialize(0);  // keeps its memory
        found_.clear();
        btGImpactBoxSet::find_collision(&a_.boxes(), at_a, &b_.boxes(), at_b, candidates_);
        btPrimitiveTriangle of_a, of_b;
        GIM_TRIANGLE_CONTACT contact;
        for (int i = 0; i < candidates_.size(); ++i) {
            const GIM_PAIR& pair = candidates_[i];
            a_.part().getPrimitiveTriangle(pair.m_index1, of_a);
            b_.part().getPrimitiveTriangle(pair.m_index2, of_b);
            of_a.applyTransform(at_a);
            of_b.applyTransform(at_b);
            of_a.buildTriPlane();
            of_b.buildTriPlane();
            if (of_a.overlap_test_conservative(of_b) &&
                of_a.find_triangle_collision_clip_method(of_b, contact))
                found_.push_back({static_cast<std::uint32_t>(pair.m_index1),
                                  static_cast<std::uint32_t>(pair.m_index2)});
        }
    }

    std::vector<IndexPair> pairs() const override {
        std::vector<IndexPair> pairs = found_;
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    double bytes() const override {
        return static_cast<double>(sizeof(BT_QUANTIZED_BVH_NODE)) *
               (a_.boxes().getNodeCount() + b_.boxes().getNodeCount());
    }

  private:
    Body a_, b_;
    btPairSet candidates_;
    std::vector<IndexPair> found_;
};

}  // namespace

PeerKind bullet_peer() {
    PeerKind kind;
    kind.name = "bullet";
    const int version = btGetVersion();
    kind.title = "Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100) +
                 ", GImpact";
    kind.method =
        "`btGImpactBoxSet::find_collision`, then GImpact's test of two triangles, in "
        "floats and without a margin; that test finds contacts, so it takes some pairs "
        "that only pass near each other for pairs that meet.";
    kind.prepare = [](const PeerMesh& a, const PeerMesh& b) {
        return std::make_unique<BulletPeer>(a, b);
    };
    return kind;
}

}  // namespace scb
