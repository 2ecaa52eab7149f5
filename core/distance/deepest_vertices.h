#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/distance/contact_patches.h"
#include "scb/any_hierarchy.h"

namespace scb {

/// A vertex inside another body.
struct DeepVertex {
    std::uint32_t vertex = 0;   ///< the first vertex at its position that a triangle uses
    Vec3 at = Vec3::Zero();     ///< in A's frame
    double depth = 0;           ///< its distance to the nearest triangle of the other body
    std::uint32_t nearest = 0;  ///< this triangle; of several, the lowest
};

/// A mesh with equal corners joined, and where each corner is used.
struct JoinedMesh {
    /// The mesh must satisfy check_mesh. O(n log n).
    explicit JoinedMesh(const Mesh& mesh);

    std::vector<Triangle> triangles;  ///< joined_triangles
    bool is_closed = false;           ///< see are_closed
    /// The triangles with corner v are `users` from `first_user[v]` to before `first_user[v + 1]`.
    std::vector<std::uint32_t> first_user, users;
};

/// A body of a query.
struct PatchBody {
    const Mesh& mesh;
    const JoinedMesh& joined;
    const AnyHierarchy& hierarchy;
    Pose to_a;  ///< from its frame to A's frame; for A itself the identity
};

/// Per patch, the deepest vertex of `inner` that is inside `outer` and belongs to the patch; none
/// if there is no such vertex. `outer` must be closed. `side` is the side of `inner` in `pairs`,
/// which must be all pairs of triangles of the two bodies.
///
/// A vertex belongs to a patch if a walk leads to it from a corner of the patch's triangles, along
/// edges of `inner`, and all vertices of the walk are inside, the corner included. Several patches
/// may own a vertex: of a rod through a plate, both where it enters and where it leaves. Each
/// vertex inside belongs to some patch, unless its whole part of the mesh meets no triangle.
///
/// Sides are exact for the corners as transform_point rounds them into A's frame. Only corners of
/// triangles in pairs are tested: a triangle in no pair does not meet the surface of `outer`, so
/// its corners are all on one side. Depths are rounded as `distance` is. Of vertices of equal
/// depth, the lowest is named. The result is the same for all hierarchies and numbers of threads.
std::vector<std::optional<DeepVertex>> deepest_vertices(const PatchBody& inner,
                                                        const PatchBody& outer, std::size_t side,
                                                        std::span<const IndexPair> pairs,
                                                        std::span<const ContactPatch> patches);

}  // namespace scb
