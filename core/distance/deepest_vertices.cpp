#include "core/distance/deepest_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "core/base/parallel_for.h"
#include "core/geometry/mesh_parts.h"
#include "core/hierarchy/mesh_parity.h"
#include "scb/distance.h"

namespace scb {
namespace {

using Deepest = std::optional<DeepVertex>;

bool is_deeper(const DeepVertex& v, const Deepest& than) {
    return !than || v.depth > than->depth || (v.depth == than->depth && v.vertex < than->vertex);
}

/// The vertices of one body inside another, in sets that edges connect.
class VerticesInside {
  public:
    VerticesInside(const PatchBody& inner, const PatchBody& outer, std::size_t side,
                   std::span<const IndexPair> pairs)
        : inner_(inner), set_of_(inner.mesh.vertices.size(), not_tested) {
        test_corners(outer, side, pairs);
        for (const std::uint32_t corner : tested_)
            if (set_of_[corner] == inside) flood(corner);
    }

    const std::vector<std::vector<std::uint32_t>>& sets() const { return sets_; }
    /// The sets that have a corner of these triangles, each once.
    std::vector<std::uint32_t> sets_at(const std::vector<std::uint32_t>& triangles) const {
        std::vector<std::uint32_t> found;
        for (const std::uint32_t t : triangles)
            for (const std::uint32_t corner : inner_.joined.triangles[t])
                if (set_of_[corner] < inside) found.push_back(set_of_[corner]);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

  private:
    /// In place of the number of a set: the vertex was not tested, is not inside, or is inside and
    /// in no set so far.
    static constexpr std::uint32_t not_tested = std::numeric_limits<std::uint32_t>::max(),
                                   not_inside = not_tested - 1, inside = not_tested - 2;

    void test_corners(const PatchBody& outer, std::size_t side, std::span<const IndexPair> pairs) {
        for (const IndexPair& pair : pairs)
            for (const std::uint32_t v : inner_.joined.triangles[side == 0 ? pair.a : pair.b])
                tested_.push_back(v);
        std::sort(tested_.begin(), tested_.end());
        tested_.erase(std::unique(tested_.begin(), tested_.end()), tested_.end());
        Mesh placed{outer.mesh.vertices, outer.mesh.triangles};
        for (Vec3& vertex : placed.vertices) vertex = transform_point(outer.to_a, vertex);
        const MeshParity parity(placed, topology_of(outer.hierarchy));
        constexpr std::size_t corners_in_block = 64;
        parallel_blocks(
            processor_count(), tested_.size(),
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    const Vec3 at = transform_point(inner_.to_a, inner_.mesh.vertices[tested_[i]]);
                    set_of_[tested_[i]] = parity.side(at) == PointSide::in ? inside : not_inside;
                }
            },
            corners_in_block);
    }

    /// Makes the set of a vertex. A vertex that was not tested is inside, since the triangle that
    /// leads to it is in no pair.
    void flood(std::uint32_t from) {
        const auto number = static_cast<std::uint32_t>(sets_.size());
        std::vector<std::uint32_t>& set = sets_.emplace_back(1, from);
        set_of_[from] = number;
        const JoinedMesh& joined = inner_.joined;
        for (std::size_t next = 0; next < set.size(); ++next)
            for (std::uint32_t k = joined.first_user[set[next]];
                 k < joined.first_user[set[next] + 1]; ++k)
                for (const std::uint32_t v : joined.triangles[joined.users[k]]) {
                    if (set_of_[v] != inside && set_of_[v] != not_tested) continue;
                    set_of_[v] = number;
                    set.push_back(v);
                }
    }

    const PatchBody& inner_;
    std::vector<std::uint32_t> tested_, set_of_;
    std::vector<std::vector<std::uint32_t>> sets_;
};

/// The deepest of these vertices, which are inside `outer`. The last ones are tested first: a walk
/// from the surface reached them last, so they tend to be deep, and others then end early.
template <Volume V>
Deepest deepest_of(const PatchBody& inner, const PatchBody& outer, const Hierarchy<V>& hierarchy,
                   std::span<const std::uint32_t> vertices) {
    Deepest deepest;
    DistanceOptions options;
    Mesh probe{{Vec3::Zero()}, {Triangle{0, 0, 0}}};  // one triangle that is a point
    for (std::size_t i = vertices.size(); i-- > 0;) {
        const std::uint32_t v = vertices[i];
        const Vec3 at = probe.vertices[0] = transform_point(inner.to_a, inner.mesh.vertices[v]);
        const Hierarchy<V> of_probe = build_hierarchy<V>(probe);
        const Collider<V> point{of_probe, probe}, body{hierarchy, outer.mesh};
        // Most vertices are not the deepest, and any triangle that is near enough shows this.
        options.enough = deepest ? std::nextafter(deepest->depth, -1.0) : -1;
        const Distance found = distance(point, body, outer.to_a, options);
        options.seed = found.triangles;
        const DeepVertex here{v, at, found.found.distance, found.triangles->b};
        if (found.found.distance > options.enough && is_deeper(here, deepest)) deepest = here;
    }
    return deepest;
}

}  // namespace

JoinedMesh::JoinedMesh(const Mesh& mesh)
    : triangles(joined_triangles(mesh)),
      is_closed(are_closed(triangles)),
      first_user(mesh.vertices.size() + 1),
      users(3 * triangles.size()) {
    for (const Triangle& t : triangles)
        for (const std::uint32_t corner : t) ++first_user[corner + 1];
    for (std::size_t v = 1; v < first_user.size(); ++v) first_user[v] += first_user[v - 1];
    std::vector<std::uint32_t> end(first_user.begin(), first_user.end() - 1);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (const std::uint32_t corner : triangles[i]) users[end[corner]++] = i;
}

std::vector<Deepest> deepest_vertices(const PatchBody& inner, const PatchBody& outer,
                                      std::size_t side, std::span<const IndexPair> pairs,
                                      std::span<const ContactPatch> patches) {
    const VerticesInside found(inner, outer, side, pairs);
    std::vector<Deepest> of_sets, of_patches(patches.size());
    for (const std::vector<std::uint32_t>& set : found.sets())
        of_sets.push_back(std::visit(
            [&](const auto& hierarchy) { return deepest_of(inner, outer, hierarchy, set); },
            outer.hierarchy));
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (const std::uint32_t set : found.sets_at(triangles_of(patches[i], pairs, side)))
            if (is_deeper(*of_sets[set], of_patches[i])) of_patches[i] = of_sets[set];
    return of_patches;
}

}  // namespace scb
