#pragma once

#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <memory>

#include "tests/peers/peer.h"

namespace scb {

/// A mesh in Bullet's numbers, which are floats in Debian's package, and its tree.
class BulletBody {
  public:
    explicit BulletBody(const PeerMesh& mesh) {
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

inline btTransform transform(const PeerPose& pose) {
    const auto x = [](double value) { return static_cast<btScalar>(value); };
    const auto& r = pose.rotation;
    return btTransform(
        btMatrix3x3(x(r[0][0]), x(r[0][1]), x(r[0][2]), x(r[1][0]), x(r[1][1]), x(r[1][2]),
                    x(r[2][0]), x(r[2][1]), x(r[2][2])),
        btVector3(x(pose.translation[0]), x(pose.translation[1]), x(pose.translation[2])));
}

/// GImpact's test of two triangles, whose result is contacts.
inline bool triangles_collide(const BulletBody& a, const btTransform& at_a, const BulletBody& b,
                              const btTransform& at_b, const GIM_PAIR& pair) {
    btPrimitiveTriangle of_a, of_b;
    a.part().getPrimitiveTriangle(pair.m_index1, of_a);
    b.part().getPrimitiveTriangle(pair.m_index2, of_b);
    of_a.applyTransform(at_a);
    of_b.applyTransform(at_b);
    of_a.buildTriPlane();
    of_b.buildTriPlane();
    GIM_TRIANGLE_CONTACT contact;
    return of_a.overlap_test_conservative(of_b) &&
           of_a.find_triangle_collision_clip_method(of_b, contact);
}

}  // namespace scb
