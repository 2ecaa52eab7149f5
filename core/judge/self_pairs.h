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
    /// Both must outlive this. `rest` has the same vertices at the positions that join them: of a
    /// mesh that changes, vertices may meet later that are not one. Vertices of triangles that are
    /// asked for must be finite.
    SelfPairs(const Mesh& mesh, const Mesh& rest);
    explicit SelfPairs(const Mesh& mesh) : SelfPairs(mesh, mesh) {}

    /// Whether a corner of one is nearer than `distance` to a corner of the other, which is not the
    /// same vertex: an engine may have joined the two, or not.
    bool may_share_vertex(std::uint32_t i, std::uint32_t j, double distance) const;
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
