#pragma once

#include <optional>

#include "core/hierarchy/mesh_parity.h"
#include "scb/distance.h"

namespace scb::app {

/// Where a point is relative to a mesh.
struct PointAnswer {
    std::optional<PointSide> side;  ///< none: the mesh is not closed
    Distance nearest;               ///< from the mesh to the point

    /// The distance, negative inside; none if the side is not known.
    std::optional<double> signed_distance() const;
};

/// Answers for the points of a mesh, in its frame.
class PointQueries {
  public:
    /// Refers to the mesh, which must satisfy check_mesh. Builds its hierarchy.
    PointQueries(const Mesh& mesh, const BuildOptions& build);

    /// Whether the mesh is closed, so that points have a side.
    bool is_closed() const { return parity_.has_value(); }
    PointAnswer at(const Vec3& point);

  private:
    const Mesh& mesh_;
    Mesh probe_{{Vec3::Zero()}, {Triangle{0, 0, 0}}};  ///< one triangle that is a point
    Hierarchy<Scb2> hierarchy_, of_probe_;
    std::optional<MeshParity> parity_;
    std::optional<IndexPair> last_;  ///< the closest triangles of the point before
};

}  // namespace scb::app
