#pragma once

#include <vector>

#include "scb/collide.h"
#include "scb/hierarchy.h"
#include "scb/triangle_overlap.h"

namespace scb {

/// Which pairs of triangles of one mesh count as intersecting: vertices at equal positions are
/// joined (0 and -0 are equal), and triangles that have a joined vertex in common are no pair.
class SelfPairs {
  public:
    /// All of the mesh, which must outlive this, must be finite.
    explicit SelfPairs(const Mesh& mesh);

    bool share_vertex(std::uint32_t i, std::uint32_t j) const;
    /// Whether two triangles that share a vertex come nearer than `tolerance` to each other in any
    /// other place: then it depends on the engine's own rule whether they are a pair.
    bool may_meet_elsewhere(std::uint32_t i, std::uint32_t j, double tolerance) const;
    /// All pairs, i < j, sorted. The hierarchy is of the same mesh.
    std::vector<IndexPair> all(const Hierarchy<Obb>& hierarchy) const;

  private:
    /// The corners of both, the shared ones first, and how many these are.
    std::size_t arrange(std::uint32_t i, std::uint32_t j, TriangleCorners& of_i,
                        TriangleCorners& of_j) const;

    const Mesh& mesh_;
    std::vector<std::uint32_t> joined_;  ///< per vertex
};

}  // namespace scb
