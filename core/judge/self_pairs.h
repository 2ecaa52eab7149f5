#pragma once

#include <vector>

#include "scb/collide.h"
#include "scb/hierarchy.h"
#include "scb/triangle_overlap.h"

namespace scb {

/// The pairs of triangles of one mesh that count as intersecting. Vertices at equal positions are
/// joined (0 equals -0), and triangles that share a joined vertex are no pair.
class SelfPairs {
  public:
    /// Both meshes must outlive this object. `rest` is the mesh in the state that decides which
    /// vertices are joined: in a mesh that deforms, separate vertices may meet later. The vertices
    /// of triangles passed to the members must be finite.
    SelfPairs(const Mesh& mesh, const Mesh& rest);
    explicit SelfPairs(const Mesh& mesh) : SelfPairs(mesh, mesh) {}

    /// Whether a corner of one triangle is within `distance` of an unjoined corner of the other. An
    /// engine may or may not have joined the two.
    bool may_share_vertex(std::uint32_t i, std::uint32_t j, double distance) const;
    bool share_vertex(std::uint32_t i, std::uint32_t j) const;
    /// Whether two triangles that share a vertex come within `tolerance` of each other at another
    /// place. Whether they are a pair then depends on the engine's rule.
    bool may_meet_elsewhere(std::uint32_t i, std::uint32_t j, double tolerance) const;
    /// All pairs with i < j, sorted. `hierarchy` must be of the same mesh.
    std::vector<IndexPair> all(const Hierarchy<Obb>& hierarchy) const;

  private:
    /// Fetches the corners of both triangles, shared ones first; returns the number of shared ones.
    std::size_t arrange(std::uint32_t i, std::uint32_t j, TriangleCorners& of_i,
                        TriangleCorners& of_j) const;

    const Mesh& mesh_;
    std::vector<std::uint32_t> joined_;  ///< per vertex
};

}  // namespace scb
