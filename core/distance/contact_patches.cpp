#include "core/distance/contact_patches.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel_for.h"
#include "core/geometry/common_area.h"
#include "core/geometry/disjoint_sets.h"
#include "core/geometry/triangle_segment.h"

namespace scb {
namespace {

constexpr std::uint32_t no_number = std::numeric_limits<std::uint32_t>::max();

/// Joins pairs that have a corner of A and a corner of B in common. Per corner of A, the pairs with
/// this corner are listed; of the pairs in a list, each corner of B joins the ones that have it.
DisjointSets joined_pairs(const PatchSide& a, const PatchSide& b,
                          std::span<const IndexPair> pairs) {
    std::vector<std::uint32_t> first(a.mesh.vertices.size() + 1), listed(3 * pairs.size());
    for (const IndexPair& pair : pairs)
        for (const std::uint32_t corner : a.joined[pair.a]) ++first[corner + 1];
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<std::uint32_t> end(first.begin(), first.end() - 1);
    for (std::uint32_t i = 0; i < pairs.size(); ++i)
        for (const std::uint32_t corner : a.joined[pairs[i].a]) listed[end[corner]++] = i;

    DisjointSets sets(pairs.size());
    struct Latest {
        std::uint32_t corner_of_a = no_number, pair = 0;
    };
    std::vector<Latest> latest(b.mesh.vertices.size());
    for (std::uint32_t corner = 0; corner + 1 < first.size(); ++corner)
        for (std::uint32_t k = first[corner]; k < first[corner + 1]; ++k)
            for (const std::uint32_t other : b.joined[pairs[listed[k]].b]) {
                if (latest[other].corner_of_a == corner) sets.join(latest[other].pair, listed[k]);
                latest[other] = {corner, listed[k]};
            }
    return sets;
}

/// The points in which two triangles meet. In one plane, triangles_intersection has only the
/// longest edge.
Box meeting_box(const TriangleCorners& a, const TriangleCorners& b) {
    Box box;
    if (const auto meet = triangles_intersection(a, b)) {
        box.add(meet->a);
        box.add(meet->b);
    }
    for (const Vec3& corner : common_area(a, b)) box.add(corner);
    return box;
}

}  // namespace

std::vector<ContactPatch> contact_patches(const PatchSide& a, const PatchSide& b,
                                          const Pose& b_to_a, std::span<const IndexPair> pairs,
                                          bool is_self) {
    // In a self query, each pair is listed in both orders.
    std::vector<IndexPair> directed(pairs.begin(), pairs.end());
    if (is_self)
        for (const IndexPair& pair : pairs) directed.push_back({pair.b, pair.a});
    DisjointSets sets = joined_pairs(a, b, directed);
    if (is_self)
        for (std::uint32_t i = 0; i < pairs.size(); ++i)
            sets.join(i, i + static_cast<std::uint32_t>(pairs.size()));

    constexpr std::size_t pairs_in_block = 256;
    std::vector<Box> boxes(pairs.size());
    parallel_blocks(
        processor_count(), pairs.size(),
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                boxes[i] = meeting_box(corners(a.mesh, pairs[i].a),
                                       transform_corners(b_to_a, corners(b.mesh, pairs[i].b)));
        },
        pairs_in_block);

    std::vector<std::uint32_t> patch_of_set(directed.size(), no_number);
    std::vector<ContactPatch> patches;
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        std::uint32_t& number = patch_of_set[sets.find(i)];
        if (number == no_number) {
            number = static_cast<std::uint32_t>(patches.size());
            patches.emplace_back();
        }
        patches[number].pairs.push_back(i);
        patches[number].box.add(boxes[i]);
    }
    std::stable_sort(patches.begin(), patches.end(),
                     [](const ContactPatch& x, const ContactPatch& y) {
                         return x.pairs.size() > y.pairs.size();
                     });
    return patches;
}

std::vector<std::uint32_t> triangles_of(const ContactPatch& patch, std::span<const IndexPair> pairs,
                                        std::size_t side) {
    std::vector<std::uint32_t> triangles;
    for (const std::uint32_t i : patch.pairs)
        triangles.push_back(side == 0 ? pairs[i].a : pairs[i].b);
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
}

}  // namespace scb
