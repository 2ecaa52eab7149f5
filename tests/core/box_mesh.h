#pragma once

#include "scb/mesh.h"

namespace scb {

/// A box from `lower` to `upper`, of twelve triangles.
inline Mesh box_mesh(const Vec3& lower, const Vec3& upper) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back((i & 1) != 0 ? upper[0] : lower[0],
                                   (i & 2) != 0 ? upper[1] : lower[1],
                                   (i & 4) != 0 ? upper[2] : lower[2]);
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

}  // namespace scb
