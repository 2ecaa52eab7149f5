#include "scenes/recordings/own_contacts.h"

#include <algorithm>

#include "core/distance/distance_certificate.h"
#include "core/judge/query_contacts.h"
#include "core/judge/self_pairs.h"
#include "scb/distance.h"

namespace scb::scenes {
namespace {

/// Erases pairs with a triangle that is not finite.
void erase_broken(std::vector<IndexPair>& pairs, const EngineQuery& query) {
    std::erase_if(pairs, [&query](const IndexPair& pair) {
        return !has_finite_corners(*query.sides[0].mesh, pair.a) ||
               !has_finite_corners(*query.sides[1].mesh, pair.b);
    });
}

}  // namespace

QueryTruth OwnContacts::truth(const EngineQuery& query, const Meshes& meshes) {
    if (!query.placed) return {};
    if (has_object_volumes(query) && query.kind == QueryKind::collide)
        return object_contacts(query);
    if (!meshes[0] || !meshes[1]) return {};
    if (query.self && query.kind != QueryKind::collide) return {};
    if (query.kind == QueryKind::distance) return nearest(query, meshes);
    std::vector<IndexPair> pairs;
    if (query.self)
        pairs = SelfPairs(*meshes[0], query.sides[0].rest ? *query.sides[0].rest : *meshes[0])
                    .all(*hierarchy_of(meshes[0]));
    else if (query.kind == QueryKind::within)
        pairs =
            within(Collider<Obb>{*hierarchy_of(meshes[0]), *meshes[0]},
                   Collider<Obb>{*hierarchy_of(meshes[1]), *meshes[1]}, query.b_to_a, query.limit)
                .pairs;
    else
        pairs = collide(Collider<Obb>{*hierarchy_of(meshes[0]), *meshes[0]},
                        Collider<Obb>{*hierarchy_of(meshes[1]), *meshes[1]}, query.b_to_a)
                    .pairs;
    erase_broken(pairs, query);
    return pairs;
}

QueryTruth OwnContacts::nearest(const EngineQuery& query, const Meshes& meshes) {
    QueryTruth truth;
    const Collider<Obb> a{*hierarchy_of(meshes[0]), *meshes[0]},
        b{*hierarchy_of(meshes[1]), *meshes[1]};
    const Distance found = distance(a, b, query.b_to_a);
    truth.distance = found.found.distance;
    truth.closest = found.triangles;
    // A triangle that is not finite is a point here, and has no distance.
    if (!found.triangles || !has_finite_corners(*query.sides[0].mesh, found.triangles->a) ||
        !has_finite_corners(*query.sides[1].mesh, found.triangles->b))
        return truth;
    truth.pairs = within(a, b, query.b_to_a, truth.distance + query.triangle_tolerance).pairs;
    erase_broken(truth.pairs, query);
    const DistanceCertificate certificate =
        make_certificate(mesh_tree(a), mesh_tree(b), query.b_to_a, *found.triangles);
    truth.certified =
        certifies(check_distance(mesh_tree(a), mesh_tree(b), query.b_to_a, certificate),
                  found.found.distance);
    return truth;
}

std::shared_ptr<const Hierarchy<Obb>> OwnContacts::hierarchy_of(
    const std::shared_ptr<const Mesh>& mesh) {
    if (const auto known = built_.find(mesh.get()); known != built_.end())
        return known->second.hierarchy;
    if (built_.size() >= forget_at_) {
        std::erase_if(built_, [](const auto& built) { return built.second.mesh.use_count() == 1; });
        forget_at_ = std::max<std::size_t>(16, 2 * built_.size());
    }
    auto hierarchy = std::make_shared<const Hierarchy<Obb>>(build_hierarchy<Obb>(*mesh));
    return built_.emplace(mesh.get(), Built{mesh, std::move(hierarchy)}).first->second.hierarchy;
}

}  // namespace scb::scenes
