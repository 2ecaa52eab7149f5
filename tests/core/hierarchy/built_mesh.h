#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "scb/any_collide.h"

namespace scb {

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
                       const QueryVariant& variant, StepRecorder& recorder) {
    return collide(a.hierarchies[variant.kind], a.mesh, b.hierarchies[variant.kind], b.mesh, b_to_a,
                   variant.options, recorder);
}

}  // namespace scb
