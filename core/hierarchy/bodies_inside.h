#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "core/geometry/mesh_parts.h"
#include "core/hierarchy/mesh_parity.h"
#include "scb/pose.h"

namespace scb {

/// How much of a body lies inside of another. A part is what common vertices connect.
struct PartsInside {
    std::size_t inside = 0, parts = 0;
    /// Of parts that might lie inside nothing is known, since the other body is not closed.
    bool not_judged = false;
};

/// For two bodies, of which no triangles intersect, which of them lies inside the other.
///
/// A part without contact is inside where one of its vertices is, by MeshParity. A's vertices are
/// taken as they are, B's as transform_point rounds them into A's frame, as in a query: on these
/// numbers the answer is exact.
class BodiesInside {
  public:
    /// The meshes must satisfy check_mesh; refers to them and to the topologies.
    BodiesInside(const Mesh& a, const Topology& of_a, const Mesh& b, const Topology& of_b);

    /// Of A inside B, and of B inside A. O(n log n) the first time that the boxes overlap, then
    /// O(n) where one body is near the other.
    std::array<PartsInside, 2> at(const Pose& b_to_a);

  private:
    struct Side {
        const Mesh* mesh;
        const Topology* topology;
        Box box;
        bool is_closed = false;
        MeshParts parts;
    };
    void prepare();

    std::array<Side, 2> sides_;
    bool prepared_ = false;
    std::optional<MeshParity> parity_of_a_;
};

}  // namespace scb
