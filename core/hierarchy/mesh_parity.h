#pragma once

#include <cstdint>
#include <vector>

#include "scb/mesh.h"
#include "scb/topology.h"

namespace scb {

/// The position of a point relative to a closed mesh.
enum class PointSide : std::uint8_t {
    out,
    in,
    on,  ///< exactly on a triangle
};

/// Whether points are inside of a closed mesh, exact on the coordinates given.
///
/// A point is inside if a ray from it crosses an odd number of triangles. So a point in two
/// overlapping shells is outside. The ray goes up along z. A ray through an edge or a vertex is
/// decided as if the point were moved by (e, e^2, 0), for an infinitesimal e > 0: then it meets
/// neither (Edelsbrunner and Mücke, "Simulation of Simplicity", 1990). This applies to points that
/// are on no triangle, so the move does not change their side.
class MeshParity {
  public:
    /// A mesh that is closed (see are_closed) and one of its topologies. Refers to both, and makes
    /// a box for each node. O(n).
    MeshParity(const Mesh& mesh, const Topology& topology);

    PointSide side(const Vec3& point) const;

  private:
    const Mesh& mesh_;
    const Topology& topology_;
    std::vector<Box> boxes_;
};

}  // namespace scb
