#pragma once

#include <cstdint>
#include <vector>

#include "core/base/parallel_for.h"
#include "scb/mesh.h"

namespace scb {

/// What splits look at: the box and the centroid of each triangle of a mesh.
struct Primitives {
    std::vector<Box> boxes;
    std::vector<Vec3> centroids;

    Primitives(const Mesh& mesh, int threads)
        : boxes(mesh.triangles.size()), centroids(mesh.triangles.size()) {
        parallel_blocks(threads, mesh.triangles.size(), [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) {
                const Triangle& t = mesh.triangles[i];
                const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]],
                           &c = mesh.vertices[t[2]];
                boxes[i] = {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
                centroids[i] = (a + b + c) / 3;
            }
        });
    }
};

/// Orders triangles along an axis; their indices break ties.
struct ByCentroid {
    const Primitives& primitives;
    int axis;

    bool operator()(std::uint32_t a, std::uint32_t b) const {
        const double x = primitives.centroids[a][axis], y = primitives.centroids[b][axis];
        return x < y || (x == y && a < b);
    }
};

}  // namespace scb
