#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBB.h>

#include "tests/peers/peer.h"

namespace scb {

using FclModel = fcl::BVHModel<fcl::OBBd>;

template <class Model>
void build(const PeerMesh& mesh, Model& model) {
    std::vector<fcl::Vector3d> vertices;
    for (const auto& v : mesh.vertices) vertices.emplace_back(v[0], v[1], v[2]);
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    model.beginModel();
    model.addSubModel(vertices, triangles);
    model.endModel();
}

inline fcl::Transform3d transform(const PeerPose& pose) {
    fcl::Transform3d result = fcl::Transform3d::Identity();
    for (int i = 0; i < 3; ++i) {
        const auto row = static_cast<std::size_t>(i);
        for (int j = 0; j < 3; ++j)
            result.matrix()(i, j) = pose.rotation[row][static_cast<std::size_t>(j)];
        result.matrix()(i, 3) = pose.translation[row];
    }
    return result;
}

}  // namespace scb
