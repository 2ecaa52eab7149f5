#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "core/base/large_pages.h"
#include "core/base/parallel_for.h"
#include "scb/mesh.h"

namespace scb {

/// The box and the centroid of a triangle, for splits; contiguous for vectors of up to eight
/// doubles. The upper corner is negated, so that one minimum joins two boxes.
struct Primitive {
    std::array<double, 3> lower, negated_upper, centroid;

    Box box() const {
        return {{lower[0], lower[1], lower[2]},
                {-negated_upper[0], -negated_upper[1], -negated_upper[2]}};
    }
};

/// The primitives of all triangles of a mesh.
class Primitives {
  public:
    Primitives(const Mesh& mesh, int threads)
        : all_(std::make_unique_for_overwrite<Primitive[]>(mesh.triangles.size())) {
        prefer_large_pages(all_.get(), mesh.triangles.size() * sizeof(Primitive));
        parallel_blocks(threads, mesh.triangles.size(), [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) {
                const Triangle& t = mesh.triangles[i];
                const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]],
                           &c = mesh.vertices[t[2]];
                const Vec3 lower = a.cwiseMin(b).cwiseMin(c), upper = a.cwiseMax(b).cwiseMax(c),
                           centroid = (a + b + c) / 3;
                all_[i] = {{lower[0], lower[1], lower[2]},
                           {-upper[0], -upper[1], -upper[2]},
                           {centroid[0], centroid[1], centroid[2]}};
            }
        });
    }

    const Primitive& operator[](std::uint32_t triangle) const { return all_[triangle]; }

  private:
    std::unique_ptr<Primitive[]> all_;
};

/// Orders triangles along an axis; their indices break ties.
struct ByCentroid {
    const Primitives& primitives;
    std::size_t axis;

    bool operator()(std::uint32_t a, std::uint32_t b) const {
        const double x = primitives[a].centroid[axis], y = primitives[b].centroid[axis];
        return x < y || (x == y && a < b);
    }
};

}  // namespace scb
