#pragma once

#include "scb/mesh.h"
#include "scb/pose.h"
#include "tests/peers/peer.h"

namespace scb {

// Between the types of core and those that adapters get.

inline PeerMesh peer_mesh(const Mesh& mesh) {
    PeerMesh result;
    for (const Vec3& v : mesh.vertices) result.vertices.push_back({v[0], v[1], v[2]});
    result.triangles = mesh.triangles;
    return result;
}

inline Mesh core_mesh(const PeerMesh& mesh) {
    Mesh result;
    for (const auto& v : mesh.vertices) result.vertices.push_back({v[0], v[1], v[2]});
    result.triangles = mesh.triangles;
    return result;
}

inline PeerPose peer_pose(const Pose& pose) {
    PeerPose result;
    for (int i = 0; i < 3; ++i) {
        const auto row = static_cast<std::size_t>(i);
        for (int j = 0; j < 3; ++j)
            result.rotation[row][static_cast<std::size_t>(j)] = pose.rotation(i, j);
        result.translation[row] = pose.translation[i];
    }
    return result;
}

inline Pose core_pose(const PeerPose& pose) {
    Pose result;
    for (int i = 0; i < 3; ++i) {
        const auto row = static_cast<std::size_t>(i);
        for (int j = 0; j < 3; ++j)
            result.rotation(i, j) = pose.rotation[row][static_cast<std::size_t>(j)];
        result.translation[i] = pose.translation[row];
    }
    return result;
}

}  // namespace scb
