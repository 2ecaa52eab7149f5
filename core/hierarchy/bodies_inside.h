#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "core/geometry/mesh_parts.h"
#include "core/hierarchy/mesh_parity.h"
#include "scb/pose.h"

namespace scb {

/// How many parts of a body lie inside another body. Common vertices connect the triangles of a
/// part.
struct PartsInside {
    std::size_t inside = 0, parts = 0;
    /// Whether some parts are not judged: they may lie inside, but the other body is not closed.
    bool not_judged = false;
};

/// Finds whether one of two bodies lies inside the other, if none of their triangles intersect.
///
/// A part without contact is inside if one of its vertices is, by MeshParity. As in a query, A's
/// vertices are used as stored, and B's as transform_point rounds them into A's frame: for these
/// numbers the answer is exact.
class BodiesInside {
  public:
    /// The meshes must satisfy check_mesh. Refers to them and to the topologies.
    BodiesInside(const Mesh& a, const Topology& of_a, const Mesh& b, const Topology& of_b);

    /// A inside B, and B inside A. O(n log n) the first time that the boxes overlap, later O(n) if
    /// they overlap.
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
