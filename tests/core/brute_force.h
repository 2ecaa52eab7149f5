#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/any_collide.h"
#include "core/leaf_order.h"

namespace scb {

/// Every pair of triangles that intersects, by testing all of them whose boxes meet: the boxes are
/// of the same corners, so this leaves nothing out.
inline std::vector<IndexPair> brute_force(const Mesh& a, const Mesh& b, const Pose& b_to_a) {
    const auto box_of = [](const TriangleCorners& t) {
        Box box;
        for (const Vec3& p : t) box.add(p);
        return box;
    };
    std::vector<TriangleCorners> corners_b;
    std::vector<Box> boxes_b;
    for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
        corners_b.push_back(transform_corners(b_to_a, corners(b, j)));
        boxes_b.push_back(box_of(corners_b.back()));
    }
    std::vector<IndexPair> pairs;
    for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
        const TriangleCorners t = corners(a, i);
        const Box box = box_of(t);
        for (std::uint32_t j = 0; j < corners_b.size(); ++j) {
            const Box& other = boxes_b[j];
            if (box.lower[0] > other.upper[0] || other.lower[0] > box.upper[0] ||
                box.lower[1] > other.upper[1] || other.lower[1] > box.upper[1] ||
                box.lower[2] > other.upper[2] || other.lower[2] > box.upper[2])
                continue;
            if (triangles_overlap(t, corners_b[j])) pairs.push_back({i, j});
        }
    }
    return pairs;
}

/// A mesh with a hierarchy of each kind of volume, in the order of all_volume_kinds.
struct BuiltMesh {
    Mesh mesh;
    std::vector<AnyHierarchy> hierarchies;

    explicit BuiltMesh(const Mesh& m) : BuiltMesh(m, build_topology(m)) {}
    BuiltMesh(const Mesh& m, const Topology& t) : mesh(m) {
        const auto topology = std::make_shared<const Topology>(t);
        const LeafOrder points = leaf_order(mesh, *topology);
        for (const VolumeKind kind : all_volume_kinds())
            hierarchies.push_back(fit_any(kind, topology, points));
    }
    const Topology& topology() const { return topology_of(hierarchies[0]); }
};

/// One way to make a query.
struct QueryVariant {
    std::size_t kind;  ///< index of BuiltMesh::hierarchies
    CollideOptions options;

    VolumeKind volume_kind() const { return all_volume_kinds()[kind]; }
    std::string name() const {
        return std::string(volume_kind_name(volume_kind())) + ", " +
               std::string(overlap_test_name(options.overlap.test)) + ", " +
               std::string(descent_rule_name(options.descent));
    }
};

/// Every kind of volume by every test but the printed one, whose line 8 misses collisions, and by
/// every descent rule.
inline std::vector<QueryVariant> all_query_variants() {
    std::vector<QueryVariant> variants;
    for (std::size_t kind = 0; kind < all_volume_kinds().size(); ++kind)
        for (const OverlapTest test : all_overlap_tests())
            for (const DescentRule rule : all_descent_rules()) {
                const bool is_scb = all_volume_kinds()[kind] == VolumeKind::scb;
                if (is_scb ? test == OverlapTest::printed : test != OverlapTest::corrected)
                    continue;
                QueryVariant variant{kind, {}};
                variant.options.overlap.test = test;
                variant.options.descent = rule;
                variants.push_back(variant);
            }
    return variants;
}

inline Collision query(const BuiltMesh& a, const BuiltMesh& b, const Pose& b_to_a,
                       const QueryVariant& variant) {
    return collide(a.hierarchies[variant.kind], a.mesh, b.hierarchies[variant.kind], b.mesh, b_to_a,
                   variant.options);
}

inline Collision query(const BuiltMesh& a, const BuiltMesh& b, const Pose& b_to_a,
                       const QueryVariant& variant, EventRecorder& recorder) {
    return collide(a.hierarchies[variant.kind], a.mesh, b.hierarchies[variant.kind], b.mesh, b_to_a,
                   variant.options, recorder);
}

}  // namespace scb
